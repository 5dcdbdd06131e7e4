package org.palpate.raycast;

import org.palpate.geometry.IntBox;
import org.palpate.volume.BitCube;

/**
 * The exact ray cast without a walk: asks {@link ExactPredicates} of every brick that is not empty
 * and of every solid voxel in it. For rays whose direction has a component too small or too large
 * for a reciprocal. Slow, and right for any six finite doubles.
 */
final class ExhaustiveRayCaster implements RayCaster {
  private final ExactPredicates exact;
  private final RayHit candidate = new RayHit();

  ExhaustiveRayCaster(ExactPredicates exact) {
    this.exact = exact;
  }

  @Override
  public boolean cast(BitCube bits, Ray ray, RayHit hit) {
    IntBox box = bits.bounds();
    int lowX = first(ray.fromX, ray.toX, box.lowX);
    int highX = last(ray.fromX, ray.toX, box.highX);
    int lowY = first(ray.fromY, ray.toY, box.lowY);
    int highY = last(ray.fromY, ray.toY, box.highY);
    int lowZ = first(ray.fromZ, ray.toZ, box.lowZ);
    int highZ = last(ray.fromZ, ray.toZ, box.highZ);
    boolean found = false;
    for (int z = lowZ >> 2; z <= highZ >> 2; z++) {
      for (int y = lowY >> 2; y <= highY >> 2; y++) {
        for (int x = lowX >> 2; x <= highX >> 2; x++) {
          found |= castBrick(bits.brick(x, y, z), x << 2, y << 2, z << 2, ray, hit, found);
        }
      }
    }
    return found;
  }

  private static int first(double from, double to, int low) {
    return (int) Math.max(low, Math.floor(Math.min(from, to)) - 1);
  }

  private static int last(double from, double to, int high) {
    return (int) Math.min(high, Math.floor(Math.max(from, to)) + 1);
  }

  private boolean castBrick(
      long word, int cornerX, int cornerY, int cornerZ, Ray ray, RayHit hit, boolean foundBefore) {
    boolean found = false;
    if (word == 0 || !exact.touchesBox(ray, cornerX, cornerY, cornerZ, 4)) {
      return false;
    }
    for (long rest = word; rest != 0; rest &= rest - 1) {
      int bit = Long.numberOfTrailingZeros(rest);
      int i = cornerX + (bit & 3);
      int j = cornerY + (bit >> 2 & 3);
      int k = cornerZ + (bit >> 4);
      if (exact.touchesVoxel(ray, i, j, k)) {
        enter(ray, i, j, k);
        if (!((foundBefore || found) && hit.t <= candidate.t)) {
          hit.set(candidate);
        }
        found = true;
      }
    }
    return found;
  }

  /**
   * Where the ray enters the voxel: the latest crossing of the three planes that face it. Where all
   * crossings are so early that they round to 0, any plane that the start lies before.
   */
  private void enter(Ray r, int i, int j, int k) {
    candidate.set(0, i, j, k, RayHit.NO_AXIS);
    enterAlong(r.fromX, r.toX, i, 0);
    enterAlong(r.fromY, r.toY, j, 1);
    enterAlong(r.fromZ, r.toZ, k, 2);
  }

  private void enterAlong(double from, double to, int cell, int axis) {
    double plane = to > from ? cell : (double) cell + 1;
    double t = from == to ? 0 : share(plane, from, to);
    boolean startsBefore = to > from ? from < plane : from > plane;
    if (t > candidate.t || (startsBefore && candidate.axis == RayHit.NO_AXIS)) {
      candidate.t = Math.min(t, 1);
      candidate.axis = axis;
    }
  }

  private static double share(double plane, double from, double to) {
    double length = to - from;
    return Double.isInfinite(length)
        ? (plane / 2 - from / 2) / (to / 2 - from / 2)
        : (plane - from) / length;
  }
}
