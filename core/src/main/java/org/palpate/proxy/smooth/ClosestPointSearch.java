package org.palpate.proxy.smooth;

import org.palpate.geometry.Vec3;
import org.palpate.proxy.smooth.field.IsoLevel;
import org.palpate.proxy.smooth.field.OccupancyField;

/**
 * Finds the point of the level surface that is nearest to the device, by Newton's method with the
 * curvature from the Hessian. What it visits is virtual: nothing moves.
 *
 * <p>A step solves (I - depth K) t = u in the tangent plane, K the curvature of the level surface
 * and u the tangential part of the way to the device, and drops along the normal by the height
 * above the level and by t K t / 2. Near a centre of curvature steps overshoot: one that brings
 * little halves those that follow.
 *
 * <p>References: the god object, Zilles and Salisbury 1995; proxies on implicit surfaces, Salisbury
 * and Tarr 1997; on volumes, Chan et al. 2011.
 */
final class ClosestPointSearch {
  /** The nearest point was found. */
  static final int FOUND = 0;

  /** The device lies above the tangent plane of the point that was visited last. */
  static final int OUTSIDE = 1;

  /**
   * The next step would lead farther than {@link #REACH_EDGES}, or enough windows were read; the
   * last visited point is kept.
   */
  static final int FAR = 2;

  /** The field is too flat here, or the level too far away, to say where its surface runs. */
  static final int LOST = 3;

  /** How far from its start a search goes; what the start cannot reach is judged in windows. */
  static final double REACH_EDGES = 3;

  /** Slope below which a direction means nothing, an edge. */
  static final double LEAST_SLOPE = 0.02;

  private static final double TOLERANCE_EDGES = 2e-3;

  /** Of the way that the first step has to go: what is left of it is gone in the next frame. */
  private static final double TOLERANCE_SHARE = 0.01;

  private static final double DEEPEST_EDGES = 1.6;
  private static final int MOST_STEPS = 12;
  private static final double LONGEST_STEP_EDGES = 2.2;
  private static final double LONGEST_DROP_EDGES = 1;
  private static final double LARGEST_BEND_EDGES = 0.5;

  /** A step that leaves more than this share of the offset makes the next ones shorter. */
  private static final double SLOW_SHARE = 0.7;

  /** Offsets below this are no way to anywhere. */
  private static final double LEAST_OFFSET_EDGES = 1e-12;

  /** A search that is nearer is all but done: to leave it to the next frame would be felt. */
  private static final double FAR_OFF_EDGES = 2;

  /** But not for the price of more windows than this. */
  static final int SOME_WINDOWS = 5;

  private static final double LEAST_DAMPING = 0.25;

  /** Keeps the tangential system positive definite near centres of curvature. */
  private static final double LEAST_DIAGONAL = 0.35;

  private static final double MOST_COUPLING_SQUARED = 0.8 * 0.8;

  /** The point that was visited last, grid coordinates. */
  final Vec3 at = new Vec3();

  /** The unit normal there, outward, metric. */
  final Vec3 normal = new Vec3();

  /** The height of the visited point over the level, edges. */
  double heightEdges;

  private final OccupancyField field;
  private final IsoLevel level;
  private final Vec3 edges;
  private final Vec3 voxelsAnEdge;
  private final Vec3 toDevice = new Vec3();
  private final Vec3 tangent = new Vec3();
  private final Vec3 step = new Vec3();
  private long normalOf = -1;
  private double slope;
  private double edgesAShare;
  private double depth;

  /** The square of the tangential distance from the visited point to the foot of the device. */
  private double offsetSquare;

  ClosestPointSearch(OccupancyField field, IsoLevel level, Vec3 edges) {
    this.field = field;
    this.level = level;
    this.edges = edges;
    voxelsAnEdge = new Vec3(1 / edges.x, 1 / edges.y, 1 / edges.z);
  }

  /**
   * Searches from {@code start}; the field must be seeded and stands at {@link #at} afterwards.
   *
   * @param enoughWindows a search that has gone a step and is still far off ends once the field has
   *     read so many; {@link #SOME_WINDOWS} later, wherever it is
   * @return one of the four answers
   */
  int search(Vec3 start, Vec3 device, long enoughWindows) {
    at.set(start);
    double damping = 1;
    double lastSquare = Double.POSITIVE_INFINITY;
    double tolerance = 0; // a square, as all offsets here
    for (int n = 0; n < MOST_STEPS; n++) {
      field.evaluate(at.x, at.y, at.z);
      if (!findNormal() || heightEdges < -DEEPEST_EDGES) {
        return LOST;
      }
      if (!project(device)) {
        return OUTSIDE;
      }
      if (offsetSquare <= tolerance && heightEdges * heightEdges <= tolerance) {
        return FOUND;
      }
      if (offsetSquare > SLOW_SHARE * SLOW_SHARE * lastSquare) {
        damping = Math.max(LEAST_DAMPING, damping / 2);
      }
      if (n == 0) {
        tolerance =
            Math.max(
                TOLERANCE_EDGES * TOLERANCE_EDGES,
                TOLERANCE_SHARE * TOLERANCE_SHARE * offsetSquare);
      }
      lastSquare = offsetSquare;
      findStep(damping);
      if (n > 0 && (isEnough(enoughWindows) || leavesReach(start))) {
        return FAR;
      }
      takeStep();
    }
    field.evaluate(at.x, at.y, at.z);
    return findNormal() && project(device) ? FOUND : LOST;
  }

  /** Finds normal and height where the field stands; false where the field is too flat. */
  boolean findNormal() {
    if (field.evaluation == normalOf) {
      return slope >= LEAST_SLOPE;
    }
    normalOf = field.evaluation;
    slope = Math.sqrt(field.gx * field.gx + field.gy * field.gy + field.gz * field.gz);
    if (slope < LEAST_SLOPE) {
      return false;
    }
    edgesAShare = 1 / slope;
    normal.set(-field.gx * edgesAShare, -field.gy * edgesAShare, -field.gz * edgesAShare);
    heightEdges = (level.share(normal) - field.value) * edgesAShare;
    return true;
  }

  /** The sum of the level's principal curvatures there, an edge; positive where it bulges out. */
  double sumOfCurvatures() {
    double along =
        normal.x * (field.hxx * normal.x + 2 * field.hxy * normal.y)
            + normal.y * (field.hyy * normal.y + 2 * field.hyz * normal.z)
            + normal.z * (field.hzz * normal.z + 2 * field.hxz * normal.x);
    return (along - field.hxx - field.hyy - field.hzz) * edgesAShare;
  }

  /** Splits the way to the device along normal and tangent plane; false when it lies above. */
  private boolean project(Vec3 device) {
    device.sub(at, toDevice);
    toDevice.set(toDevice.x * edges.x, toDevice.y * edges.y, toDevice.z * edges.z);
    double along = toDevice.dot(normal);
    depth = -along - heightEdges;
    tangent.set(
        toDevice.x - along * normal.x,
        toDevice.y - along * normal.y,
        toDevice.z - along * normal.z);
    offsetSquare = tangent.dot(tangent);
    return depth > 0;
  }

  private void findStep(double damping) {
    double bend = 0;
    if (offsetSquare > LEAST_OFFSET_EDGES * LEAST_OFFSET_EDGES) {
      bend = curvedStep(damping);
    } else {
      step.set(0, 0, 0);
    }
    double drop = -clamp(heightEdges, LONGEST_DROP_EDGES) - clamp(bend, LARGEST_BEND_EDGES);
    step.set(step.x + drop * normal.x, step.y + drop * normal.y, step.z + drop * normal.z);
  }

  /**
   * Writes the tangential step; returns how much the surface falls off along it. In the basis of
   * the way to the foot, a, and of b, as long and at right angles to it: neither is made a unit.
   */
  private double curvedStep(double damping) {
    double ax = tangent.x;
    double ay = tangent.y;
    double az = tangent.z;
    double bx = normal.y * az - normal.z * ay;
    double by = normal.z * ax - normal.x * az;
    double bz = normal.x * ay - normal.y * ax;
    double hax = field.hxx * ax + field.hxy * ay + field.hxz * az;
    double hay = field.hxy * ax + field.hyy * ay + field.hyz * az;
    double haz = field.hxz * ax + field.hyz * ay + field.hzz * az;
    double hbx = field.hxx * bx + field.hxy * by + field.hxz * bz;
    double hby = field.hxy * bx + field.hyy * by + field.hyz * bz;
    double hbz = field.hxz * bx + field.hyz * by + field.hzz * bz;
    double toCurvature = -edgesAShare / offsetSquare;
    double curvatureA = (ax * hax + ay * hay + az * haz) * toCurvature;
    double curvatureAb = (bx * hax + by * hay + bz * haz) * toCurvature;
    double curvatureB = (bx * hbx + by * hby + bz * hbz) * toCurvature;
    double diagonalA = atLeast(LEAST_DIAGONAL, 1 - depth * curvatureA);
    double diagonalB = atLeast(LEAST_DIAGONAL, 1 - depth * curvatureB);
    double coupling = within(-depth * curvatureAb, MOST_COUPLING_SQUARED * diagonalA * diagonalB);
    double share = damping / (diagonalA * diagonalB - coupling * coupling);
    double alongA = share * diagonalB;
    double alongB = -share * coupling;
    double squared = (alongA * alongA + alongB * alongB) * offsetSquare;
    if (squared > LONGEST_STEP_EDGES * LONGEST_STEP_EDGES) {
      double shorter = LONGEST_STEP_EDGES / Math.sqrt(squared);
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

  private boolean isEnough(long enoughWindows) {
    return field.windows >= enoughWindows
        && (offsetSquare > FAR_OFF_EDGES * FAR_OFF_EDGES
            || field.windows >= enoughWindows + SOME_WINDOWS);
  }

  private boolean leavesReach(Vec3 start) {
    double x = (at.x - start.x) * edges.x + step.x;
    double y = (at.y - start.y) * edges.y + step.y;
    double z = (at.z - start.z) * edges.z + step.z;
    return x * x + y * y + z * z > REACH_EDGES * REACH_EDGES;
  }

  private void takeStep() {
    at.set(
        at.x + step.x * voxelsAnEdge.x,
        at.y + step.y * voxelsAnEdge.y,
        at.z + step.z * voxelsAnEdge.z);
  }

  /** The value, or one as long as the root of {@code squared} where it is longer. */
  private static double within(double value, double squared) {
    return value * value <= squared ? value : Math.copySign(Math.sqrt(squared), value);
  }

  // By comparisons that are foreseen: Math.min and max of doubles wait for their numbers.

  private static double clamp(double value, double limit) {
    return Math.abs(value) <= limit ? value : Math.copySign(limit, value);
  }

  private static double atLeast(double least, double value) {
    return value >= least ? value : least;
  }
}
