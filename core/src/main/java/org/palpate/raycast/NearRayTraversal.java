package org.palpate.raycast;

import org.palpate.volume.BitCube;

/**
 * Traverses a short ray from voxel to voxel. The traversal ends {@link TraversalResult#IN_DOUBT} if
 * the ray starts on a grid plane, if it crosses two planes nearly at once, or if it crosses one
 * nearly at its end.
 *
 * <p>Most casts of a frame are a few voxels long and end here. All state is in local variables,
 * which makes it fast. Coarser levels of the bit cube would not help, because near a surface hardly
 * a brick is empty.
 */
final class NearRayTraversal {
  /** Longer rays are faster in a traversal that skips empty bricks. */
  private static final double MAX_LENGTH_VOXELS = 10;

  private NearRayTraversal() {}

  /** Whether a ray with these components is short enough for this traversal. */
  static boolean isNear(double dx, double dy, double dz) {
    return Math.abs(dx) <= MAX_LENGTH_VOXELS
        && Math.abs(dy) <= MAX_LENGTH_VOXELS
        && Math.abs(dz) <= MAX_LENGTH_VOXELS;
  }

  /**
   * Traverses the ray.
   *
   * @param ray a short ray; each component of its direction is 0 or has a reciprocal, see {@link
   *     ExactRayCaster}
   * @param empty whether a ray among the empty voxels of one brick ends at once
   * @param hit receives the hit if the answer is {@link TraversalResult#HIT}
   */
  static TraversalResult cast(BitCube bits, Ray ray, EmptySpaceSkipper empty, RayHit hit) {
    final double fromX = ray.fromX;
    final double fromY = ray.fromY;
    final double fromZ = ray.fromZ;
    int i = (int) Math.floor(fromX);
    int j = (int) Math.floor(fromY);
    int k = (int) Math.floor(fromZ);
    if (i == fromX || j == fromY || k == fromZ) {
      return TraversalResult.IN_DOUBT;
    }
    long brick = brickOf(bits, i, j, k);
    if (isSolid(brick, i, j, k)) {
      hit.set(0, i, j, k, RayHit.NO_AXIS);
      return TraversalResult.HIT;
    } else if (empty.enabled && staysAmongEmpty(brick, i, j, k, ray)) {
      empty.skippedBricks++;
      return TraversalResult.MISS;
    }
    // A component of 0 has an infinite reciprocal, so that its planes are never crossed.
    final double inverseX = 1 / (ray.toX - fromX);
    final double inverseY = 1 / (ray.toY - fromY);
    final double inverseZ = 1 / (ray.toZ - fromZ);
    final int aheadX = inverseX < 0 ? 0 : 1; // offset from a cell to the plane ahead
    final int aheadY = inverseY < 0 ? 0 : 1;
    final int aheadZ = inverseZ < 0 ? 0 : 1;
    double nextX = (i + aheadX - fromX) * inverseX;
    double nextY = (j + aheadY - fromY) * inverseY;
    double nextZ = (k + aheadZ - fromZ) * inverseZ;
    while (true) {
      int axis = nextX < nextY ? (nextX < nextZ ? 0 : 2) : (nextY < nextZ ? 1 : 2);
      double t = axis == 0 ? nextX : axis == 1 ? nextY : nextZ;
      if (t > 1 + AxisTraversal.doubt(t)) {
        return TraversalResult.MISS;
      }
      if (isInDoubt(t, median(nextX, nextY, nextZ))) {
        return TraversalResult.IN_DOUBT;
      }
      int cellBefore;
      if (axis == 0) {
        cellBefore = i;
        i += 2 * aheadX - 1;
        nextX = (i + aheadX - fromX) * inverseX;
      } else if (axis == 1) {
        cellBefore = j;
        j += 2 * aheadY - 1;
        nextY = (j + aheadY - fromY) * inverseY;
      } else {
        cellBefore = k;
        k += 2 * aheadZ - 1;
        nextZ = (k + aheadZ - fromZ) * inverseZ;
      }
      if (leavesBrick(cellBefore, axis == 0 ? i : axis == 1 ? j : k)) {
        brick = brickOf(bits, i, j, k);
      }
      if (isSolid(brick, i, j, k)) {
        hit.set(t, i, j, k, axis);
        return TraversalResult.HIT;
      }
    }
  }

  /** Whether the plane after this one may come first, or this one may lie behind the ray's end. */
  static boolean isInDoubt(double t, double nextT) {
    double doubt = AxisTraversal.doubt(t);
    return nextT - t <= doubt || t + doubt >= 1;
  }

  /** Returns the median of three crossings: the one after the first. */
  static double median(double a, double b, double c) {
    double low = a < b ? a : b;
    double high = a < b ? b : a;
    return c < low ? low : c < high ? c : high;
  }

  /**
   * Whether the box from the ray's first cell to its last lies in one brick and holds no solid. A
   * ray that starts and ends on no plane then touches none, and no division is needed.
   */
  private static boolean staysAmongEmpty(long brick, int i, int j, int k, Ray ray) {
    int endI = (int) Math.floor(ray.toX);
    int endJ = (int) Math.floor(ray.toY);
    int endK = (int) Math.floor(ray.toZ);
    return ((i ^ endI) | (j ^ endJ) | (k ^ endK)) >>> BitCube.BRICK_SHIFT == 0
        && endI != ray.toX
        && endJ != ray.toY
        && endK != ray.toZ
        && (brick & layersX(i & 3, endI & 3) & layersY(j & 3, endJ & 3) & layersZ(k & 3, endK & 3))
            == 0;
  }

  /** Returns a mask of the voxels between two x layers of a brick, both included, in any order. */
  private static long layersX(int one, int other) {
    return ((2 << Math.max(one, other)) - (1 << Math.min(one, other))) * 0x1111_1111_1111_1111L;
  }

  private static long layersY(int one, int other) {
    int rows = (16 << (Math.max(one, other) << 2)) - (1 << (Math.min(one, other) << 2));
    return rows * 0x0001_0001_0001_0001L;
  }

  private static long layersZ(int one, int other) {
    return -1L >>> ((3 - Math.max(one, other)) << 4) & -1L << (Math.min(one, other) << 4);
  }

  private static boolean leavesBrick(int cellBefore, int cell) {
    return ((cellBefore ^ cell) >>> BitCube.BRICK_SHIFT) != 0;
  }

  private static boolean isSolid(long brick, int i, int j, int k) {
    return ((brick >>> BitCube.bit(i, j, k)) & 1) != 0;
  }

  private static long brickOf(BitCube bits, int i, int j, int k) {
    return bits.brick(i >> BitCube.BRICK_SHIFT, j >> BitCube.BRICK_SHIFT, k >> BitCube.BRICK_SHIFT);
  }
}
