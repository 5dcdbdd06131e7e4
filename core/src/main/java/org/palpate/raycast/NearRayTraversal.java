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
final class NearRayTraversal {
  static final int MISS = 0;
  static final int HIT = 1;
  static final int DOUBT = 2;

  /** Longer rays are better served by a walk that skips empty bricks. */
  private static final double LONGEST_VOXELS = 10;

  private NearRayTraversal() {}

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
   * @param empty whether a ray among empty voxels of one brick is not walked
   * @param hit filled where the answer is {@link #HIT}
   */
  static int walk(BitCube bits, Ray ray, EmptySpaceSkipper empty, RayHit hit) {
    final double fromX = ray.fromX;
    final double fromY = ray.fromY;
    final double fromZ = ray.fromZ;
    int i = (int) Math.floor(fromX);
    int j = (int) Math.floor(fromY);
    int k = (int) Math.floor(fromZ);
    if (i == fromX || j == fromY || k == fromZ) {
      return DOUBT;
    }
    long brick = brickOf(bits, i, j, k);
    if (isSolid(brick, i, j, k)) {
      hit.set(0, i, j, k, RayHit.NO_AXIS);
      return HIT;
    } else if (empty.on && staysAmongEmpty(brick, i, j, k, ray)) {
      empty.bricks++;
      return MISS;
    }
    // Of a component that is 0 the reciprocal is infinite, and the next plane crossed there: never.
    final double inverseX = 1 / (ray.toX - fromX);
    final double inverseY = 1 / (ray.toY - fromY);
    final double inverseZ = 1 / (ray.toZ - fromZ);
    final int aheadX = inverseX < 0 ? 0 : 1; // from a cell's number to that of the plane ahead
    final int aheadY = inverseY < 0 ? 0 : 1;
    final int aheadZ = inverseZ < 0 ? 0 : 1;
    double nextX = (i + aheadX - fromX) * inverseX;
    double nextY = (j + aheadY - fromY) * inverseY;
    double nextZ = (k + aheadZ - fromZ) * inverseZ;
    while (true) {
      int axis = nextX < nextY ? (nextX < nextZ ? 0 : 2) : (nextY < nextZ ? 1 : 2);
      double t = axis == 0 ? nextX : axis == 1 ? nextY : nextZ;
      if (t > 1 + AxisTraversal.doubt(t)) {
        return MISS;
      }
      if (isInDoubt(t, median(nextX, nextY, nextZ))) {
        return DOUBT;
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
        return HIT;
      }
    }
  }

  /** Whether the next plane may be crossed before this one, or this one behind the ray's end. */
  static boolean isInDoubt(double t, double nextT) {
    double doubt = AxisTraversal.doubt(t);
    return nextT - t <= doubt || t + doubt >= 1;
  }

  static double median(double a, double b, double c) {
    double low = a < b ? a : b;
    double high = a < b ? b : a;
    return c < low ? low : c < high ? c : high;
  }

  /**
   * Whether the box from the ray's first cell to its last lies in one brick and holds no solid:
   * then the ray, which starts and ends on no plane, touches none, and nothing is divided.
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

  /** The voxels of a brick from one layer across x to another, both included, in either order. */
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
