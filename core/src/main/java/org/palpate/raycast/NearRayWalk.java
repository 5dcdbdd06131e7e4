package org.palpate.raycast;

import org.palpate.volume.BitCube;

/**
 * The walk of a short ray from voxel to voxel where nothing is in doubt: no start on a grid plane,
 * no two planes crossed nearly together, none crossed nearly at the ray's end. Says so where
 * something is, and leaves it to the thorough walk.
 *
 * <p>Most casts of a frame are a few voxels long and end here. It keeps all its state in locals,
 * which is what makes it fast; coarser levels would not help, since near a surface hardly a brick
 * is empty.
 */
final class NearRayWalk {
  static final int MISS = 0;
  static final int HIT = 1;
  static final int DOUBT = 2;

  /** Longer rays are better served by a walk that skips empty bricks. */
  private static final double LONGEST_VOXELS = 24;

  private NearRayWalk() {}

  /** Whether the ray is of a length that this walk is for. */
  static boolean isNear(double dx, double dy, double dz) {
    return Math.abs(dx) <= LONGEST_VOXELS
        && Math.abs(dy) <= LONGEST_VOXELS
        && Math.abs(dz) <= LONGEST_VOXELS;
  }

  /**
   * Walks the ray.
   *
   * @param ray of ordinary components, near
   * @param hit filled where the answer is {@link #HIT}
   */
  static int walk(BitCube bits, Ray ray, RayHit hit) {
    final double fromX = ray.fromX;
    final double fromY = ray.fromY;
    final double fromZ = ray.fromZ;
    final double dx = ray.toX - fromX;
    final double dy = ray.toY - fromY;
    final double dz = ray.toZ - fromZ;
    int i = (int) Math.floor(fromX);
    int j = (int) Math.floor(fromY);
    int k = (int) Math.floor(fromZ);
    if (i == fromX || j == fromY || k == fromZ) {
      return DOUBT;
    }
    // A component that is 0 has an infinite reciprocal, and its next plane is crossed at +infinity:
    // never.
    final double inverseX = 1 / dx;
    final double inverseY = 1 / dy;
    final double inverseZ = 1 / dz;
    final int aheadX = dx < 0 ? 0 : 1;
    final int aheadY = dy < 0 ? 0 : 1;
    final int aheadZ = dz < 0 ? 0 : 1;
    double nextX = (i + aheadX - fromX) * inverseX;
    double nextY = (j + aheadY - fromY) * inverseY;
    double nextZ = (k + aheadZ - fromZ) * inverseZ;
    long brick =
        bits.brick(i >> BitCube.BRICK_SHIFT, j >> BitCube.BRICK_SHIFT, k >> BitCube.BRICK_SHIFT);
    if (((brick >>> BitCube.bit(i, j, k)) & 1) != 0) {
      hit.set(0, i, j, k, RayHit.NO_AXIS);
      return HIT;
    }
    while (true) {
      int axis = nextX < nextY ? (nextX < nextZ ? 0 : 2) : (nextY < nextZ ? 1 : 2);
      double t = axis == 0 ? nextX : axis == 1 ? nextY : nextZ;
      double doubt = AxisWalk.doubt(t);
      if (t > 1 + doubt) {
        return MISS;
      }
      int crossed; // not 0 in the bits above a brick where the step leads out of it
      double later;
      if (axis == 0) {
        later = nextY < nextZ ? nextY : nextZ;
        crossed = i;
        i += aheadX + aheadX - 1;
        crossed ^= i;
        nextX = (i + aheadX - fromX) * inverseX;
      } else if (axis == 1) {
        later = nextX < nextZ ? nextX : nextZ;
        crossed = j;
        j += aheadY + aheadY - 1;
        crossed ^= j;
        nextY = (j + aheadY - fromY) * inverseY;
      } else {
        later = nextX < nextY ? nextX : nextY;
        crossed = k;
        k += aheadZ + aheadZ - 1;
        crossed ^= k;
        nextZ = (k + aheadZ - fromZ) * inverseZ;
      }
      if (later - t <= doubt || t + doubt >= 1) {
        return DOUBT;
      }
      if (crossed >>> BitCube.BRICK_SHIFT != 0) {
        brick =
            bits.brick(
                i >> BitCube.BRICK_SHIFT, j >> BitCube.BRICK_SHIFT, k >> BitCube.BRICK_SHIFT);
      }
      if (((brick >>> BitCube.bit(i, j, k)) & 1) != 0) {
        hit.set(t, i, j, k, axis);
        return HIT;
      }
    }
  }
}
