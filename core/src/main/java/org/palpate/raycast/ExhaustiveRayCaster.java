package org.palpate.raycast;

import org.palpate.geometry.IntBox;
import org.palpate.volume.BitCube;

/**
 * Casts a ray exactly without a traversal: tests every brick that is not empty, and every solid
 * voxel in it, by {@link ExactPredicates}. For rays whose direction has a component that is too
 * small or too large for a reciprocal. Slow, and correct for any six finite doubles.
 */
final class ExhaustiveRayCaster implements RayCaster {
  private final ExactPredicates exact;
  private final RayHit candidate = new RayHit();
  private final RayHit first = new RayHit();

  ExhaustiveRayCaster(ExactPredicates exact) {
    this.exact = exact;
  }

  @Override
  public boolean cast(BitCube bits, Ray ray, RayHit hit) {
    IntBox box = bits.bounds();
    int lowX = lowest(ray.fromX, ray.toX, box.lowX);
    int highX = highest(ray.fromX, ray.toX, box.highX);
    int lowY = lowest(ray.fromY, ray.toY, box.lowY);
    int highY = highest(ray.fromY, ray.toY, box.highY);
    int lowZ = lowest(ray.fromZ, ray.toZ, box.lowZ);
    int highZ = highest(ray.fromZ, ray.toZ, box.highZ);
    first.set(Double.POSITIVE_INFINITY, 0, 0, 0, RayHit.NO_AXIS);
    for (int z = lowZ >> 2; z <= highZ >> 2; z++) {
      for (int y = lowY >> 2; y <= highY >> 2; y++) {
        for (int x = lowX >> 2; x <= highX >> 2; x++) {
          castBrick(bits.brick(x, y, z), x << 2, y << 2, z << 2, ray);
        }
      }
    }
    boolean found = first.t != Double.POSITIVE_INFINITY;
    if (found) {
      hit.set(first);
    }
    return found;
  }

  private static int lowest(double from, double to, int low) {
    return (int) Math.max(low, Math.floor(Math.min(from, to)) - 1);
  }

  private static int highest(double from, double to, int high) {
    return (int) Math.min(high, Math.floor(Math.max(from, to)) + 1);
  }

  /** Keeps the first voxel of the brick that the ray touches if it is the first of all so far. */
  private void castBrick(long word, int cornerX, int cornerY, int cornerZ, Ray ray) {
    if (word == 0 || !exact.touchesBox(ray, cornerX, cornerY, cornerZ, 4)) {
      return;
    }
    for (long rest = word; rest != 0; rest &= rest - 1) {
      int bit = Long.numberOfTrailingZeros(rest);
      int i = cornerX + (bit & 3);
      int j = cornerY + (bit >> 2 & 3);
      int k = cornerZ + (bit >> 4);
      if (exact.touchesVoxel(ray, i, j, k)) {
        enter(ray, i, j, k);
        if (candidate.t < first.t) {
          first.set(candidate);
        }
      }
    }
  }

  /**
   * Sets the candidate to the point where the ray enters the voxel: the latest crossing of the
   * three planes that face the ray. If all crossings are so early that they round to 0, the axis is
   * that of any plane that the start lies before.
   */
  private void enter(Ray r, int i, int j, int k) {
    candidate.set(0, i, j, k, RayHit.NO_AXIS);
    enterAlong(r.fromX, r.toX, i, 0);
    enterAlong(r.fromY, r.toY, j, 1);
    enterAlong(r.fromZ, r.toZ, k, 2);
  }

  private void enterAlong(double from, double to, int cell, int axis) {
    double plane = to > from ? cell : (double) cell + 1;
    double t = from == to ? 0 : crossing(plane, from, to);
    boolean startsBefore = to > from ? from < plane : from > plane;
    if (t > candidate.t || (startsBefore && candidate.axis == RayHit.NO_AXIS)) {
      candidate.t = Math.min(t, 1);
      candidate.axis = axis;
    }
  }

  private static double crossing(double plane, double from, double to) {
    double length = to - from;
    return Double.isInfinite(length)
        ? (plane / 2 - from / 2) / (to / 2 - from / 2)
        : (plane - from) / length;
  }
}
