package org.palpate.platform;

import java.io.File;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;

/** Finds libraries on the class path of this JVM. */
final class ClassPath {
  private ClassPath() {}

  /** Returns the jars of libraries, natives included, by the start of their names. */
  static List<Path> jars(String... artifacts) {
    List<Path> found =
        entries()
            .map(Path::of)
            .filter(path -> Arrays.stream(artifacts).anyMatch(name -> isOf(path, name)))
            .distinct()
            .toList();
    if (found.size() < artifacts.length) {
      throw new IllegalStateException(
          "not all on the class path: " + Arrays.toString(artifacts) + " found " + found);
    }
    return found;
  }

  /** Returns JOGL and GlueGen with their natives. */
  static List<Path> jogamp() {
    return entries()
        .map(Path::of)
        .filter(path -> path.getFileName().toString().matches("(jogl|gluegen)-.*\\.jar"))
        .distinct()
        .toList();
  }

  private static boolean isOf(Path path, String artifact) {
    String name = path.getFileName().toString();
    return name.matches(java.util.regex.Pattern.quote(artifact) + "-[0-9].*\\.jar");
  }

  private static Stream<String> entries() {
    return Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator));
  }
}
