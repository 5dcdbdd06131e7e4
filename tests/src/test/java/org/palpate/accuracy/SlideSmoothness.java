package org.palpate.accuracy;

import java.util.List;
import org.palpate.benchmarks.accuracy.AccuracyMeter;
import org.palpate.collision.CollisionScene;
import org.palpate.force.ContactForce;
import org.palpate.force.ForceSettings;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.volume.BitCube;

/**
 * The smoothness of a slide without a known truth: along positions to their end and back, with a
 * stiffness of 1 N/mm and without friction.
 *
 * @param change root mean square of the force's change per frame, relative to the device's motion
 * @param worstChange the largest such ratio
 * @param turnDegrees root mean square angle between the forces of successive frames
 * @param worstTurnDegrees the largest such angle
 * @param stuckMm the longest motion of the device in which the point stayed within a tenth of a
 *     voxel
 * @param asymmetry root mean square difference of the forces in both directions at the same device
 *     position, relative to their mean length
 * @param contactFraction the fraction of frames with contact
 */
record SlideSmoothness(
    double change,
    double worstChange,
    double turnDegrees,
    double worstTurnDegrees,
    double stuckMm,
    double asymmetry,
    double contactFraction) {

  /** Frames at either end that are not compared, because the point still approaches. */
  private static final int SETTLING = 60;

  private static final double STUCK_VOXELS = 0.1;

  static SlideSmoothness of(
      ProxySolver solver, BitCube bits, GridMetric metric, List<Vec3> positions) {
    return new Meter(solver, bits, metric, positions).measure();
  }

  /** One run. */
  private static final class Meter {
    private final ProxySolver solver;
    private final CollisionScene scene;
    private final GridMetric metric;
    private final List<Vec3> positions;
    private final ContactForce contact;
    private final InteractionPoint point = new InteractionPoint();
    private final Vec3 force = new Vec3();
    private final Vec3 lastForce = new Vec3();
    private final Vec3 stuckAt = new Vec3(Double.NaN, 0, 0);
    private Vec3 last;
    private double stillMm;
    private double stuckMm;
    private double squaredChange;
    private double squaredMotion;
    private double worst;
    private double squaredTurn;
    private double worstTurn;
    private int contacts;
    private int frames;

    Meter(ProxySolver solver, BitCube bits, GridMetric metric, List<Vec3> positions) {
      this.solver = solver;
      this.metric = metric;
      this.positions = positions;
      scene = new CollisionScene(List.of(bits));
      contact = new ContactForce(metric, ForceSettings.of(1, 0));
    }

    SlideSmoothness measure() {
      solver.reset();
      last = positions.get(0);
      point.position.set(last);
      Vec3[] there = new Vec3[positions.size()];
      Vec3[] back = new Vec3[positions.size()];
      for (int n = 0; n < positions.size(); n++) {
        frame(n, there);
      }
      for (int n = positions.size() - 1; n >= 0; n--) {
        frame(n, back);
      }
      return new SlideSmoothness(
          Math.sqrt(squaredChange / squaredMotion),
          worst,
          Math.sqrt(squaredTurn / frames),
          worstTurn,
          stuckMm,
          asymmetry(there, back),
          contacts / (double) frames);
    }

    private void frame(int n, Vec3[] forces) {
      Vec3 device = positions.get(n);
      solver.follow(scene, device, point);
      contact.compute(point, device, force);
      forces[n] = new Vec3().set(force);
      if (n > SLIDE_BEGINS && n < positions.size() - 1) {
        count(metric.distance(last.x, last.y, last.z, device.x, device.y, device.z));
      }
      last = device;
      lastForce.set(force);
    }

    private void count(double motionMm) {
      frames++;
      contacts += point.contact ? 1 : 0;
      double change = force.sub(lastForce, new Vec3()).length();
      squaredChange += change * change;
      squaredMotion += motionMm * motionMm;
      worst = Math.max(worst, motionMm > 0 ? change / motionMm : 0);
      double turn = turnDegrees();
      squaredTurn += turn * turn;
      worstTurn = Math.max(worstTurn, turn);
      Vec3 p = point.position;
      double from = metric.distance(stuckAt.x, stuckAt.y, stuckAt.z, p.x, p.y, p.z);
      if (from < STUCK_VOXELS * metric.shortestEdgeMm()) {
        stillMm += motionMm;
      } else {
        stuckAt.set(p);
        stillMm = 0;
      }
      stuckMm = Math.max(stuckMm, stillMm);
    }

    private double turnDegrees() {
      double length = lastForce.length();
      return length > 0
          ? AccuracyMeter.angleDegrees(force, lastForce.mul(1 / length, new Vec3()))
          : 0;
    }

    private static double asymmetry(Vec3[] there, Vec3[] back) {
      double squared = 0;
      double lengths = 0;
      int count = 0;
      for (int n = SLIDE_BEGINS + SETTLING; n < there.length - SETTLING; n++) {
        double difference = there[n].sub(back[n], new Vec3()).length();
        squared += difference * difference;
        lengths += there[n].length();
        count++;
      }
      return Math.sqrt(squared / count) / (lengths / count);
    }
  }

  /** The number of frames of the approach. */
  private static final int SLIDE_BEGINS = 100;
}
