package org.palpate.realtime;

import java.util.ArrayList;
import java.util.List;

/**
 * The JVM flags that a session should have, and why. The launcher sets them, since a JVM cannot
 * change them itself; this tells whether it did.
 */
public final class RecommendedJvm {
  private static final int ALL = Integer.MAX_VALUE;
  private static final List<Setting> SETTINGS =
      List.of(
          new Setting(
              "-XX:+UseZGC",
              17,
              ALL,
              "its pauses are below a millisecond whatever the heap holds; others stop the haptic"
                  + " thread for as long as they copy"),
          new Setting(
              "-XX:+ZGenerational",
              21,
              22,
              "the collector with generations works less beside the session; later releases have"
                  + " no other"),
          new Setting(
              "-XX:-UsePerfData",
              17,
              ALL,
              "the JVM's statistics are a mapped file, and a pause that updates it can wait for a"
                  + " disk"));

  private RecommendedJvm() {}

  /**
   * A flag.
   *
   * @param flag as it is written
   * @param firstRelease the first Java release that needs it
   * @param lastRelease the last one
   * @param why what it does for a session
   */
  public record Setting(String flag, int firstRelease, int lastRelease, String why) {}

  /** The flags for a Java release, as 17 or 25. */
  public static List<Setting> of(int release) {
    return SETTINGS.stream()
        .filter(s -> release >= s.firstRelease() && release <= s.lastRelease())
        .toList();
  }

  /**
   * Lines for a person: each flag, whether this JVM has it, and why it should.
   *
   * @param release the running Java release
   * @param arguments what the JVM was started with
   */
  public static List<String> explain(int release, List<String> arguments) {
    List<String> lines = new ArrayList<>();
    for (Setting setting : of(release)) {
      String state = arguments.contains(setting.flag()) ? "set" : "missing";
      lines.add(setting.flag() + ": " + state + ": " + setting.why());
    }
    return lines;
  }
}
