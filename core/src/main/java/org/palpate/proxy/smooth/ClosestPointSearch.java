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
 * <p>An iteration solves (I - depth K) t = u in the tangent plane, where K is the curvature of the
 * isosurface and u the tangential part of the vector to the device. It drops along the normal by
 * the height above the isosurface and by t K t / 2. Near a centre of curvature Newton's method
 * overshoots; an iteration that gains little halves the ones that follow.
 *
 * <p>References: the god object, Zilles and Salisbury 1995; proxies on implicit surfaces, Salisbury
 * and Tarr 1997; on volumes, Chan et al. 2011.
 *
 * <p>Lengths are in shortest voxel edges. Belongs to the haptic thread; allocates nothing. Cost: up
 * to 13 evaluations of the field.
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

  private final OccupancyField field;
  private final FieldSample sample;
  private final EdgeUnits units;
  private final WindowBudget budget;
  private final Vec3 voxelsPerEdge;
  private final double maxDepthEdges;
  private final Vec3 visited = new Vec3();
  private final Vec3 toDevice = new Vec3();
  private final Vec3 tangent = new Vec3();
  private final Vec3 step = new Vec3();
  private double depth;

  /** The square of the tangential distance from the visited point to the device. */
  private double offsetSquare;

  ClosestPointSearch(OccupancyField field, EdgeUnits units, WindowBudget budget) {
    this.field = field;
    this.units = units;
    this.budget = budget;
    sample = field.sample();
    double moreOffset = field.level().mostOffsetEdges() - IsoLevel.OFFSET_OF_CUBES_EDGES;
    maxDepthEdges = MAX_DEPTH_EDGES + MAX_DEPTH_GROWTH * moreOffset;
    voxelsPerEdge = new Vec3(1 / units.x(), 1 / units.y(), 1 / units.z());
  }

  /** Returns the point that was visited last, grid coordinates, not to be changed. */
  Vec3 visited() {
    return visited;
  }

  /** Returns the outward unit normal there, until the field is evaluated again. */
  Vec3 normal() {
    return sample.normal();
  }

  /**
   * Searches for the point closest to the device. Afterwards the field stands at {@link #visited}.
   *
   * @param seed the cell from which empty space is reached
   * @param start where the search begins
   */
  Outcome search(SeedCell seed, Vec3 start, Vec3 device) {
    visited.set(start);
    double damping = 1;
    double lastSquare = Double.POSITIVE_INFINITY;
    double toleranceSquare = 0;
    for (int n = 0; n < MAX_ITERATIONS; n++) {
      visit(seed, device);
      if (!sample.hasNormal() || sample.heightEdges() < -maxDepthEdges) {
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
      if (n > 0 && (isOutOfBudget() || leavesReach(start))) {
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
      project(device);
    }
  }

  /** Splits the vector to the device into its parts along the normal and in the tangent plane. */
  private void project(Vec3 device) {
    Vec3 normal = sample.normal();
    units.vector(visited, device, toDevice);
    double along = toDevice.dot(normal);
    depth = -along - sample.heightEdges();
    tangent.set(
        toDevice.x - along * normal.x,
        toDevice.y - along * normal.y,
        toDevice.z - along * normal.z);
    offsetSquare = tangent.dot(tangent);
  }

  /** Whether the device lies below the isosurface, as the tangent plane approximates it. */
  private boolean isDeviceBelow() {
    return depth > 0;
  }

  private boolean isWithin(double toleranceSquare) {
    double height = sample.heightEdges();
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

  private boolean leavesReach(Vec3 start) {
    double x = (visited.x - start.x) * units.x() + step.x;
    double y = (visited.y - start.y) * units.y() + step.y;
    double z = (visited.z - start.z) * units.z() + step.z;
    return x * x + y * y + z * z > REACH_EDGES * REACH_EDGES;
  }

  private void takeStep() {
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
    double drop =
        -clamp(sample.heightEdges(), MAX_DROP_EDGES) - clamp(curvedDrop, MAX_CURVED_DROP_EDGES);
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
