package org.palpate.benchmarks.stress;

import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.LegPath;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.volume.BitCube;

/**
 * Checks each frame of a solver against its promises: legs that touch nothing and connect bit for
 * bit, a path within w_max, an end that is strictly nearer to the device or has the same bits, and
 * rest after a bounded number of frames.
 */
final class FrameJudge {
  /** Tolerance of a path length, which is a sum of rounded lengths. */
  private static final double PATH_ROUNDING = 1 + 1e-12;

  /**
   * A w_max below this many units in the last place of a coordinate cannot be used up. The number
   * of frames until rest is not checked there, only that each frame ends nearer.
   */
  private static final double MIN_ULPS_PER_STEP = 0x1p20;

  /** A generous bound of the cut that keeps a rounded path within w_max. */
  private static final double CUT = 1 - 0x1p-20;

  private final ExactJudge judge = new ExactJudge();
  private final BitCube bits;
  private final GridMetric metric;
  private final double maxStepMm;
  private final boolean nearerAlways;
  private final int framesToSettle;
  private final Vec3 before = new Vec3();
  private final Vec3 restDevice = new Vec3();
  private long restMoves;
  private long restLongFrames;
  private double restPathMm;
  private long legs;

  /**
   * Creates a judge of the frames from {@code start} on.
   *
   * @param factory the solver's promises besides the guarantee
   */
  FrameJudge(HostileScene scene, Vec3 start, SolverFactory factory) {
    nearerAlways = factory.endsNearer();
    framesToSettle = factory.framesToSettle();
    bits = scene.bits();
    metric = scene.metric();
    maxStepMm = scene.maxStepMm();
    before.set(start);
    restDevice.set(Double.NaN, Double.NaN, Double.NaN);
  }

  /** Returns the number of judged legs. */
  long legs() {
    return legs;
  }

  /** Returns how often doubles did not suffice. */
  long exactDecisions() {
    return judge.exactDecisions();
  }

  /**
   * Returns the fault of the frame that just ended, or null.
   *
   * @param steps the frame's work, as the guarded solver counts it
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
    if (!device.sameBits(restDevice)) {
      restDevice.set(device);
      restMoves = 0;
      restLongFrames = 0;
      restPathMm = 0;
    }
    restPathMm += point.legs.lengthMm();
    restLongFrames += steps > GuardedSolver.STEP_BUDGET ? 1 : 0;
    restMoves += before.sameBits(point.position) ? 0 : 1;
    if (!resolvesSteps(point.position) || !resolvesSteps(device)) {
      return null;
    }
    double needed =
        Math.ceil(2 * restPathMm / (maxStepMm * CUT)) + 2 * restLongFrames + framesToSettle;
    return restMoves <= needed
        ? null
        : "with a resting device it took " + restMoves + " frames to move " + restPathMm + " mm";
  }

  private boolean resolvesSteps(Vec3 at) {
    double largest = Math.max(Math.abs(at.x), Math.max(Math.abs(at.y), Math.abs(at.z)));
    return Math.ulp(largest) * metric.spacingX() * MIN_ULPS_PER_STEP < maxStepMm
        && Math.ulp(largest) * metric.spacingY() * MIN_ULPS_PER_STEP < maxStepMm
        && Math.ulp(largest) * metric.spacingZ() * MIN_ULPS_PER_STEP < maxStepMm;
  }

  private double square(Vec3 from, Vec3 to) {
    return metric.squaredDistance(from.x, from.y, from.z, to.x, to.y, to.z);
  }
}
