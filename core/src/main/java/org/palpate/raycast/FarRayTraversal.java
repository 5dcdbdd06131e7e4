package org.palpate.raycast;

import org.palpate.geometry.IntBox;
import org.palpate.volume.BitCube;

/**
 * The walk of a ray of any length where nothing is in doubt: from voxel to voxel in bricks that
 * hold solids, past empty bricks and empty blocks of bricks in one step. Says so where something is
 * in doubt, and leaves it to the thorough walk.
 *
 * <p>In doubt is a start on a grid plane, two planes crossed nearly together, one crossed nearly at
 * the ray's end, and a place nearly on a plane after a step that is longer than a voxel. All state
 * is in locals, which is what makes it fast: half the time of the thorough walk, whose state is in
 * objects.
 */
final class FarRayTraversal {
  /** Up to here a place on the ray is computed to within {@link #PLACE_DOUBT} by far. */
  private static final double FARTHEST_VOXELS = 1 << 20;

  /** A place so near to a grid plane may lie on either side of it, voxels. */
  private static final double PLACE_DOUBT = 0x1p-24;

  private FarRayTraversal() {}

  /** Whether all coordinates are small enough for this walk. */
  static boolean isWithinReach(Ray r) {
    return isWithinReach(r.fromX, r.fromY, r.fromZ) && isWithinReach(r.toX, r.toY, r.toZ);
  }

  private static boolean isWithinReach(double x, double y, double z) {
    return Math.abs(x) < FARTHEST_VOXELS
        && Math.abs(y) < FARTHEST_VOXELS
        && Math.abs(z) < FARTHEST_VOXELS;
  }

  /**
   * Walks the ray from where it enters the cube's bounds.
   *
   * @param ray of ordinary components, within reach, not beside the bounds
   * @param empty whether empty bricks are passed in one step
   * @param hit filled where the answer is {@link NearRayTraversal#HIT}
   */
  static int walk(BitCube bits, Ray ray, EmptySpaceSkipper empty, RayHit hit) {
    // Of a component that is 0 the reciprocal is infinite, and the next plane crossed there: never.
    double inverseX = 1 / (ray.toX - ray.fromX);
    double inverseY = 1 / (ray.toY - ray.fromY);
    double inverseZ = 1 / (ray.toZ - ray.fromZ);
    if (isPlane(ray.fromX) || isPlane(ray.fromY) || isPlane(ray.fromZ)) {
      return NearRayTraversal.DOUBT;
    }
    IntBox box = bits.bounds();
    double entryX = ((inverseX > 0 ? box.lowX : box.highX + 1) - ray.fromX) * inverseX;
    double entryY = ((inverseY > 0 ? box.lowY : box.highY + 1) - ray.fromY) * inverseY;
    double entryZ = ((inverseZ > 0 ? box.lowZ : box.highZ + 1) - ray.fromZ) * inverseZ;
    double exitX = ((inverseX > 0 ? box.highX + 1 : box.lowX) - ray.fromX) * inverseX;
    double exitY = ((inverseY > 0 ? box.highY + 1 : box.lowY) - ray.fromY) * inverseY;
    double exitZ = ((inverseZ > 0 ? box.highZ + 1 : box.lowZ) - ray.fromZ) * inverseZ;
    double start = Math.max(entryX, Math.max(entryY, entryZ));
    double end = Math.min(exitX, Math.min(exitY, exitZ));
    end = Math.min(1, end + AxisTraversal.doubt(end));
    if (start - AxisTraversal.doubt(start) > end) {
      return NearRayTraversal.MISS;
    }
    hit.t = Math.max(0, start);
    hit.axis = start <= 0 ? RayHit.NO_AXIS : start == entryX ? 0 : start == entryY ? 1 : 2;
    return walk(bits, ray, empty, end, inverseX, inverseY, inverseZ, hit);
  }

  private static boolean isPlane(double coordinate) {
    return coordinate == Math.rint(coordinate);
  }

  /**
   * Walks on from {@code hit.t}, which is 0 or where the ray crosses the bounds' {@code hit.axis}.
   */
  private static int walk(
      BitCube bits,
      Ray ray,
      EmptySpaceSkipper empty,
      double end,
      double inverseX,
      double inverseY,
      double inverseZ,
      RayHit hit) {
    double fromX = ray.fromX;
    double fromY = ray.fromY;
    double fromZ = ray.fromZ;
    final int aheadX = inverseX < 0 ? 0 : 1; // from a cell's number to that of the plane ahead
    final int aheadY = inverseY < 0 ? 0 : 1;
    final int aheadZ = inverseZ < 0 ? 0 : 1;
    int axis = hit.axis;
    double t = hit.t;
    double x = fromX + t * (ray.toX - fromX);
    double y = fromY + t * (ray.toY - fromY);
    double z = fromZ + t * (ray.toZ - fromZ);
    int i = axis == 0 ? cellBeyond(x, aheadX) : (int) Math.floor(x);
    int j = axis == 1 ? cellBeyond(y, aheadY) : (int) Math.floor(y);
    int k = axis == 2 ? cellBeyond(z, aheadZ) : (int) Math.floor(z);
    int shift = axis == RayHit.NO_AXIS ? 0 : BitCube.BRICK_SHIFT;
    while (true) {
      if (shift != 0
          && ((axis != 0 && isNearPlane(x, i))
              || (axis != 1 && isNearPlane(y, j))
              || (axis != 2 && isNearPlane(z, k)))) {
        return NearRayTraversal.DOUBT;
      }
      long brick = bits.brick(i >> 2, j >> 2, k >> 2);
      if ((brick >>> BitCube.bit(i, j, k) & 1) != 0) {
        hit.set(t, i, j, k, axis);
        return NearRayTraversal.HIT;
      }
      shift = brick != 0 || !empty.on ? 0 : emptyShift(bits, empty, i, j, k);
      int planeX = ((i >> shift) + aheadX) << shift;
      int planeY = ((j >> shift) + aheadY) << shift;
      int planeZ = ((k >> shift) + aheadZ) << shift;
      double nextX = (planeX - fromX) * inverseX;
      double nextY = (planeY - fromY) * inverseY;
      double nextZ = (planeZ - fromZ) * inverseZ;
      axis = nextX < nextY ? (nextX < nextZ ? 0 : 2) : (nextY < nextZ ? 1 : 2);
      t = axis == 0 ? nextX : axis == 1 ? nextY : nextZ;
      if (t > end && (end < 1 || t > 1 + AxisTraversal.doubt(t))) {
        return NearRayTraversal.MISS;
      }
      if (NearRayTraversal.isInDoubt(t, NearRayTraversal.median(nextX, nextY, nextZ))) {
        return NearRayTraversal.DOUBT;
      }
      if (shift != 0) {
        x = fromX + t * (ray.toX - fromX);
        y = fromY + t * (ray.toY - fromY);
        z = fromZ + t * (ray.toZ - fromZ);
        i = (int) Math.floor(x);
        j = (int) Math.floor(y);
        k = (int) Math.floor(z);
      }
      if (axis == 0) {
        i = planeX + aheadX - 1;
      } else if (axis == 1) {
        j = planeY + aheadY - 1;
      } else {
        k = planeZ + aheadZ - 1;
      }
    }
  }

  /** The cell that a ray enters which is at a plane, but for rounding. */
  private static int cellBeyond(double plane, int ahead) {
    return (int) Math.rint(plane) + ahead - 1;
  }

  /** Of the empty brick that the voxel lies in, or of the whole block where that is empty too. */
  private static int emptyShift(BitCube bits, EmptySpaceSkipper empty, int i, int j, int k) {
    empty.bricks++;
    int shift = BitCube.BLOCK_SHIFT;
    return bits.block(i >> shift, j >> shift, k >> shift) == 0 ? shift : BitCube.BRICK_SHIFT;
  }

  private static boolean isNearPlane(double coordinate, int cell) {
    double share = coordinate - cell;
    return share < PLACE_DOUBT || share > 1 - PLACE_DOUBT;
  }
}
