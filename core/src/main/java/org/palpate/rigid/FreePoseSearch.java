package org.palpate.rigid;

import org.palpate.geometry.Pose;

/**
 * Finds a free pose for a tool that collides at its start or after an edit. The orientation is
 * kept. Translations along 26 directions are tried at growing distances, and the first free pose is
 * taken.
 *
 * <p>Haptic thread only; allocates nothing. Most poses are rejected by their first points, and a
 * deep collision takes some thousand poses. The search ends, because all is empty beyond the
 * bodies.
 */
final class FreePoseSearch {
  private static final int DIRECTIONS = 26;

  /** The least difference of two distances, edges. */
  private static final double STEP_EDGES = 0.5;

  /** The least difference of two distances as a part of the distance. */
  private static final double GROWTH = 0.02;

  private final MoverVerifier verifier;
  private final double edgeMm;
  private final Pose start = new Pose();
  private final Pose trial = new Pose();

  FreePoseSearch(MoverVerifier verifier, double edgeMm) {
    this.verifier = verifier;
    this.edgeMm = edgeMm;
  }

  /** Places the tool at a free pose near a colliding one. */
  void find(Pose colliding) {
    start.set(colliding);
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
      verifier.mover.snap(trial);
      if (verifier.place(trial, true)) {
        return true;
      }
    }
    return false;
  }
}
