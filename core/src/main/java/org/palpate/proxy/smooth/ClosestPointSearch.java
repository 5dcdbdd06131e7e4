package org.palpate.proxy.smooth;

import org.palpate.geometry.Vec3;
import org.palpate.proxy.smooth.field.FieldSample;
import org.palpate.proxy.smooth.field.IsoLevel;
import org.palpate.proxy.smooth.field.OccupancyField;
import org.palpate.proxy.smooth.field.SeedCell;

/**
 * Finds the point of the isosurface that is closest to the device, by Newton's method with the
 * curvature from the Hessian. Iterates are virtual: nothing moves.
 *
 * <p>If the isosurface is far from the solid, the search visits a nearer level first, because the
 * field shows directions better there, see {@link IsoLevel#isFar}. The point found then lies on the
 * isosurface, on the normal of the point that was visited last; so the line from it to the device
 * has the direction of that normal. Where the two levels do not run side by side, as over wires and
 * thin walls that the nearer one does not show, the isosurface is searched itself.
 *
 * <p>An iteration solves (I - depth K) t = u in the tangent plane, where K is the curvature of the
 * level and u the tangential part of the vector to the device. It drops along the normal by the
 * height above the level and by t K t / 2. Near a centre of curvature Newton's method overshoots;
 * an iteration that gains little halves the ones that follow.
 *
 * <p>References: the god object, Zilles and Salisbury 1995; proxies on implicit surfaces, Salisbury
 * and Tarr 1997; on volumes, Chan et al. 2011.
 *
 * <p>Lengths are in shortest voxel edges. Belongs to the haptic thread; allocates nothing. Cost: up
 * to 13 evaluations of the field; with a nearer level up to 28.
 */
final class ClosestPointSearch {
  /** The outcome of a search. */
  enum Outcome {
    /** The closest point was found. */
    CONVERGED,

    /** The device lies above the tangent plane of the point that was visited last. */
    OUTSIDE,

    /**
     * The next iteration would leave the reach, or the work budget is spent. The point that was
     * visited last is an approximation.
     */
    UNFINISHED,

    /** The field is too flat, or the isosurface too far away, to say where it runs. */
    NO_SURFACE
  }

  /** The farthest distance from its start that a search visits. */
  static final double REACH_EDGES = 3;

  private static final double TOLERANCE_EDGES = 2e-3;

  /** The tolerance as a fraction of the first offset; the next frame goes on with the rest. */
  private static final double TOLERANCE_FRACTION = 0.01;

  /** The greatest depth below the isosurface from which a search leads out, on cubes. */
  private static final double MAX_DEPTH_EDGES = 1.6;

  /**
   * The growth of that depth with the isosurface's offset. Between the steps of long voxels a point
   * may lie deeper.
   */
  private static final double MAX_DEPTH_GROWTH = 2.2;

  private static final int MAX_ITERATIONS = 12;
  private static final double MAX_STEP_EDGES = 2.2;
  private static final double MAX_DROP_EDGES = 1;
  private static final double MAX_CURVED_DROP_EDGES = 0.5;

  /** An iteration that leaves more than this fraction of the offset halves the damping. */
  private static final double SLOW_FRACTION = 0.7;

  private static final double MIN_DAMPING = 0.25;

  /** An offset below this has no direction. */
  private static final double MIN_OFFSET_EDGES = 1e-12;

  /**
   * A search within this offset is nearly done: a frame that has spent its budget still finishes
   * it, because a result that is left to the next frame would be felt.
   */
  private static final double NEARLY_DONE_EDGES = 2;

  /** Keeps the tangential system positive definite near centres of curvature. */
  private static final double MIN_DIAGONAL = 0.35;

  private static final double MAX_COUPLING_SQUARE = 0.8 * 0.8;

  /**
   * The greatest height, above or below the isosurface, of a point that the nearer level puts onto
   * it. If it is greater, the levels have different shapes.
   */
  private static final double MAX_HEIGHT_EDGES = 0.35;

  /**
   * The height that is left to such a point. On a plane the field is a little off the profile that
   * {@link IsoLevel} assumes; if that were taken off, the next search would not begin on the nearer
   * level, and would need one more iteration.
   */
  private static final double HEIGHT_LEFT_EDGES = 0.15;

  private final OccupancyField field;
  private final FieldSample sample;
  private final IsoLevel level;
  private final EdgeUnits units;
  private final WindowBudget budget;
  private final Vec3 voxelsPerEdge;
  private final double maxDepthEdges;

  /** The point at which the iterations began. */
  private final Vec3 begin = new Vec3();

  private final Vec3 visited = new Vec3();

  /** The point of the isosurface over the visited one, and the normal of that one. */
  private final Vec3 found = new Vec3();

  private final Vec3 foundNormal = new Vec3();
  private final Vec3 toDevice = new Vec3();
  private final Vec3 tangent = new Vec3();
  private final Vec3 step = new Vec3();

  /** The height of the visited point above the level that the search visits. */
  private double height;

  /** Whether that level is the nearer one, and how far the isosurface runs outside it. */
  private boolean visitsNearLevel;

  private double rise;

  /** The depth of the device below that level, as its tangent plane approximates it. */
  private double depth;

  private boolean hasLeftStart;

  /** The square of the tangential distance from the visited point to the device. */
  private double offsetSquare;

  ClosestPointSearch(OccupancyField field, EdgeUnits units, WindowBudget budget) {
    this.field = field;
    this.units = units;
    this.budget = budget;
    sample = field.sample();
    level = field.level();
    double moreOffset = level.mostOffsetEdges() - IsoLevel.OFFSET_OF_CUBES_EDGES;
    maxDepthEdges = MAX_DEPTH_EDGES + MAX_DEPTH_GROWTH * moreOffset;
    voxelsPerEdge = new Vec3(1 / units.x(), 1 / units.y(), 1 / units.z());
  }

  /** Returns the point found, on the isosurface; grid coordinates, not to be changed. */
  Vec3 found() {
    return found;
  }

  /** Whether the search has gone on from its start. */
  boolean hasLeftStart() {
    return hasLeftStart;
  }

  /** Returns the outward unit normal there, not to be changed. */
  Vec3 normal() {
    return foundNormal;
  }

  /**
   * Searches for the point closest to the device.
   *
   * @param seed the cell from which empty space is reached
   * @param start where the search begins, on the isosurface or near it
   */
  Outcome search(SeedCell seed, Vec3 start, Vec3 device) {
    hasLeftStart = false;
    if (level.isFar() && !budget.isOverdrawn()) {
      beginOnNearLevel(seed, start);
      Outcome outcome = searchLevel(seed, device);
      if (outcome != Outcome.NO_SURFACE && (findOnIsosurface(seed) || budget.isOverdrawn())) {
        return outcome;
      }
    }
    hasLeftStart = false;
    visitsNearLevel = false;
    rise = 0;
    visited.set(start);
    begin.set(start);
    Outcome outcome = searchLevel(seed, device);
    found.set(visited);
    foundNormal.set(sample.normal());
    return outcome;
  }

  /** Begins as far below a start as the nearer level runs below the isosurface. */
  private void beginOnNearLevel(SeedCell seed, Vec3 start) {
    visitsNearLevel = true;
    visited.set(start);
    field.evaluate(seed, start);
    if (sample.hasNormal()) {
      double below = level.aboveNearLevelEdges(sample.normal());
      units.offset(start, -below, sample.normal(), visited);
    }
    begin.set(visited);
  }

  /**
   * Goes up along the normal from the point that was visited last to the isosurface.
   *
   * @return whether the isosurface runs about where the nearer level says
   */
  private boolean findOnIsosurface(SeedCell seed) {
    foundNormal.set(sample.normal());
    units.offset(visited, rise, foundNormal, found);
    field.evaluate(seed, found);
    if (!sample.hasNormal()) {
      return false;
    }
    double above = sample.heightEdges();
    double excess = above - clamp(above, HEIGHT_LEFT_EDGES);
    if (excess != 0) {
      units.offset(visited, rise - excess, foundNormal, found);
    }
    return Math.abs(above) <= MAX_HEIGHT_EDGES;
  }

  /** Searches the level for the point closest to the device, from where the search begins. */
  private Outcome searchLevel(SeedCell seed, Vec3 device) {
    double damping = 1;
    double lastSquare = Double.POSITIVE_INFINITY;
    double toleranceSquare = 0;
    for (int n = 0; n < MAX_ITERATIONS; n++) {
      visit(seed, device);
      if (!sample.hasNormal() || height < -maxDepthEdges) {
        return Outcome.NO_SURFACE;
      }
      if (!isDeviceBelow()) {
        return Outcome.OUTSIDE;
      }
      if (isWithin(toleranceSquare)) {
        return Outcome.CONVERGED;
      }
      if (offsetSquare > SLOW_FRACTION * SLOW_FRACTION * lastSquare) {
        damping = Math.max(MIN_DAMPING, damping / 2);
      }
      if (n == 0) {
        toleranceSquare = toleranceSquare();
      }
      lastSquare = offsetSquare;
      findStep(damping);
      if (n > 0 && (isOutOfBudget() || leavesReach())) {
        return Outcome.UNFINISHED;
      }
      takeStep();
    }
    visit(seed, device);
    return sample.hasNormal() && isDeviceBelow() ? Outcome.CONVERGED : Outcome.NO_SURFACE;
  }

  /** Evaluates the field at the visited point and splits the vector from there to the device. */
  private void visit(SeedCell seed, Vec3 device) {
    field.evaluate(seed, visited);
    if (sample.hasNormal()) {
      findHeight();
      project(device);
    }
  }

  private void findHeight() {
    if (visitsNearLevel) {
      rise = level.aboveNearLevelEdges(sample.normal());
      height = (level.nearOccupancy(sample.normal()) - sample.occupancy()) * sample.inverseSlope();
    } else {
      height = sample.heightEdges();
    }
  }

  /** Splits the vector to the device into its parts along the normal and in the tangent plane. */
  private void project(Vec3 device) {
    Vec3 normal = sample.normal();
    units.vector(visited, device, toDevice);
    double along = toDevice.dot(normal);
    depth = -along - height;
    tangent.set(
        toDevice.x - along * normal.x,
        toDevice.y - along * normal.y,
        toDevice.z - along * normal.z);
    offsetSquare = tangent.dot(tangent);
  }

  /** Whether the device lies below the isosurface, as the tangent plane approximates it. */
  private boolean isDeviceBelow() {
    return depth + rise > 0;
  }

  private boolean isWithin(double toleranceSquare) {
    return offsetSquare <= toleranceSquare && height * height <= toleranceSquare;
  }

  private double toleranceSquare() {
    return Math.max(
        TOLERANCE_EDGES * TOLERANCE_EDGES, TOLERANCE_FRACTION * TOLERANCE_FRACTION * offsetSquare);
  }

  private boolean isOutOfBudget() {
    return budget.isSpent()
        && (offsetSquare > NEARLY_DONE_EDGES * NEARLY_DONE_EDGES || budget.isOverdrawn());
  }

  private boolean leavesReach() {
    double x = (visited.x - begin.x) * units.x() + step.x;
    double y = (visited.y - begin.y) * units.y() + step.y;
    double z = (visited.z - begin.z) * units.z() + step.z;
    return x * x + y * y + z * z > REACH_EDGES * REACH_EDGES;
  }

  private void takeStep() {
    hasLeftStart = true;
    visited.set(
        visited.x + step.x * voxelsPerEdge.x,
        visited.y + step.y * voxelsPerEdge.y,
        visited.z + step.z * voxelsPerEdge.z);
  }

  /** Finds the tangential step and the drop along the normal. */
  private void findStep(double damping) {
    double curvedDrop = 0;
    if (offsetSquare > MIN_OFFSET_EDGES * MIN_OFFSET_EDGES) {
      curvedDrop = findTangentialStep(damping);
    } else {
      step.set(0, 0, 0);
    }
    Vec3 normal = sample.normal();
    double drop = -clamp(height, MAX_DROP_EDGES) - clamp(curvedDrop, MAX_CURVED_DROP_EDGES);
    step.set(step.x + drop * normal.x, step.y + drop * normal.y, step.z + drop * normal.z);
  }

  /**
   * Writes the tangential step; returns how far the surface falls off along it. The basis is the
   * offset a, and b, as long and at right angles to it; neither is normalized.
   */
  private double findTangentialStep(double damping) {
    Vec3 normal = sample.normal();
    double ax = tangent.x;
    double ay = tangent.y;
    double az = tangent.z;
    double bx = normal.y * az - normal.z * ay;
    double by = normal.z * ax - normal.x * az;
    double bz = normal.x * ay - normal.y * ax;
    double hax = sample.hxx() * ax + sample.hxy() * ay + sample.hxz() * az;
    double hay = sample.hxy() * ax + sample.hyy() * ay + sample.hyz() * az;
    double haz = sample.hxz() * ax + sample.hyz() * ay + sample.hzz() * az;
    double hbx = sample.hxx() * bx + sample.hxy() * by + sample.hxz() * bz;
    double hby = sample.hxy() * bx + sample.hyy() * by + sample.hyz() * bz;
    double hbz = sample.hxz() * bx + sample.hyz() * by + sample.hzz() * bz;
    double toCurvature = -sample.inverseSlope() / offsetSquare;
    double curvatureA = (ax * hax + ay * hay + az * haz) * toCurvature;
    double curvatureAb = (bx * hax + by * hay + bz * haz) * toCurvature;
    double curvatureB = (bx * hbx + by * hby + bz * hbz) * toCurvature;
    double diagonalA = atLeast(MIN_DIAGONAL, 1 - depth * curvatureA);
    double diagonalB = atLeast(MIN_DIAGONAL, 1 - depth * curvatureB);
    double coupling =
        clampSquare(-depth * curvatureAb, MAX_COUPLING_SQUARE * diagonalA * diagonalB);
    double scale = damping / (diagonalA * diagonalB - coupling * coupling);
    double alongA = scale * diagonalB;
    double alongB = -scale * coupling;
    double lengthSquare = (alongA * alongA + alongB * alongB) * offsetSquare;
    if (lengthSquare > MAX_STEP_EDGES * MAX_STEP_EDGES) {
      double shorter = MAX_STEP_EDGES / Math.sqrt(lengthSquare);
      alongA *= shorter;
      alongB *= shorter;
    }
    step.set(ax * alongA + bx * alongB, ay * alongA + by * alongB, az * alongA + bz * alongB);
    return 0.5
        * offsetSquare
        * (curvatureA * alongA * alongA
            + 2 * curvatureAb * alongA * alongB
            + curvatureB * alongB * alongB);
  }

  /** Returns the value, or the root of {@code limitSquare} with its sign if it is longer. */
  private static double clampSquare(double value, double limitSquare) {
    return value * value <= limitSquare ? value : Math.copySign(Math.sqrt(limitSquare), value);
  }

  // By branches, which are predicted; Math.min and Math.max of doubles wait for their operands.

  private static double clamp(double value, double limit) {
    return Math.abs(value) <= limit ? value : Math.copySign(limit, value);
  }

  private static double atLeast(double least, double value) {
    return value >= least ? value : least;
  }
}
