package org.palpate.benchmarks.jitter.experiment;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Properties;

/**
 * A Java installation.
 *
 * @param home its folder, without links
 * @param release its feature release, as 17 or 25
 * @param version as it calls itself, as 17.0.15
 * @param vendor who built it; empty where it does not say
 */
public record Jdk(Path home, int release, String version, String vendor) {

  /**
   * Reads an installation's own {@code release} file, which costs no start of a JVM.
   *
   * @throws IOException where the folder is none
   */
  public static Jdk at(Path home) throws IOException {
    Path real = home.toRealPath();
    Properties release = new Properties();
    try (var reader = Files.newBufferedReader(real.resolve("release"))) {
      release.load(reader);
    }
    String version = unquoted(release.getProperty("JAVA_VERSION", ""));
    if (version.isEmpty() || !Files.isExecutable(real.resolve("bin/java"))) {
      throw new IOException("no Java installation: " + home);
    }
    return new Jdk(
        real, featureOf(version), version, unquoted(release.getProperty("IMPLEMENTOR", "")));
  }

  private static String unquoted(String value) {
    return value.replace("\"", "").trim();
  }

  private static int featureOf(String version) throws IOException {
    try {
      return Runtime.Version.parse(version).feature();
    } catch (IllegalArgumentException e) {
      throw new IOException("no Java version: " + version, e);
    }
  }

  Path java() {
    return home.resolve("bin/java");
  }

  /** As a table names it. */
  public String label() {
    return "jdk" + release;
  }
}
