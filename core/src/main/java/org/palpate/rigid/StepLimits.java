package org.palpate.rigid;

import org.palpate.geometry.ArcBound;

/**
 * Limits of a step of a mover and of those that it carries along. They keep the arc of each point
 * near its chord, which is what verification tests. Constants are in shortest voxel edges of the
 * scene. Haptic thread only.
 */
final class StepLimits {
  /** The largest deviation of an arc from its chord; {@link Clearance#ofWholeBody} adds it. */
  static final double SAGITTA_EDGES = 1e-3;

  /** The longest path of a point in one step towards contacts. */
  static final double STEP_EDGES = 1.5;

  /** Shortens a step to its limit, against the rounding of a square root. */
  private static final double SHORTER = 1 - 1e-9;

  private final double edgeMm;
  private final double sagittaMm;
  private double largestTurn;
  private double reachMm;
  private boolean hasVoxels;

  /**
   * Creates limits that {@link #set} must complete.
   *
   * @param edgeMm the shortest voxel edge of the scene
   */
  StepLimits(double edgeMm) {
    this.edgeMm = edgeMm;
    sagittaMm = SAGITTA_EDGES * edgeMm;
  }

  /**
   * Sets what moves.
   *
   * @param radiusMm the largest distance of a sample point from the reference point
   * @param voxelReachMm the distance from the reference point within which points of others can
   *     touch the voxels
   * @param movesVoxels whether sample points of others must not touch voxels of it
   */
  void set(double radiusMm, double voxelReachMm, boolean movesVoxels) {
    largestTurn = largestTurn(radiusMm, edgeMm);
    reachMm = voxelReachMm;
    hasVoxels = movesVoxels;
  }

  /**
   * Whether chords cannot stand for the arcs of a step.
   *
   * @param shiftMm the motion of the reference point
   */
  boolean hasLargeArcs(double shiftMm, double turnRad) {
    return turnRad > largestTurn || (hasVoxels && !keepsChords(arcMm(shiftMm, turnRad)));
  }

  /** Returns the largest part of a step, at most 1, whose chords can stand for its arcs. */
  double largestPart(double shiftMm, double turnRad) {
    double part = turnRad > largestTurn ? largestTurn / turnRad : 1;
    double arcMm = hasVoxels ? arcMm(shiftMm, turnRad) : 0;
    return keepsChords(arcMm) ? part : Math.min(part, SHORTER * Math.sqrt(sagittaMm / arcMm));
  }

  /** Whether chords can stand for arcs that deviate from them by some length. */
  boolean keepsChords(double arcMm) {
    return arcMm <= sagittaMm;
  }

  private double arcMm(double shiftMm, double turnRad) {
    return ArcBound.ofTurningBody(shiftMm, turnRad, reachMm + shiftMm);
  }

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
