package org.palpate.rigid;

/**
 * Limits of a step of a tool. They keep the arc of each point near its chord, which is what
 * verification tests. Lengths are in shortest voxel edges of the scene.
 */
final class StepLimits {
  /** The largest deviation of an arc from its chord; {@link Clearance#ofWholeBody} adds it. */
  static final double SAGITTA_EDGES = 1e-3;

  /** The longest path of a point in one step towards contacts. */
  static final double STEP_EDGES = 1.5;

  private StepLimits() {}

  /**
   * Returns the largest rotation of a step, rad. A point at distance r from the axis leaves its
   * chord by at most r (1 - cos(a/2)) for a rotation by a. This is at most r a^2/8.
   *
   * @param radiusMm the largest distance of a point from the reference point
   */
  static double largestTurn(double radiusMm, double edgeMm) {
    return Math.min(0.5, Math.sqrt(8 * SAGITTA_EDGES * edgeMm / Math.max(radiusMm, edgeMm)));
  }
}
