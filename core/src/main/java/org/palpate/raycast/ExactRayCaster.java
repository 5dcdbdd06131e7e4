package org.palpate.raycast;

import org.palpate.geometry.IntBox;
import org.palpate.volume.BitCube;

/**
 * Finds the first solid voxel that a ray touches, exactly: the ray is the segment between its two
 * ends as they are, voxels are closed, so that a ray that only touches a face, an edge or a corner
 * hits, and one that passes between two voxels which share an edge or a corner does too.
 *
 * <p>How: a walk from cell to cell in floating point. Where two planes are crossed so near to each
 * other that rounding could hide their order, or a plane so near to the ray's end that it could lie
 * behind it, every cell that might be touched there is visited, and a solid one counts only where
 * {@link ExactPredicates} says that it is touched. All other cells of the walk are touched for
 * sure. Empty bricks, and empty blocks of bricks, are passed in one step.
 *
 * <p>Source: J. Amanatides and A. Woo, A fast voxel traversal algorithm for ray tracing, 1987; the
 * treatment of ties is ours.
 *
 * <p>{@link RayHit#t} is accurate to a few roundings. Six finite doubles are taken whatever their
 * size. Cost: some ten nanoseconds and one step for each voxel near a surface, each empty brick or
 * block farther off.
 */
public final class ExactRayCaster implements RayCaster {
  /** Shorter along an axis, the reciprocal could overflow: the exhaustive way is taken. */
  private static final double SHORTEST = 0x1p-900;

  /**
   * Longer along an axis, two planes of that axis could be crossed so near to each other that their
   * order with a plane of another is in doubt for both: the exhaustive way is taken. Up to here
   * they are crossed four doubts apart.
   */
  private static final double LONGEST = 0x1p46;

  private final EmptySpaceSkipper empty;
  private final ExactPredicates exact = new ExactPredicates();
  private final ExhaustiveRayCaster exhaustive = new ExhaustiveRayCaster(exact);
  private final AxisTraversal x = new AxisTraversal();
  private final AxisTraversal y = new AxisTraversal();
  private final AxisTraversal z = new AxisTraversal();
  private final RayHit other = new RayHit();

  private BitCube bits;
  private Ray ray;
  private RayHit hit;
  private double start;
  private double end;

  /** Passes empty bricks and blocks of bricks in one step. */
  public ExactRayCaster() {
    this(true);
  }

  /**
   * Answers are the same either way.
   *
   * @param skipsEmpty whether empty bricks and blocks of bricks are passed in one step, or voxel by
   *     voxel, to see what that is worth
   */
  public ExactRayCaster(boolean skipsEmpty) {
    empty = new EmptySpaceSkipper(skipsEmpty);
  }

  /** How often something empty was passed in one step: a brick, a block, a box in a brick. */
  public long skippedBricks() {
    return empty.bricks;
  }

  /** How many rays lay beside the box of all solids. */
  public long skippedBeside() {
    return empty.beside;
  }

  @Override
  public boolean cast(BitCube cube, Ray newRay, RayHit newHit) {
    IntBox box = cube.bounds();
    if (misses(newRay, box)) {
      empty.beside++;
      return false;
    }
    double dx = newRay.toX - newRay.fromX;
    double dy = newRay.toY - newRay.fromY;
    double dz = newRay.toZ - newRay.fromZ;
    if (!isOrdinary(dx) || !isOrdinary(dy) || !isOrdinary(dz)) {
      return exhaustive.cast(cube, newRay, newHit);
    }
    int answer = walkWhereSure(cube, newRay, dx, dy, dz, newHit);
    if (answer != NearRayTraversal.DOUBT) {
      return answer == NearRayTraversal.HIT;
    }
    bits = cube;
    ray = newRay;
    hit = newHit;
    return castLayers(box);
  }

  private int walkWhereSure(BitCube cube, Ray ray, double dx, double dy, double dz, RayHit hit) {
    if (NearRayTraversal.isNear(dx, dy, dz)) {
      return NearRayTraversal.walk(cube, ray, empty, hit);
    }
    return FarRayTraversal.isWithinReach(ray)
        ? FarRayTraversal.walk(cube, ray, empty, hit)
        : NearRayTraversal.DOUBT;
  }

  /** Whether the ray lies on one side of the box. Exact: only comparisons. */
  private static boolean misses(Ray r, IntBox box) {
    return beside(r.fromX, r.toX, box.lowX, box.highX)
        || beside(r.fromY, r.toY, box.lowY, box.highY)
        || beside(r.fromZ, r.toZ, box.lowZ, box.highZ);
  }

  private static boolean beside(double from, double to, int low, int high) {
    double end = (double) high + 1;
    // compared one by one, since Math.max of doubles takes longer than both
    return low > high || (from < low && to < low) || (from > end && to > end);
  }

  private static boolean isOrdinary(double delta) {
    double length = Math.abs(delta);
    return (length >= SHORTEST && length <= LONGEST) || length == 0;
  }

  /**
   * A ray that runs within a grid plane touches the cells on both sides of it: walks each side and
   * takes the first hit.
   */
  private boolean castLayers(IntBox box) {
    int lastX = layersBelow(ray.fromX, ray.toX);
    int lastY = layersBelow(ray.fromY, ray.toY);
    int lastZ = layersBelow(ray.fromZ, ray.toZ);
    if ((lastX | lastY | lastZ) == 0) {
      return castLayer(box, 0, 0, 0);
    }
    boolean found = false;
    for (int layerX = 0; layerX <= lastX; layerX++) {
      for (int layerY = 0; layerY <= lastY; layerY++) {
        for (int layerZ = 0; layerZ <= lastZ; layerZ++) {
          found = keepFirst(found, castLayer(box, layerX, layerY, layerZ));
        }
      }
    }
    if (found) {
      hit.set(other);
    }
    return found;
  }

  private boolean keepFirst(boolean foundBefore, boolean foundNow) {
    if (foundNow && !(foundBefore && other.t <= hit.t)) {
      other.set(hit);
    }
    return foundBefore || foundNow;
  }

  private static int layersBelow(double from, double to) {
    return from == to && from == Math.rint(from) ? 1 : 0;
  }

  private boolean castLayer(IntBox box, int belowX, int belowY, int belowZ) {
    x.begin(ray.fromX, ray.toX, (int) Math.floor(ray.fromX) - belowX);
    y.begin(ray.fromY, ray.toY, (int) Math.floor(ray.fromY) - belowY);
    z.begin(ray.fromZ, ray.toZ, (int) Math.floor(ray.fromZ) - belowZ);
    start = 0;
    end = 1;
    clip(x, box.lowX, box.highX);
    clip(y, box.lowY, box.highY);
    clip(z, box.lowZ, box.highZ);
    if (start - AxisTraversal.doubt(start) > end + AxisTraversal.doubt(end)) {
      return false;
    }
    end += AxisTraversal.doubt(end);
    if (start > 0) {
      enter(x, box.lowX, box.highX);
      enter(y, box.lowY, box.highY);
      enter(z, box.lowZ, box.highZ);
    } else if (bits.get(x.cell, y.cell, z.cell)) {
      hit.set(0, x.cell, y.cell, z.cell, RayHit.NO_AXIS);
      return true;
    }
    if (empty.on && brick() == 0) {
      skipEmpty();
    }
    return walk();
  }

  /** Narrows the walk to the box that holds all solids. */
  private void clip(AxisTraversal axis, int low, int high) {
    if (axis.step == 0) {
      return;
    }
    int near = axis.step > 0 ? low : high + 1;
    int far = axis.step > 0 ? high + 1 : low;
    if (axis.startsBefore(near)) {
      start = Math.max(start, axis.crossing(near));
    }
    end = Math.min(end, axis.crossing(far));
  }

  /** Sets the walk along an axis to where the ray reaches the box. */
  private void enter(AxisTraversal axis, int low, int high) {
    boolean up = axis.step > 0;
    boolean outside = axis.startsBefore(up ? low : high + 1);
    int first = outside ? (up ? low : high + 1) : (up ? axis.cell + 1 : axis.cell);
    axis.skipTo(start, first, up ? high + 1 : low);
  }

  private boolean walk() {
    while (true) {
      double t = Math.min(x.next, Math.min(y.next, z.next));
      if (t > end) {
        return false;
      }
      double together = t + AxisTraversal.doubt(t);
      int crossed = crossedUntil(together);
      boolean sure = (crossed & (crossed - 1)) == 0 && together < 1;
      if (sure ? crossOne(crossed, t) : crossSeveral(withNeighbours(crossed), t)) {
        return true;
      }
    }
  }

  /** The axes whose next plane is crossed at t or before, a bit each. */
  private int crossedUntil(double t) {
    return (x.next <= t ? 1 : 0) | (y.next <= t ? 2 : 0) | (z.next <= t ? 4 : 0);
  }

  /**
   * Adds an axis whose order is in doubt with one of these, if not with the first: a chain of three
   * crossings, each so near to the next, is crossed as one. One time suffices, for there are three
   * axes, and two planes of one axis are never so near, see {@link #LONGEST}.
   */
  private int withNeighbours(int crossed) {
    double last = 0;
    last = (crossed & 1) != 0 ? Math.max(last, x.next) : last;
    last = (crossed & 2) != 0 ? Math.max(last, y.next) : last;
    last = (crossed & 4) != 0 ? Math.max(last, z.next) : last;
    return crossedUntil(last + AxisTraversal.doubt(last));
  }

  /** Crosses one plane, with no doubt about it. */
  private boolean crossOne(int crossed, double t) {
    AxisTraversal axis = crossed == 1 ? x : crossed == 2 ? y : z;
    axis.advance();
    long brick = brick();
    if (empty.on && brick == 0) {
      skipEmpty();
      return false;
    }
    if ((brick >>> BitCube.bit(x.cell, y.cell, z.cell) & 1) == 0) {
      return false;
    }
    hit.set(t, x.cell, y.cell, z.cell, crossed >> 1);
    return true;
  }

  private long brick() {
    return bits.brick(
        x.cell >> BitCube.BRICK_SHIFT,
        y.cell >> BitCube.BRICK_SHIFT,
        z.cell >> BitCube.BRICK_SHIFT);
  }

  /** Goes on to the last cells before the ray leaves the empty brick, or empty block of bricks. */
  private void skipEmpty() {
    empty.bricks++;
    boolean emptyBlock =
        bits.block(
                x.cell >> BitCube.BLOCK_SHIFT,
                y.cell >> BitCube.BLOCK_SHIFT,
                z.cell >> BitCube.BLOCK_SHIFT)
            == 0;
    int shift = emptyBlock ? BitCube.BLOCK_SHIFT : BitCube.BRICK_SHIFT;
    double exit = Math.min(x.exit(shift), Math.min(y.exit(shift), z.exit(shift)));
    x.skipTo(exit, shift);
    y.skipTo(exit, shift);
    z.skipTo(exit, shift);
  }

  /**
   * Crosses planes whose order is in doubt, or one that may lie behind the ray's end. The cells
   * that can be touched are those reached by crossing any of them; fewer crossings first, so that
   * the face that is named belongs to the cell.
   */
  private boolean crossSeveral(int crossed, double t) {
    for (int count = 1; count <= 3; count++) {
      for (int set = 1; set <= crossed; set++) {
        if ((set & ~crossed) == 0 && Integer.bitCount(set) == count && touches(set, t)) {
          return true;
        }
      }
    }
    advanceAll(crossed);
    return false;
  }

  private boolean touches(int set, double t) {
    int i = x.cell + ((set & 1) != 0 ? x.step : 0);
    int j = y.cell + ((set & 2) != 0 ? y.step : 0);
    int k = z.cell + ((set & 4) != 0 ? z.step : 0);
    if (!bits.get(i, j, k) || !exact.touchesVoxel(ray, i, j, k)) {
      return false;
    }
    hit.set(Math.min(t, 1), i, j, k, Integer.numberOfTrailingZeros(set));
    return true;
  }

  private void advanceAll(int crossed) {
    if ((crossed & 1) != 0) {
      x.advance();
    }
    if ((crossed & 2) != 0) {
      y.advance();
    }
    if ((crossed & 4) != 0) {
      z.advance();
    }
  }
}
