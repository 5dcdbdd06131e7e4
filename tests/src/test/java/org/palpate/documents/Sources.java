package org.palpate.documents;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** The checkout that this test belongs to. */
final class Sources {
  private static final Path ROOT = findRoot();
  private static final List<String> MODULES =
      List.of("core", "native", "plugin", "benchmarks", "tests");

  /** The text of each class by its full name, of tests too. */
  private static final Map<String, String> CLASSES = new TreeMap<>();

  /** The module of each class that is no test, by its full name. */
  private static final Map<String, String> PRODUCTION = new TreeMap<>();

  static {
    readClasses();
  }

  private Sources() {}

  private static Path findRoot() {
    Path folder = Path.of("").toAbsolutePath();
    while (!Files.exists(folder.resolve("palpate")) || !Files.exists(folder.resolve("README.md"))) {
      folder = folder.getParent();
      if (folder == null) {
        throw new IllegalStateException("no checkout around " + Path.of("").toAbsolutePath());
      }
    }
    return folder;
  }

  static Path root() {
    return ROOT;
  }

  /** Returns every page outside hidden folders and folders of builds. */
  static List<Path> pages() {
    return files(ROOT, ".md").stream().map(ROOT::relativize).sorted().toList();
  }

  private static List<Path> files(Path folder, String ending) {
    try (Stream<Path> files = Files.walk(folder)) {
      return files
          .filter(file -> file.toString().endsWith(ending))
          .filter(file -> isSource(ROOT.relativize(file)))
          .toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static boolean isSource(Path relative) {
    for (Path part : relative) {
      if (part.toString().equals("target") || part.toString().startsWith(".")) {
        return false;
      }
    }
    return true;
  }

  private static void readClasses() {
    for (String module : MODULES) {
      for (Path file : files(ROOT.resolve(module), ".java")) {
        String path = file.toString().replace('\\', '/');
        String relative = path.substring(path.lastIndexOf("/org/palpate/") + 1);
        String name = relative.replaceAll("\\.java$", "").replace('/', '.');
        CLASSES.put(name, read(file));
        if (path.contains("/src/main/")) {
          PRODUCTION.put(name, module);
        }
      }
    }
  }

  /** Whether a class is no test. */
  static boolean isProduction(String name) {
    return PRODUCTION.containsKey(name);
  }

  /** Whether a class is no test and belongs to a module. */
  static boolean isInModule(String name, String module) {
    return module.equals(PRODUCTION.get(name));
  }

  /** Returns the text of each class by its full name, of tests too. */
  static Map<String, String> classes() {
    return CLASSES;
  }

  /** Whether a package, a class, or a member of a class has the full name. */
  static boolean hasName(String name) {
    if (CLASSES.containsKey(name)) {
      return true;
    }
    if (CLASSES.keySet().stream().anyMatch(known -> known.startsWith(name + "."))) {
      return true;
    }
    int dot = name.lastIndexOf('.');
    String owner = CLASSES.get(name.substring(0, dot));
    return owner != null && mentions(owner, name.substring(dot + 1));
  }

  /** Returns the texts of all classes of a simple name; empty if there is none. */
  static List<String> classesNamed(String simpleName) {
    return CLASSES.entrySet().stream()
        .filter(entry -> entry.getKey().endsWith("." + simpleName))
        .map(Map.Entry::getValue)
        .toList();
  }

  /** Whether a text contains a word. */
  static boolean mentions(String text, String word) {
    return Pattern.compile("\\b" + Pattern.quote(word) + "\\b").matcher(text).find();
  }

  /** Whether a system property or a Maven property of this name is read anywhere. */
  static boolean hasProperty(String name) {
    return Stream.concat(CLASSES.values().stream(), poms().stream())
        .anyMatch(
            text ->
                text.contains("\"" + name + "\"")
                    || text.contains("${" + name + "}")
                    || text.contains("<name>!" + name + "</name>"));
  }

  private static Collection<String> poms() {
    return files(ROOT, "pom.xml").stream().map(Sources::read).toList();
  }

  /** Returns each example's text after its package line, by its class. */
  static Map<String, String> examples() {
    Map<String, String> examples = new TreeMap<>();
    CLASSES.forEach(
        (name, text) -> {
          String simple = name.substring(name.lastIndexOf('.') + 1);
          boolean example = name.startsWith("org.palpate.examples.");
          if (example && !simple.endsWith("Test") && !simple.equals("package-info")) {
            examples.put(simple, text.substring(text.indexOf(";\n\n") + 3));
          }
        });
    return examples;
  }

  static String read(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
