package org.palpate.force.needle;

import org.palpate.volume.BitCube;

/**
 * A segment that a needle may enter.
 *
 * @param bits its voxels, which do not change
 * @param punctureNewton the force along the needle at which the tip enters it, N
 * @param cuttingNewton the force on the tip while it cuts its way on, N
 * @param shaftNewtonPerMm the friction of each mm of the shaft in it, N/mm
 */
public record NeedleTissue(
    BitCube bits, double punctureNewton, double cuttingNewton, double shaftNewtonPerMm) {

  /** Checks that each figure is finite and at least 0. */
  public NeedleTissue {
    checkRange("punctureNewton", punctureNewton);
    checkRange("cuttingNewton", cuttingNewton);
    checkRange("shaftNewtonPerMm", shaftNewtonPerMm);
  }

  private static void checkRange(String name, double value) {
    if (!(value >= 0 && value < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException(
          name + " must be at least 0 and finite: " + name + "=" + value);
    }
  }
}
