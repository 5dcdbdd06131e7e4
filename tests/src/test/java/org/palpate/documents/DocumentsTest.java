package org.palpate.documents;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Checks every page of the checkout. A page says nothing that the sources deny:
 *
 * <ul>
 *   <li>Each relative link and image exists, and each anchor is a heading of its page.
 *   <li>Each block marked {@code java} is an excerpt, in whole lines, of a file in {@code
 *       examples}; {@code docs/library.md} shows each of these files whole. Other code has another
 *       mark.
 *   <li>Each command line of the program parses; in a block it has its required options too. Code
 *       spans are parsed if they begin with {@code ./palpate} or with a command and an option.
 *   <li>Each option, each property {@code -Dpalpate...}, each path from the root or from {@code
 *       native}, and each class in code font exists.
 * </ul>
 */
class DocumentsTest {
  private static final int README_LINES = 150;
  private static final Path README = Path.of("README.md");
  private static final Path CHANGELOG = Path.of("CHANGELOG.md");
  private static final Path LIBRARY = Path.of("docs/library.md");
  private static final Path GLOSSARY = Path.of("docs/glossary.md");

  private static final Pattern PROPERTY = Pattern.compile("-D(palpate\\.[A-Za-z.]*[A-Za-z])");
  private static final Pattern FULL_NAME = Pattern.compile("org\\.palpate(\\.\\w+)+");
  private static final Pattern OPTION = Pattern.compile("(--[a-z][a-z0-9-]*)([ =].*)?");
  private static final Pattern PATH =
      Pattern.compile("(?:core|native|plugin|benchmarks|tests|docs|\\.ci)/[\\w./-]+");
  private static final Pattern CLASS =
      Pattern.compile("((?:[A-Z][a-z0-9]+){2,}|[A-Z][A-Za-z0-9]*Test)(?:\\.(\\w+))?(?:\\(.*\\))?");
  private static final Pattern RENAMED = Pattern.compile("\\| `[^`]+` \\| `([\\w.]+)` \\|");

  /** Words that the glossary avoids and that mean nothing else in these pages. */
  private static final List<String> AVOIDED =
      List.of("openness", "octet", "tally", "near cubes", "box tree", "hop", "device point");

  static Stream<Page> pages() throws IOException {
    List<Page> pages = new ArrayList<>();
    for (Path page : Sources.pages()) {
      pages.add(Page.read(Sources.root().resolve(page)));
    }
    return pages.stream();
  }

  private static boolean is(Page page, Path relative) {
    return page.file().equals(Sources.root().resolve(relative));
  }

  @Test
  void everyPageIsFound() {
    List<Path> pages = Sources.pages();
    assertTrue(pages.containsAll(List.of(README, CHANGELOG, LIBRARY, GLOSSARY)), pages::toString);
    assertTrue(pages.contains(Path.of("CONTRIBUTING.md")), pages::toString);
    assertTrue(pages.contains(Path.of("native/docs/hid-protocol.md")), pages::toString);
  }

  @Test
  void readmeIsShort() throws IOException {
    int lines = Page.read(Sources.root().resolve(README)).length();
    assertTrue(lines <= README_LINES, "README.md has " + lines + " lines");
  }

  @ParameterizedTest
  @MethodSource("pages")
  void linksLeadSomewhere(Page page) throws IOException {
    List<String> faults = new ArrayList<>();
    for (String link : page.links()) {
      if (!link.matches("[a-z]+:.*")) {
        addFaultOfLink(page, link, faults);
      }
    }
    assertEquals(List.of(), faults);
  }

  private static void addFaultOfLink(Page page, String link, List<String> faults)
      throws IOException {
    int hash = link.indexOf('#');
    String path = hash < 0 ? link : link.substring(0, hash);
    Path target = path.isEmpty() ? page.file() : page.file().resolveSibling(path).normalize();
    if (!Files.exists(target)) {
      faults.add("no such file: " + link);
    } else if (hash >= 0 && !Page.read(target).anchors().contains(link.substring(hash + 1))) {
      faults.add("no such heading: " + link);
    }
  }

  @Test
  void everyPageAndPictureIsLinked() throws IOException {
    Set<Path> linked = new TreeSet<>(List.of(README));
    for (Page page : pages().toList()) {
      for (String link : page.links()) {
        Path target = page.file().resolveSibling(link.replaceAll("#.*", "")).normalize();
        if (Files.isRegularFile(target) && !target.equals(page.file())) {
          linked.add(Sources.root().relativize(target));
        }
      }
    }
    Set<Path> all = new TreeSet<>(Sources.pages());
    try (Stream<Path> files = Files.walk(Sources.root().resolve("docs"))) {
      files
          .filter(file -> file.toString().matches(".*\\.(png|svg|jpg)"))
          .forEach(file -> all.add(Sources.root().relativize(file)));
    }
    all.removeAll(linked);
    assertEquals(Set.of(), all);
  }

  @ParameterizedTest
  @MethodSource("pages")
  void blocksOfJavaAreExcerptsOfExamples(Page page) {
    for (Page.Block block : page.blocks()) {
      if (block.language().equals("java")) {
        assertTrue(
            Sources.examples().values().stream()
                .anyMatch(text -> ("\n" + text).contains("\n" + block.text())),
            () -> "not in tests/src/test/java/org/palpate/examples:\n" + block.text());
      }
    }
  }

  @Test
  void libraryShowsEveryExampleWhole() throws IOException {
    List<String> shown =
        Page.read(Sources.root().resolve(LIBRARY)).blocks().stream().map(Page.Block::text).toList();
    Set<String> missing = new TreeSet<>();
    Sources.examples()
        .forEach(
            (name, text) -> {
              if (!shown.contains(text)) {
                missing.add(name);
              }
            });
    assertEquals(Set.of(), missing);
  }

  @ParameterizedTest
  @MethodSource("pages")
  void commandLinesParse(Page page) {
    List<String> faults = new ArrayList<>();
    for (Page.Block block : page.blocks()) {
      CommandLines.of(block.text()).forEach(line -> addFault(line, true, faults));
    }
    for (String span : page.spans()) {
      List<List<String>> lines = CommandLines.of(span);
      lines.forEach(line -> addFault(line, false, faults));
      if (lines.isEmpty() && isCommandWithOption(span)) {
        addFault(CommandLines.words(span), false, faults);
      }
    }
    assertEquals(List.of(), faults);
  }

  private static void addFault(List<String> arguments, boolean whole, List<String> faults) {
    String fault = CommandLines.fault(arguments, whole);
    if (!fault.isEmpty()) {
      faults.add("palpate " + String.join(" ", arguments) + ": " + fault);
    }
  }

  private static boolean isCommandWithOption(String span) {
    return span.matches("\\w+ --.*")
        && CommandLines.isCommand(span.substring(0, span.indexOf(' ')));
  }

  @ParameterizedTest
  @MethodSource("pages")
  void optionsAndPropertiesExist(Page page) {
    Set<String> unknown = new TreeSet<>();
    for (String span : page.spans()) {
      Matcher option = OPTION.matcher(span);
      if (option.matches() && !CommandLines.isOption(option.group(1))) {
        unknown.add(option.group(1));
      }
    }
    Matcher property = PROPERTY.matcher(Sources.read(page.file()));
    while (property.find()) {
      if (!Sources.hasProperty(property.group(1))) {
        unknown.add(property.group());
      }
    }
    assertEquals(Set.of(), unknown);
  }

  @ParameterizedTest
  @MethodSource("pages")
  void namesAndPathsExist(Page page) {
    Set<String> unknown = new TreeSet<>();
    Matcher full = FULL_NAME.matcher(Sources.read(page.file()));
    while (full.find()) {
      if (!Sources.hasName(full.group())) {
        unknown.add(full.group());
      }
    }
    for (String span : page.spans()) {
      if (PATH.matcher(span).matches() && !isPath(span)) {
        unknown.add(span);
      }
      if (!is(page, CHANGELOG) && !isKnownClass(span)) {
        unknown.add(span);
      }
    }
    assertEquals(Set.of(), unknown);
  }

  /** Whether a path exists below the root or a module, or belongs to a build or to no one yet. */
  private static boolean isPath(String path) {
    return path.contains("/target")
        || path.contains("NAME")
        || Files.exists(Sources.root().resolve(path))
        || Files.exists(Sources.root().resolve("native").resolve(path));
  }

  /** Whether a code span is not the name of a class or member, or of one that exists. */
  private static boolean isKnownClass(String span) {
    Matcher name = CLASS.matcher(span);
    if (!name.matches()) {
      return true;
    }
    return Sources.classesNamed(name.group(1)).stream()
        .anyMatch(text -> name.group(2) == null || Sources.mentions(text, name.group(2)));
  }

  @Test
  void namesThatTheChangelogGivesAsNewExist() throws IOException {
    Set<String> unknown = new TreeSet<>();
    for (String line : Page.read(Sources.root().resolve(CHANGELOG)).prose()) {
      Matcher renamed = RENAMED.matcher(line);
      if (renamed.matches() && !Sources.hasName("org.palpate." + renamed.group(1))) {
        unknown.add(renamed.group(1));
      }
    }
    assertEquals(Set.of(), unknown);
  }

  @ParameterizedTest
  @MethodSource("pages")
  void wordsAreThoseOfTheGlossary(Page page) {
    if (is(page, GLOSSARY) || is(page, CHANGELOG)) {
      return;
    }
    Set<String> found = new TreeSet<>();
    String prose = String.join(" ", page.prose()).replaceAll("`[^`]*`", "");
    for (String word : AVOIDED) {
      if (Sources.mentions(prose, word)) {
        found.add(word);
      }
    }
    assertEquals(Set.of(), found);
  }
}
