package org.palpate.host.placing;

import org.palpate.fracture.PairReadings;
import org.palpate.io.file.NumberText;

/** Readings of fragments in words. */
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
            : "step-off " + NumberText.thousandths(r.stepOffMm()) + " mm";
    return "gap "
        + NumberText.thousandths(r.gapMeanMm())
        + " mm, at most "
        + NumberText.thousandths(r.gapLargestMm())
        + "; "
        + step
        + "; contact on "
        + NumberText.thousandths(r.contactMm2())
        + " of "
        + NumberText.thousandths(r.facingMm2())
        + " mm^2";
  }
}
