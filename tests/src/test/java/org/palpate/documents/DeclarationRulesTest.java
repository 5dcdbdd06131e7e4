package org.palpate.documents;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;

/** All declarations keep {@link DeclarationRules}. */
class DeclarationRulesTest {
  private static Map<String, String> production(Predicate<String> isWanted) {
    Map<String, String> classes = new TreeMap<>(Sources.classes());
    classes.keySet().removeIf(name -> !Sources.isProduction(name) || !isWanted.test(name));
    return classes;
  }

  /** Whether a class belongs to what other programs call: {@code core} and {@code host}. */
  private static boolean isLibrary(String name) {
    return Sources.isInModule(name, "core") || name.startsWith("org.palpate.host.");
  }

  @Test
  void noNameAndNoTextForUsersHasAWordThatTheGlossaryAvoids() throws IOException {
    assertEquals(
        List.of(), DeclarationRules.faultsOfWords(SourceTrees.of(production(name -> true))));
  }

  @Test
  void everyVisibleMethodOfTheLibraryStatesItsParametersResultAndExceptions() throws IOException {
    Map<String, String> library = production(DeclarationRulesTest::isLibrary);
    assertTrue(library.size() > 400, "classes: " + library.size());
    assertEquals(List.of(), DeclarationRules.faultsOfComments(SourceTrees.of(library)));
  }

  private static List<String> words(String source) throws IOException {
    return DeclarationRules.faultsOfWords(SourceTrees.of(Map.of("a.A", source)));
  }

  private static List<String> comments(String members) throws IOException {
    String source = "package a; /** A. */ public class A {\n" + members + "\n}";
    return DeclarationRules.faultsOfComments(SourceTrees.of(Map.of("a.A", source)));
  }

  @Test
  void plantedWordsAreFoundInTypesMethodsAndTexts() throws IOException {
    assertEquals(List.of("ContactTally: ContactTally"), words("class ContactTally {}"));
    assertEquals(List.of("A: devicePoint"), words("interface A { int devicePoint(int x); }"));
    assertEquals(List.of("B: nearCubes"), words("class A { class B { void nearCubes() {} } }"));
    assertEquals(
        List.of("A: \"the octet is wrong\""),
        words("class A { String s = \"the octet is wrong\"; }"));
    assertEquals(1, words("class A { String s = \"a Twin of it\"; }").size());
  }

  @Test
  void otherWordsKeysAndLongerWordsAreAllowed() throws IOException {
    assertEquals(List.of(), words("class A { void totally() {} enum B { CLIMBS } }"));
    assertEquals(List.of(), words("class A { String key = \"twin\"; String s = \"a shop\"; }"));
    assertEquals(List.of(), words("class A { int devicePointer() { return 1; } }"));
  }

  @Test
  void plantedParametersAndResultsThatAreNotStatedAreFound() throws IOException {
    assertEquals(
        List.of("A.a does not state what it returns"),
        comments("/** Counts. */ public int a() { return 1; }"));
    assertEquals(
        List.of("A.a does not state what it returns"),
        comments("/** Returns one. */ public int a() { return 1; }"));
    assertEquals(
        List.of("A.a does not state x"),
        comments("/** {@return twice a number} */ public static int a(int x) { return 2 * x; }"));
    assertEquals(
        List.of("A.a does not state y"),
        comments("/** Adds.\n * @param x a\n * @param y\n */ protected void a(int x, int y) {}"));
    assertEquals(List.of("A.<init> does not state x"), comments("/** A. */ public A(int x) {}"));
    assertEquals(
        List.of("A.a does not state <T>"), comments("/** Runs. */ public <T> void a() {}"));
    assertEquals(List.of("B does not state <T>"), comments("/** B. */ public interface B<T> {}"));
    assertEquals(
        List.of("B does not state y"),
        comments("/** B.\n * @param x a\n */ public record B(int x, int y) {}"));
    assertEquals(
        List.of("A.<init> does not state z"),
        comments(
            """
            /** B.
             * @param x a */
            public record B(int x) {
              /** B. */ public B(String z) { this(1); }
            }
            """));
  }

  @Test
  void plantedCommentsWithoutTheirExceptionsAreFound() throws IOException {
    assertEquals(List.of("A.a has no comment"), comments("public int a() { return 1; }"));
    assertEquals(List.of("A.a has no comment"), comments("protected void a() {}"));
    assertEquals(
        List.of("A.a does not state when it throws Exception"),
        comments("/** Runs. */ public void a() throws Exception {}"));
    assertEquals(
        List.of("A.a does not state when it throws Exception"),
        comments("/** Runs.\n * @throws Exception\n */ public void a() throws Exception {}"));
    assertEquals(
        List.of("A.a does not state when it throws IllegalStateException"),
        comments("/** Runs. */ public void a() { throw new IllegalStateException(); }"));
    assertEquals(
        List.of("A.<init> does not state when it throws IllegalStateException"),
        comments("/** Begins. */ public A() { throw new IllegalStateException(); }"));
    assertEquals(
        List.of("A.b has no comment"), comments("/** B. */ public interface B { int b(); }"));
  }

  @Test
  void completeCommentsAndMethodsThatAreNotVisibleAreAllowed() throws IOException {
    assertEquals(List.of(), comments("/** {@return one} */ public int a() { return 1; }"));
    assertEquals(
        List.of(),
        comments("/** {@return whether it is} Fast. */ public boolean a() { return true; }"));
    assertEquals(
        List.of(), comments("/** Counts.\n * @return the count\n */ public int a() { return 1; }"));
    assertEquals(
        List.of(),
        comments(
            """
            /**
             * Runs.
             *
             * @param x how often
             * @throws Exception if it fails
             */
            public void a(int x) throws Exception {}
            """));
    assertEquals(
        List.of(),
        comments(
            """
            /** B.
             * @param x a
             * @param <T> its type */
            public record B<T>(T x) {
              static int count;
              /** Checks it. */ public B {}
            }
            """));
    assertEquals(List.of(), comments("@Override public String toString() { return null; }"));
    assertEquals(
        List.of(),
        comments(
            "/** Sets r. */ public void a() { r = () -> { throw new RuntimeException(); }; }"));
    assertEquals(List.of(), comments("int a() { return 1; } static class C { public int c() {} }"));
  }
}
