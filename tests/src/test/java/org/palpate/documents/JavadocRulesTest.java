package org.palpate.documents;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Every Javadoc comment and every page keeps {@link JavadocRules}. */
class JavadocRulesTest {
  /** The beginning of a planted comment, in two pieces, so that this file has no such comment. */
  private static final String OPENING = "/" + "**";

  private static final String LONG =
      "Returns " + "one more word ".repeat(12) + "before this sentence finally ends.";

  @Test
  void everyJavadocCommentKeepsTheRules() {
    List<String> faults = new ArrayList<>();
    for (Map.Entry<String, String> source : Sources.classes().entrySet()) {
      JavadocRules.faultsOfSource(source.getValue())
          .forEach(fault -> faults.add(source.getKey() + ": " + fault));
    }
    assertEquals(List.of(), faults);
  }

  @Test
  void everyPageKeepsTheRules() throws IOException {
    List<String> faults = new ArrayList<>();
    for (Path file : Sources.pages()) {
      Page page = Page.read(Sources.root().resolve(file));
      for (String sentence : page.sentences()) {
        JavadocRules.longSentences(sentence).forEach(fault -> faults.add(file + ": " + fault));
      }
    }
    assertEquals(List.of(), faults);
  }

  @Test
  void plantedFaultsAreFound() {
    assertFault(
        "begins with What", OPENING + " What a share of solid says about height. */ class A {}");
    assertFault(
        "begins with How", OPENING + "\n * How near above the surface the place is.\n */ int a;");
    assertFault(
        "begins with Of", OPENING + " Of many cubes those whose solids may lie there. */ int a;");
    assertFault("words:", "/** Returns a number. " + LONG + " */ int a;");
    assertFault("words:", "/**\n * Returns.\n *\n * @param a " + LONG + "\n */ void a(int a);");
    assertFault("words:", "/** {@return" + LONG.substring("Returns".length()) + "} */ int a();");
  }

  @Test
  void sentencesEndAtParagraphsAndTags() {
    String half = "one more word ".repeat(8).strip();
    assertNoFault("/** Returns " + half + ".\n *\n * <p>Throws " + half + ". */ int a;");
    assertNoFault("/**\n * Returns " + half + "\n *\n * @return " + half + "\n */ int a();");
    assertNoFault("/** {@return " + half + "} Never " + half + ". */ int a();");
    assertNoFault("/** Returns a table. <pre>" + LONG + "</pre> */ int a;");
    assertNoFault("/* What is no Javadoc. */ int a;");
  }

  private static void assertFault(String fault, String source) {
    List<String> faults = JavadocRules.faultsOfSource(source);
    assertEquals(1, faults.size(), source);
    assertTrue(faults.get(0).contains(fault), faults.get(0));
  }

  private static void assertNoFault(String source) {
    assertEquals(List.of(), JavadocRules.faultsOfSource(source));
  }
}
