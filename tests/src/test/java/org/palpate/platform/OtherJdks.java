package org.palpate.platform;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** Finds newer JDKs on this machine. */
final class OtherJdks {
  private static final Path HOMES = Path.of("/usr/lib/jvm");
  private static final int NEW_ENOUGH = 25;

  private OtherJdks() {}

  /** Returns the homes of all JDKs of release 25 or newer in Linux's folder. */
  static List<Path> found() throws IOException {
    if (!Files.isDirectory(HOMES)) {
      return List.of();
    }
    try (Stream<Path> homes = Files.list(HOMES)) {
      return homes
          .filter(home -> Files.isExecutable(home.resolve("bin/java")))
          .filter(home -> release(home) >= NEW_ENOUGH)
          .sorted()
          .toList();
    }
  }

  private static int release(Path home) {
    try (Stream<String> lines = Files.lines(home.resolve("release"))) {
      return lines
          .filter(line -> line.startsWith("JAVA_VERSION="))
          .map(line -> line.replaceAll("\\D*(\\d+).*", "$1"))
          .mapToInt(Integer::parseInt)
          .findFirst()
          .orElse(0);
    } catch (IOException e) {
      return 0;
    }
  }
}
