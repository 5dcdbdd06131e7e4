package org.palpate.rigid;

import org.palpate.geometry.Pose;

/**
 * Finds where a tool is set free that starts in a solid or to which a solid came: a free pose with
 * the orientation kept, at the shortest of a growing series of distances along 26 directions.
 *
 * <p>Allocates nothing. Cost: most poses are ruled out by their first points; a tool that is buried
 * deeply takes some thousand poses. Every tool comes free at last, since all is empty beyond the
 * bodies.
 */
final class FreePoseSearch {
  private static final int DIRECTIONS = 26;

  /** Distances grow by this, edges, or by a part of what they are. */
  private static final double STEP_EDGES = 0.5;

  private static final double GROWTH = 0.02;

  private final ToolVerifier verifier;
  private final double edgeMm;
  private final Pose start = new Pose();
  private final Pose trial = new Pose();

  FreePoseSearch(ToolVerifier verifier, double edgeMm) {
    this.verifier = verifier;
    this.edgeMm = edgeMm;
  }

  /** Places the tool at a free pose near {@code buried}. */
  void find(Pose buried) {
    start.set(buried);
    double distanceMm = STEP_EDGES * edgeMm;
    while (!placeAt(distanceMm)) {
      distanceMm += Math.max(STEP_EDGES * edgeMm, GROWTH * distanceMm);
    }
  }

  private boolean placeAt(double distanceMm) {
    for (int n = 0; n < DIRECTIONS; n++) {
      int code = n < DIRECTIONS / 2 ? n : n + 1; // leaves out the direction 0, 0, 0
      double x = code % 3 - 1;
      double y = code / 3 % 3 - 1;
      double z = code / 9 - 1;
      double scale = distanceMm / Math.sqrt(x * x + y * y + z * z);
      trial.set(start);
      trial.translation.x += scale * x;
      trial.translation.y += scale * y;
      trial.translation.z += scale * z;
      if (verifier.place(trial, true)) {
        return true;
      }
    }
    return false;
  }
}
