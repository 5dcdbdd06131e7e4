package org.palpate.benchmarks.jitter.experiment;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;

/** Finds the Java installations of this machine. */
public final class Jdks {
  private static final int OLDEST = 17;

  private Jdks() {}

  /**
   * Returns the newest update of every release from 17 on, by release. It searches the usual
   * folders, {@code JAVA_HOME} and the running JDK.
   */
  public static List<Jdk> found() {
    Map<Integer, Jdk> byRelease = new TreeMap<>();
    candidates().stream()
        .flatMap(home -> installationAt(home).stream())
        .filter(jdk -> jdk.release() >= OLDEST)
        .forEach(jdk -> byRelease.merge(jdk.release(), jdk, Jdks::newer));
    return List.copyOf(byRelease.values());
  }

  private static Optional<Jdk> installationAt(Path home) {
    try {
      return Optional.of(Jdk.at(home));
    } catch (IOException e) {
      return Optional.empty(); // a folder that is not an installation
    }
  }

  private static Jdk newer(Jdk a, Jdk b) {
    Comparator<Jdk> byVersion = Comparator.comparing(jdk -> Runtime.Version.parse(jdk.version()));
    return byVersion.compare(a, b) >= 0 ? a : b;
  }

  private static List<Path> candidates() {
    List<Path> homes = new ArrayList<>();
    homes.add(Path.of(System.getProperty("java.home")));
    String named = System.getenv("JAVA_HOME");
    if (named != null && !named.isEmpty()) {
      homes.add(Path.of(named));
    }
    Path user = Path.of(System.getProperty("user.home"));
    addChildren(homes, Path.of("/usr/lib/jvm"), "");
    addChildren(homes, user.resolve(".sdkman/candidates/java"), "");
    addChildren(homes, user.resolve(".jdks"), "");
    addChildren(homes, Path.of("/Library/Java/JavaVirtualMachines"), "Contents/Home");
    addChildren(homes, Path.of("C:/Program Files/Java"), "");
    addChildren(homes, Path.of("C:/Program Files/Eclipse Adoptium"), "");
    return homes;
  }

  private static void addChildren(List<Path> homes, Path folder, String below) {
    if (!Files.isDirectory(folder)) {
      return;
    }
    try (Stream<Path> children = Files.list(folder)) {
      children.sorted().map(child -> child.resolve(below)).forEach(homes::add);
    } catch (IOException e) {
      // an unreadable folder has no usable installation
    }
  }
}
