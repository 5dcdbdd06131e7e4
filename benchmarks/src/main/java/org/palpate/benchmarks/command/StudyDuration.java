package org.palpate.benchmarks.command;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/**
 * The expected durations of the studies that {@code bench} runs without JMH. The first line of
 * {@code bench} prints them. They were measured in November 2026 on two processors that other
 * processes used too. Those of {@link #RIGID} and {@link #ELASTIC} are processor time. A study that
 * was never timed has the duration NaN.
 */
enum StudyDuration {
  CPP(56, 56),
  STABILITY(1200, 80),
  ACCURACY(605, 61),
  RIGID(2340, 140),
  CARVE(Double.NaN, 60),
  ELASTIC(Double.NaN, 110),
  FRACTURE(Double.NaN, 90),
  HOLD(360, 30),
  GPU(Double.NaN, 90),
  SYNC(83, 22),
  SURFACES(38, 38);

  private static final double STRESS_FRAMES_PER_SECOND = 25_000;

  private final double fullSeconds;
  private final double quickSeconds;

  StudyDuration(double fullSeconds, double quickSeconds) {
    this.fullSeconds = fullSeconds;
    this.quickSeconds = quickSeconds;
  }

  private double seconds(boolean quick) {
    return quick ? quickSeconds : fullSeconds;
  }

  /** Returns the duration of an attack, s. */
  static double stressSeconds(long frames) {
    return frames / STRESS_FRAMES_PER_SECOND;
  }

  /**
   * Returns a duration as text.
   *
   * @param otherSeconds the duration of everything that runs besides these studies, s
   */
  static String text(double otherSeconds, List<StudyDuration> studies, boolean quick) {
    double known =
        studies.stream().mapToDouble(s -> s.seconds(quick)).filter(Double::isFinite).sum();
    String untimed =
        studies.stream()
            .filter(study -> Double.isNaN(study.seconds(quick)))
            .map(study -> "--" + study.name().toLowerCase(Locale.ROOT))
            .collect(Collectors.joining(", "));
    double seconds = otherSeconds + known;
    if (untimed.isEmpty()) {
      return "about " + text(seconds);
    }
    return (seconds > 0 ? "about " + text(seconds) + ", and " : "")
        + "a while that was never timed for "
        + untimed;
  }

  private static String text(double seconds) {
    if (seconds < 90) {
      return Math.max(1, Math.round(seconds)) + " s";
    }
    double minutes = seconds / 60;
    return minutes < 90
        ? Math.round(minutes) + " min"
        : String.format(Locale.ROOT, "%.1f h", minutes / 60);
  }
}
