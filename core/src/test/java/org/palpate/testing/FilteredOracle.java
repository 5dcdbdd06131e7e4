package org.palpate.testing;

import org.palpate.raycast.Ray;
import org.palpate.volume.BitCube;

/**
 * Decides exactly, and fast enough for millions of legs, whether a segment touches a closed solid
 * voxel. Holds every solid voxel in the segment's box against it by separating directions; if
 * doubles leave a doubt, {@link ExactOracle} decides. Written without a look at the casters and
 * verifiers that it judges: no traversal, no clearance.
 */
public final class FilteredOracle {
  /** Twice the relative error of a difference of two products of differences. */
  private static final double RELATIVE_ERROR = 0x1p-50;

  private static final double UNDERFLOW = 0x1p-900;

  private long doubts;

  /** Returns how often doubles did not suffice. */
  public long doubts() {
    return doubts;
  }

  /** Whether the segment touches any solid voxel. */
  public boolean touchesAny(BitCube bits, Ray ray) {
    int highX = high(ray.fromX, ray.toX, bits.sizeX());
    int highY = high(ray.fromY, ray.toY, bits.sizeY());
    int highZ = high(ray.fromZ, ray.toZ, bits.sizeZ());
    for (int k = low(ray.fromZ, ray.toZ); k <= highZ; k++) {
      for (int j = low(ray.fromY, ray.toY); j <= highY; j++) {
        for (int i = low(ray.fromX, ray.toX); i <= highX; i++) {
          if (bits.get(i, j, k) && touches(ray, i, j, k)) {
            return true;
          }
        }
      }
    }
    return false;
  }

  private static int low(double from, double to) {
    return (int) Math.max(0, Math.ceil(Math.min(from, to)) - 1);
  }

  private static int high(double from, double to, int size) {
    return (int) Math.min(size - 1, Math.floor(Math.max(from, to)));
  }

  private boolean touches(Ray r, int i, int j, int k) {
    int xy = separates(r.fromX, r.fromY, r.toX, r.toY, i, j);
    int yz = separates(r.fromY, r.fromZ, r.toY, r.toZ, j, k);
    int zx = separates(r.fromZ, r.fromX, r.toZ, r.toX, k, i);
    if (xy > 0 || yz > 0 || zx > 0) {
      return false;
    }
    if (xy < 0 && yz < 0 && zx < 0) {
      return true;
    }
    doubts++;
    return ExactOracle.touches(r, i, j, k);
  }

  /** Whether a line of the plane has a closed unit square on one side: 1 yes, -1 no, 0 doubt. */
  private static int separates(double ax, double ay, double bx, double by, int i, int j) {
    int positive = 0;
    int negative = 0;
    for (int corner = 0; corner < 4; corner++) {
      double left = (i + (corner & 1) - ax) * (by - ay);
      double right = (j + (corner >> 1) - ay) * (bx - ax);
      double bound = (Math.abs(left) + Math.abs(right)) * RELATIVE_ERROR + UNDERFLOW;
      positive += left - right > bound ? 1 : 0;
      negative += right - left > bound ? 1 : 0;
    }
    if (positive == 4 || negative == 4) {
      return 1;
    }
    return positive > 0 && negative > 0 ? -1 : 0;
  }
}
