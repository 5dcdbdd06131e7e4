package org.palpate.benchmarks.hold;

import java.util.List;
import java.util.Optional;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;

/** The part of a fragment that is seen from below, among the other fragments of a bone. */
final class Underside {
  private static final int NOT_SEEN = -1;

  /** The voxels to each side of a place, and the steps between them, that a flat place allows. */
  private static final int FLAT_VOXELS = 2;

  private final List<BitCube> fragments;
  private final BitCube fragment;
  private final IntBox box;

  /**
   * Creates the underside of a fragment.
   *
   * @param fragments the voxels of all fragments, on one grid
   * @param index of the fragment
   */
  Underside(List<BitCube> fragments, int index) {
    this.fragments = fragments;
    fragment = fragments.get(index);
    box = fragment.bounds();
  }

  /** Returns the flat place that is nearest to the middle of the fragment, in grid coordinates. */
  Optional<Vec3> flatPlace() {
    Vec3 best = null;
    double bestSquare = Double.POSITIVE_INFINITY;
    for (int j = box.lowY; j <= box.highY; j++) {
      for (int i = box.lowX; i <= box.highX; i++) {
        double square = squareFromMiddle(i, j);
        if (square < bestSquare && isFlat(i, j)) {
          bestSquare = square;
          best = new Vec3(i + 0.5, j + 0.5, height(i, j));
        }
      }
    }
    return Optional.ofNullable(best);
  }

  private double squareFromMiddle(int i, int j) {
    double x = i - 0.5 * (box.lowX + box.highX);
    double y = j - 0.5 * (box.lowY + box.highY);
    return x * x + y * y;
  }

  private boolean isFlat(int i, int j) {
    int height = height(i, j);
    boolean flat = height != NOT_SEEN;
    for (int n = 0; flat && n < 9; n++) {
      int beside = height(i + FLAT_VOXELS * (n % 3 - 1), j + FLAT_VOXELS * (n / 3 - 1));
      flat = beside != NOT_SEEN && Math.abs(beside - height) <= FLAT_VOXELS;
    }
    return flat;
  }

  /** Returns the lowest voxel of a column; {@link #NOT_SEEN} if it is not of the fragment. */
  private int height(int i, int j) {
    for (int k = 0; k < fragment.sizeZ(); k++) {
      if (fragment.get(i, j, k)) {
        return k;
      }
      if (isOther(i, j, k)) {
        return NOT_SEEN;
      }
    }
    return NOT_SEEN;
  }

  private boolean isOther(int i, int j, int k) {
    for (BitCube other : fragments) {
      if (other != fragment && other.get(i, j, k)) {
        return true;
      }
    }
    return false;
  }
}
