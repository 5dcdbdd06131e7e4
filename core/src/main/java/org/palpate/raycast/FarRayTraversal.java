package org.palpate.raycast;

import org.palpate.geometry.IntBox;
import org.palpate.volume.BitCube;

/**
 * Traverses a ray of any length: from voxel to voxel in bricks that hold solids, and past an empty
 * brick or an empty block of bricks in one step.
 *
 * <p>The traversal ends {@link TraversalResult#IN_DOUBT} if the ray starts on a grid plane or
 * crosses two planes nearly at once. It does so too if the ray crosses a plane nearly at its end,
 * or if a step longer than a voxel ends nearly on a plane. The loop keeps its state in local
 * variables and takes half the time of the traversal of {@link ExactRayCaster}, whose state is in
 * objects.
 *
 * <p>Keeps scratch: one thread an instance.
 */
final class FarRayTraversal {
  /**
   * The largest coordinate at which the error of a position is far below {@link #POSITION_DOUBT}.
   */
  private static final double MAX_COORDINATE_VOXELS = 1 << 20;

  /** A position closer than this to a grid plane may lie on either side of it, voxels. */
  private static final double POSITION_DOUBT = 0x1p-24;

  private final EmptySpaceSkipper empty;

  private double inverseX;
  private double inverseY;
  private double inverseZ;

  /** The ray parameters at which the ray enters and leaves the bounds of the cube. */
  private double start;

  private double end;

  /** The axis whose plane the ray crosses when it enters the bounds; none if it starts inside. */
  private int entryAxis;

  /**
   * Creates a traversal.
   *
   * @param empty whether empty bricks are passed in one step
   */
  FarRayTraversal(EmptySpaceSkipper empty) {
    this.empty = empty;
  }

  /** Whether all coordinates are small enough for this traversal. */
  static boolean isWithinReach(Ray r) {
    return isWithinReach(r.fromX, r.fromY, r.fromZ) && isWithinReach(r.toX, r.toY, r.toZ);
  }

  private static boolean isWithinReach(double x, double y, double z) {
    return Math.abs(x) < MAX_COORDINATE_VOXELS
        && Math.abs(y) < MAX_COORDINATE_VOXELS
        && Math.abs(z) < MAX_COORDINATE_VOXELS;
  }

  /**
   * Traverses the ray from the point where it enters the bounds of the cube.
   *
   * @param ray a ray within reach that does not lie beside the bounds; each component of its
   *     direction is 0 or has a reciprocal, see {@link ExactRayCaster}
   * @param hit receives the hit if the answer is {@link TraversalResult#HIT}
   */
  TraversalResult cast(BitCube bits, Ray ray, RayHit hit) {
    if (isOnPlane(ray.fromX) || isOnPlane(ray.fromY) || isOnPlane(ray.fromZ)) {
      return TraversalResult.IN_DOUBT;
    }
    clip(ray, bits.bounds());
    return start - AxisTraversal.doubt(start) > end
        ? TraversalResult.MISS
        : traverse(bits, ray, hit);
  }

  private static boolean isOnPlane(double coordinate) {
    return coordinate == Math.rint(coordinate);
  }

  private void clip(Ray ray, IntBox box) {
    // A component of 0 has an infinite reciprocal, so that its planes are never crossed.
    inverseX = 1 / (ray.toX - ray.fromX);
    inverseY = 1 / (ray.toY - ray.fromY);
    inverseZ = 1 / (ray.toZ - ray.fromZ);
    double entryX = ((inverseX > 0 ? box.lowX : box.highX + 1) - ray.fromX) * inverseX;
    double entryY = ((inverseY > 0 ? box.lowY : box.highY + 1) - ray.fromY) * inverseY;
    double entryZ = ((inverseZ > 0 ? box.lowZ : box.highZ + 1) - ray.fromZ) * inverseZ;
    double exitX = ((inverseX > 0 ? box.highX + 1 : box.lowX) - ray.fromX) * inverseX;
    double exitY = ((inverseY > 0 ? box.highY + 1 : box.lowY) - ray.fromY) * inverseY;
    double exitZ = ((inverseZ > 0 ? box.highZ + 1 : box.lowZ) - ray.fromZ) * inverseZ;
    double exit = Math.min(exitX, Math.min(exitY, exitZ));
    start = Math.max(entryX, Math.max(entryY, entryZ));
    end = Math.min(1, exit + AxisTraversal.doubt(exit));
    entryAxis = start <= 0 ? RayHit.NO_AXIS : start == entryX ? 0 : start == entryY ? 1 : 2;
  }

  private TraversalResult traverse(BitCube bits, Ray ray, RayHit hit) {
    final double fromX = ray.fromX;
    final double fromY = ray.fromY;
    final double fromZ = ray.fromZ;
    final double tPerX = inverseX;
    final double tPerY = inverseY;
    final double tPerZ = inverseZ;
    final int aheadX = tPerX < 0 ? 0 : 1; // offset from a cell to the plane ahead
    final int aheadY = tPerY < 0 ? 0 : 1;
    final int aheadZ = tPerZ < 0 ? 0 : 1;
    int axis = entryAxis;
    double t = Math.max(0, start);
    double x = fromX + t * (ray.toX - fromX);
    double y = fromY + t * (ray.toY - fromY);
    double z = fromZ + t * (ray.toZ - fromZ);
    int i = axis == 0 ? cellBeyond(x, aheadX) : (int) Math.floor(x);
    int j = axis == 1 ? cellBeyond(y, aheadY) : (int) Math.floor(y);
    int k = axis == 2 ? cellBeyond(z, aheadZ) : (int) Math.floor(z);
    int shift = axis == RayHit.NO_AXIS ? 0 : BitCube.BRICK_SHIFT;
    while (true) {
      if (shift != 0 && isNearOtherPlane(axis, x - i, y - j, z - k)) {
        return TraversalResult.IN_DOUBT;
      }
      long brick = bits.brick(i >> 2, j >> 2, k >> 2);
      if ((brick >>> BitCube.bit(i, j, k) & 1) != 0) {
        hit.set(t, i, j, k, axis);
        return TraversalResult.HIT;
      }
      shift = brick != 0 || !empty.enabled ? 0 : emptyShift(bits, i, j, k);
      int planeX = ((i >> shift) + aheadX) << shift;
      int planeY = ((j >> shift) + aheadY) << shift;
      int planeZ = ((k >> shift) + aheadZ) << shift;
      double nextX = (planeX - fromX) * tPerX;
      double nextY = (planeY - fromY) * tPerY;
      double nextZ = (planeZ - fromZ) * tPerZ;
      axis = nextX < nextY ? (nextX < nextZ ? 0 : 2) : (nextY < nextZ ? 1 : 2);
      t = axis == 0 ? nextX : axis == 1 ? nextY : nextZ;
      if (t > end && (end < 1 || t > 1 + AxisTraversal.doubt(t))) {
        return TraversalResult.MISS;
      }
      if (NearRayTraversal.isInDoubt(t, NearRayTraversal.median(nextX, nextY, nextZ))) {
        return TraversalResult.IN_DOUBT;
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

  /** Returns the cell behind a plane on which the coordinate lies up to rounding. */
  private static int cellBeyond(double plane, int ahead) {
    return (int) Math.rint(plane) + ahead - 1;
  }

  /** Returns the shift of the empty brick of a voxel, or of its block if that is empty too. */
  private int emptyShift(BitCube bits, int i, int j, int k) {
    empty.skippedBricks++;
    int shift = BitCube.BLOCK_SHIFT;
    return bits.block(i >> shift, j >> shift, k >> shift) == 0 ? shift : BitCube.BRICK_SHIFT;
  }

  /** Whether a position in its cell lies nearly on a grid plane of any axis but the given one. */
  private static boolean isNearOtherPlane(
      int axis, double fractionX, double fractionY, double fractionZ) {
    return (axis != 0 && isNearPlane(fractionX))
        || (axis != 1 && isNearPlane(fractionY))
        || (axis != 2 && isNearPlane(fractionZ));
  }

  private static boolean isNearPlane(double fraction) {
    return fraction < POSITION_DOUBT || fraction > 1 - POSITION_DOUBT;
  }
}
