package org.palpate.raycast;

import org.palpate.geometry.IntBox;
import org.palpate.statistics.SkipCounters;
import org.palpate.statistics.SkipKind;
import org.palpate.volume.BitCube;

/**
 * Finds the first solid voxel that a ray touches, exactly. The ray is the segment between its two
 * doubles, and voxels are closed: a ray that only touches a face, an edge or a corner hits, and so
 * does a ray that passes between two voxels which share an edge or a corner.
 *
 * <p>A traversal in floating point visits the cells. If two planes are crossed so close together
 * that rounding could swap them, every cell that the ray might touch there is visited. The same
 * holds for a plane so close to the end of the ray that it could lie behind it. There a solid voxel
 * counts only if {@link ExactPredicates} confirms it. All other cells of the traversal are touched
 * for certain. Empty bricks, and empty blocks of bricks, are passed in one step.
 *
 * <p>Reference: J. Amanatides and A. Woo, A fast voxel traversal algorithm for ray tracing, 1987;
 * the treatment of ties is our own.
 *
 * <p>{@link RayHit#t} is accurate to a few roundings. Any six finite doubles are allowed. Cost: 10
 * to 30 ns, plus one step for each voxel near a surface and for each empty brick or block.
 */
public final class ExactRayCaster implements RayCaster {
  /** The reciprocal of a shorter component could overflow; the exhaustive caster takes over. */
  private static final double MIN_COMPONENT = 0x1p-900;

  /**
   * The largest component of a traversed ray; the exhaustive caster takes longer ones. Up to here
   * two planes of one axis are crossed at least four doubts apart, so that at most one plane of
   * each axis takes part in a tie.
   */
  private static final double MAX_COMPONENT = 0x1p46;

  private final EmptySpaceSkipper empty;
  private final FarRayTraversal far;
  private final ExactPredicates exact = new ExactPredicates();
  private final ExhaustiveRayCaster exhaustive = new ExhaustiveRayCaster(exact);
  private final AxisTraversal x = new AxisTraversal();
  private final AxisTraversal y = new AxisTraversal();
  private final AxisTraversal z = new AxisTraversal();
  private final RayHit first = new RayHit();

  private BitCube bits;
  private Ray ray;
  private RayHit hit;
  private double start;
  private double end;

  /** Creates a caster. */
  public ExactRayCaster() {
    this(new EmptySpaceSkipper(true));
  }

  private ExactRayCaster(EmptySpaceSkipper empty) {
    this.empty = empty;
    far = new FarRayTraversal(empty);
  }

  /** Returns a caster that passes no empty brick in one step. Its answers are the same. */
  static ExactRayCaster voxelByVoxel() {
    return new ExactRayCaster(new EmptySpaceSkipper(false));
  }

  /**
   * Adds the number of skipped empty bricks and of rays beside the bounds to other counters.
   *
   * @param dest receives the counts
   */
  public void addSkips(SkipCounters dest) {
    dest.add(SkipKind.EMPTY_BRICKS, empty.skippedBricks);
    dest.add(SkipKind.BESIDE_BOUNDS, empty.raysBesideBounds);
  }

  @Override
  public boolean cast(BitCube cube, Ray newRay, RayHit newHit) {
    IntBox box = cube.bounds();
    if (misses(newRay, box)) {
      empty.raysBesideBounds++;
      return false;
    }
    double dx = newRay.toX - newRay.fromX;
    double dy = newRay.toY - newRay.fromY;
    double dz = newRay.toZ - newRay.fromZ;
    if (!isOrdinary(dx) || !isOrdinary(dy) || !isOrdinary(dz)) {
      return exhaustive.cast(cube, newRay, newHit);
    }
    TraversalResult result = traverseInDoubles(cube, newRay, dx, dy, dz, newHit);
    if (result != TraversalResult.IN_DOUBT) {
      return result == TraversalResult.HIT;
    }
    bits = cube;
    ray = newRay;
    hit = newHit;
    return castLayers(box);
  }

  private TraversalResult traverseInDoubles(
      BitCube cube, Ray r, double dx, double dy, double dz, RayHit dest) {
    if (NearRayTraversal.isNear(dx, dy, dz)) {
      return NearRayTraversal.cast(cube, r, empty, dest);
    }
    return FarRayTraversal.isWithinReach(r) ? far.cast(cube, r, dest) : TraversalResult.IN_DOUBT;
  }

  /** Whether the ray lies wholly on one side of the box. Exact: comparisons alone. */
  private static boolean misses(Ray r, IntBox box) {
    return beside(r.fromX, r.toX, box.lowX, box.highX)
        || beside(r.fromY, r.toY, box.lowY, box.highY)
        || beside(r.fromZ, r.toZ, box.lowZ, box.highZ);
  }

  private static boolean beside(double from, double to, int low, int high) {
    double end = (double) high + 1;
    // Math.max of doubles would take longer than both comparisons.
    return low > high || (from < low && to < low) || (from > end && to > end);
  }

  private static boolean isOrdinary(double delta) {
    double length = Math.abs(delta);
    return (length >= MIN_COMPONENT && length <= MAX_COMPONENT) || length == 0;
  }

  /**
   * Casts the ray and, if it runs within a grid plane, does so in the layers of cells on both sides
   * of the plane; keeps the first hit.
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
      hit.set(first);
    }
    return found;
  }

  private boolean keepFirst(boolean foundBefore, boolean foundNow) {
    if (foundNow && !(foundBefore && first.t <= hit.t)) {
      first.set(hit);
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
    if (empty.enabled && brick() == 0) {
      skipEmpty();
    }
    return traverse();
  }

  /** Narrows the traversal to the box that holds all solids. */
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

  /** Moves the traversal along an axis to the point where the ray enters the box. */
  private void enter(AxisTraversal axis, int low, int high) {
    boolean up = axis.step > 0;
    boolean outside = axis.startsBefore(up ? low : high + 1);
    int first = outside ? (up ? low : high + 1) : (up ? axis.cell + 1 : axis.cell);
    axis.skipTo(start, first, up ? high + 1 : low);
  }

  private boolean traverse() {
    while (true) {
      double t = Math.min(x.next, Math.min(y.next, z.next));
      if (t > end) {
        return false;
      }
      double together = t + AxisTraversal.doubt(t);
      int crossed = crossedUntil(together);
      boolean sure = (crossed & (crossed - 1)) == 0 && together < 1;
      boolean hitsSolid = sure ? crossOne(crossed, t) : crossSeveral(withAdjacentTies(crossed), t);
      if (hitsSolid) {
        return true;
      }
    }
  }

  /** Returns the axes whose next plane is crossed at t or before, one bit each. */
  private int crossedUntil(double t) {
    return (x.next <= t ? 1 : 0) | (y.next <= t ? 2 : 0) | (z.next <= t ? 4 : 0);
  }

  /**
   * Adds an axis whose crossing is in doubt with one of these, if not with the first. So a chain of
   * three crossings, each close to the next, is crossed as one. One pass suffices: there are three
   * axes, and two planes of one axis are never so close, see {@link #MAX_COMPONENT}.
   */
  private int withAdjacentTies(int crossed) {
    double last = 0;
    last = (crossed & 1) != 0 ? Math.max(last, x.next) : last;
    last = (crossed & 2) != 0 ? Math.max(last, y.next) : last;
    last = (crossed & 4) != 0 ? Math.max(last, z.next) : last;
    return crossedUntil(last + AxisTraversal.doubt(last));
  }

  /** Crosses one plane about which there is no doubt; returns whether its cell is solid. */
  private boolean crossOne(int crossed, double t) {
    AxisTraversal axis = crossed == 1 ? x : crossed == 2 ? y : z;
    axis.advance();
    long brick = brick();
    if (empty.enabled && brick == 0) {
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

  /** Moves to the last cells before the ray leaves the empty brick or the empty block. */
  private void skipEmpty() {
    empty.skippedBricks++;
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
   * Crosses planes whose order is in doubt, or one that may lie behind the end of the ray. The ray
   * can touch every cell that is reached by crossing a subset of them. Small subsets come first, so
   * that the axis of the hit belongs to a face of the cell.
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
