package org.palpate.benchmarks.jitter.experiment;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Properties;

/**
 * A Java installation.
 *
 * @param home its folder, without links
 * @param release its feature release, such as 17 or 25
 * @param version its full version, such as 17.0.15
 * @param vendor its vendor; empty if unknown
 */
public record Jdk(Path home, int release, String version, String vendor) {

  /**
   * Reads the {@code release} file of an installation, which needs no start of a JVM.
   *
   * @throws IOException if the folder is not a Java installation
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

  /** Returns the {@code java} program. */
  Path java() {
    return home.resolve("bin/java");
  }

  /** Returns the name for a table. */
  public String label() {
    return "jdk" + release;
  }
}
