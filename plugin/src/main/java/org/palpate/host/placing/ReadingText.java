package org.palpate.host.placing;

import java.util.Locale;
import org.palpate.fracture.PairReadings;
import org.palpate.fracture.Residual;
import org.palpate.fracture.fit.GhostDistance;

/**
 * Readings of fragments in words, to about the digits that they are right to. Each has a fixed
 * number of digits, so that a line in a window does not jump while a fragment moves.
 */
public final class ReadingText {
  private ReadingText() {}

  /**
   * {@return gap, step-off and contact of two fragments that face each other}
   *
   * @param r readings of two fragments that face each other
   */
  public static String of(PairReadings r) {
    String step =
        Double.isNaN(r.stepOffMm())
            ? "no step-off, for want of skin on both sides"
            : String.format(Locale.ROOT, "step-off %.2f mm", r.stepOffMm());
    return String.format(
        Locale.ROOT,
        "gap %.2f mm, at most %.2f; %s; contact on %.0f of %.0f mm^2",
        hundredths(r.gapMeanMm()),
        hundredths(r.gapLargestMm()),
        step,
        r.contactMm2(),
        r.facingMm2());
  }

  /**
   * {@return the distances of a fragment from a ghost}
   *
   * @param d the distances
   */
  public static String of(GhostDistance d) {
    return d.isNear()
        ? String.format(
            Locale.ROOT,
            "distance %.2f mm, 95 %% under %.2f, at most %.2f; read on %.0f %% of its surface",
            d.meanMm(),
            d.mostlyMm(),
            d.largestMm(),
            100 * d.share())
        : String.format(
            Locale.ROOT,
            "no surface that looks the same way within %.0f mm",
            GhostDistance.MOST_MM);
  }

  /** Returns a rounded number; of a small negative one, 0 without a sign. */
  private static double hundredths(double value) {
    return Math.rint(value * 1e2) / 1e2 + 0.0;
  }

  /** Returns a displacement and an angle. */
  static String of(Residual motion) {
    return String.format(
        Locale.ROOT, "%.2f mm, %.1f degrees", motion.distanceMm(), motion.angleDegrees());
  }
}
