package org.palpate.benchmarks.stress;

import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.LegPath;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.volume.BitCube;

/**
 * Holds each frame of a solver against what was promised: legs that touch nothing and hang together
 * to the bit, a path within w_max, an end strictly nearer to the device or at the same bits, and
 * rest in time.
 */
final class FrameJudge {
  /** A path is a sum of rounded lengths. */
  private static final double PATH_ROUNDING = 1 + 1e-12;

  /**
   * A w_max of fewer units in the last place of a coordinate cannot be used up: how long the way to
   * rest takes is not asked there, only that each frame ends nearer.
   */
  private static final double LEAST_ULPS_A_STEP = 0x1p20;

  /** What is cut from a path so that rounding cannot make it longer than w_max, generously. */
  private static final double CUT = 1 - 0x1p-20;

  private final ExactJudge judge = new ExactJudge();
  private final BitCube bits;
  private final GridMetric metric;
  private final double maxStepMm;
  private final boolean nearerAlways;
  private final int framesToSettle;
  private final Vec3 before = new Vec3();
  private final Vec3 held = new Vec3();
  private long heldMoves;
  private long heldLongFrames;
  private double heldPathMm;
  private long legs;

  /**
   * A judge of the frames from {@code start} on.
   *
   * @param maker says what its solver promises beside the guarantee
   */
  FrameJudge(HostileScene scene, Vec3 start, SolverFactory maker) {
    nearerAlways = maker.endsNearer();
    framesToSettle = maker.framesToSettle();
    bits = scene.bits();
    metric = scene.metric();
    maxStepMm = scene.maxStepMm();
    before.set(start);
    held.set(Double.NaN, Double.NaN, Double.NaN);
  }

  long legs() {
    return legs;
  }

  long exactDecisions() {
    return judge.exactDecisions();
  }

  /**
   * What is wrong with the frame that just ended, or null.
   *
   * @param steps that it took, as the guarded solver counts them
   */
  String fault(Vec3 device, InteractionPoint point, int steps) {
    String fault = faultOfLegs(point);
    if (fault == null) {
      fault = faultOfProgress(device, point);
    }
    if (fault == null) {
      fault = faultOfRest(device, point, steps);
    }
    before.set(point.position);
    return fault;
  }

  private String faultOfLegs(InteractionPoint point) {
    LegPath path = point.legs;
    double x = before.x;
    double y = before.y;
    double z = before.z;
    for (int leg = 0; leg < path.count(); leg++) {
      legs++;
      if (!same(x, path.start(leg, 0))
          || !same(y, path.start(leg, 1))
          || !same(z, path.start(leg, 2))) {
        return "leg " + leg + " does not start where the last one ended";
      }
      if (judge.touches(bits, path, leg)) {
        return "leg " + leg + " touches a solid";
      }
      x = path.end(leg, 0);
      y = path.end(leg, 1);
      z = path.end(leg, 2);
    }
    Vec3 p = point.position;
    boolean ends = same(x, p.x) && same(y, p.y) && same(z, p.z);
    return ends ? null : "the point is not where its last leg ended";
  }

  private static boolean same(double a, double b) {
    return Double.doubleToRawLongBits(a) == Double.doubleToRawLongBits(b);
  }

  private String faultOfProgress(Vec3 device, InteractionPoint point) {
    if (point.legs.lengthMm() > maxStepMm * PATH_ROUNDING) {
      return "the path is longer than w_max: " + point.legs.lengthMm();
    }
    boolean stayed = before.sameBits(point.position);
    boolean nearer = !nearerAlways || square(point.position, device) < square(before, device);
    return stayed || nearer ? null : "the frame ended neither nearer nor at the same bits";
  }

  private String faultOfRest(Vec3 device, InteractionPoint point, int steps) {
    if (!device.sameBits(held)) {
      held.set(device);
      heldMoves = 0;
      heldLongFrames = 0;
      heldPathMm = 0;
    }
    heldPathMm += point.legs.lengthMm();
    heldLongFrames += steps > GuardedSolver.ENOUGH_STEPS ? 1 : 0;
    heldMoves += before.sameBits(point.position) ? 0 : 1;
    if (!isFine(point.position) || !isFine(device)) {
      return null;
    }
    double needed =
        Math.ceil(2 * heldPathMm / (maxStepMm * CUT)) + 2 * heldLongFrames + framesToSettle;
    return heldMoves <= needed
        ? null
        : "for a device at rest it took " + heldMoves + " frames to go " + heldPathMm + " mm";
  }

  private boolean isFine(Vec3 at) {
    double largest = Math.max(Math.abs(at.x), Math.max(Math.abs(at.y), Math.abs(at.z)));
    return Math.ulp(largest) * metric.spacingX() * LEAST_ULPS_A_STEP < maxStepMm
        && Math.ulp(largest) * metric.spacingY() * LEAST_ULPS_A_STEP < maxStepMm
        && Math.ulp(largest) * metric.spacingZ() * LEAST_ULPS_A_STEP < maxStepMm;
  }

  private double square(Vec3 from, Vec3 to) {
    return metric.squaredDistance(from.x, from.y, from.z, to.x, to.y, to.z);
  }
}
