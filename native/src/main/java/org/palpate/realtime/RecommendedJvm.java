package org.palpate.realtime;

import java.util.ArrayList;
import java.util.List;

/**
 * The JVM flags that a session should have, with the reason for each. The launcher sets them,
 * because a JVM cannot change them itself; this class checks whether they are set.
 */
public final class RecommendedJvm {
  private static final int ALL = Integer.MAX_VALUE;
  private static final List<Setting> SETTINGS =
      List.of(
          new Setting(
              "-XX:+UseZGC",
              17,
              ALL,
              "its pauses stay below a millisecond for any heap size; other collectors stop the"
                  + " haptic thread while they copy"),
          new Setting(
              "-XX:+ZGenerational",
              21,
              22,
              "the generational collector does less work during a session; later releases have"
                  + " no other"),
          new Setting(
              "-XX:-UsePerfData",
              17,
              ALL,
              "the JVM's statistics are a mapped file, and a pause that updates it can wait for a"
                  + " disk"),
          new Setting("-XX:CompileCommand=quiet", 17, ALL, "the next flag prints nothing"),
          new Setting(
              "-XX:CompileCommand=dontinline,"
                  + "org.palpate.proxy.smooth.field.CellCorrections::findCorrectedBricks",
              17,
              ALL,
              "rare work of the smooth solver; a compiler that puts it into a frame's code has no"
                  + " room for the frequent work, and some sessions are then slower"));

  private RecommendedJvm() {}

  /**
   * A recommended flag.
   *
   * @param flag the flag as it is written on the command line
   * @param firstRelease the first Java release that needs it
   * @param lastRelease the last Java release that needs it
   * @param why the reason, as a clause
   */
  public record Setting(String flag, int firstRelease, int lastRelease, String why) {}

  /** Returns the flags for a Java release such as 17 or 25. */
  public static List<Setting> of(int release) {
    return SETTINGS.stream()
        .filter(s -> release >= s.firstRelease() && release <= s.lastRelease())
        .toList();
  }

  /**
   * Returns one line for each flag: the flag, whether this JVM has it, and the reason for it.
   *
   * @param release the running Java release
   * @param arguments the arguments that the JVM was started with
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
