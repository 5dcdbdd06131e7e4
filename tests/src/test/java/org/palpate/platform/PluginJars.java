package org.palpate.platform;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import org.junit.jupiter.api.Assumptions;

/** Finds the jars that the build of the plug-in makes. */
final class PluginJars {
  private static final Path FOLDER =
      Path.of(System.getProperty("palpate.pluginJars", "../plugin/target"));

  private PluginJars() {}

  static Path thin() {
    return built("Palpate_.jar");
  }

  static Path bundle() {
    return built("Palpate_bundle_.jar");
  }

  static Path updateSite() {
    return FOLDER.resolve("update-site");
  }

  private static Path built(String name) {
    Path jar = FOLDER.resolve(name);
    Assumptions.assumeTrue(
        Files.exists(jar), "skipped: not packed yet, run mvn package: " + jar.toAbsolutePath());
    return jar.toAbsolutePath().normalize();
  }

  /** Returns the names of all files in a jar, in order; throws if one occurs twice. */
  static Set<String> names(Path jar) throws IOException {
    try (ZipFile file = new ZipFile(jar.toFile())) {
      Set<String> names = new TreeSet<>();
      List<String> twice = new ArrayList<>();
      file.stream()
          .filter(entry -> !entry.isDirectory())
          .map(ZipEntry::getName)
          .filter(name -> !names.add(name))
          .forEach(twice::add);
      if (!twice.isEmpty()) {
        throw new IOException("twice in " + jar + ": " + twice);
      }
      return names;
    }
  }

  /** Returns the text of a file in a jar. */
  static String text(Path jar, String name) throws IOException {
    try (ZipFile file = new ZipFile(jar.toFile())) {
      ZipEntry entry = file.getEntry(name);
      if (entry == null) {
        throw new IOException("not in " + jar + ": " + name);
      }
      return new String(
          file.getInputStream(entry).readAllBytes(), java.nio.charset.StandardCharsets.UTF_8);
    }
  }
}
