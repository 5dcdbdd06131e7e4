package org.palpate.accuracy;

import java.util.List;
import org.palpate.collision.CollisionScene;
import org.palpate.force.ContactForce;
import org.palpate.force.ForceSettings;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.volume.BitCube;

/**
 * What a slide feels like where no truth is known: along a way to its end and back again, at a
 * stiffness of 1 N/mm, without friction.
 *
 * @param change root mean square of the force's change over that of the device's motion, from frame
 *     to frame
 * @param worstChange the largest such ratio
 * @param stuckMm the longest way of the device on which the point stayed within a tenth of a voxel
 * @param asymmetry root mean square difference of the forces there and back at the same place of
 *     the device, over their mean length
 * @param contactShare frames of the slide in contact
 */
record SlideSmoothness(
    double change, double worstChange, double stuckMm, double asymmetry, double contactShare) {

  /** Frames at either end that are not compared: the point is still on its way. */
  private static final int SETTLING = 60;

  private static final double STAYS_VOXELS = 0.1;

  static SlideSmoothness of(ProxySolver solver, BitCube bits, GridMetric metric, List<Vec3> way) {
    return new Meter(solver, bits, metric, way).measure();
  }

  /** One run. */
  private static final class Meter {
    private final ProxySolver solver;
    private final CollisionScene obstacles;
    private final GridMetric metric;
    private final List<Vec3> way;
    private final ContactForce contact;
    private final InteractionPoint point = new InteractionPoint();
    private final Vec3 force = new Vec3();
    private final Vec3 lastForce = new Vec3();
    private final Vec3 heldAt = new Vec3(Double.NaN, 0, 0);
    private Vec3 last;
    private double heldMm;
    private double stuckMm;
    private double squaredChange;
    private double squaredMotion;
    private double worst;
    private int contacts;
    private int frames;

    Meter(ProxySolver solver, BitCube bits, GridMetric metric, List<Vec3> way) {
      this.solver = solver;
      this.metric = metric;
      this.way = way;
      obstacles = new CollisionScene(List.of(bits));
      contact = new ContactForce(metric, ForceSettings.of(1, 0));
    }

    SlideSmoothness measure() {
      solver.reset();
      last = way.get(0);
      point.position.set(last);
      Vec3[] there = new Vec3[way.size()];
      Vec3[] back = new Vec3[way.size()];
      for (int n = 0; n < way.size(); n++) {
        frame(n, there);
      }
      for (int n = way.size() - 1; n >= 0; n--) {
        frame(n, back);
      }
      return new SlideSmoothness(
          Math.sqrt(squaredChange / squaredMotion),
          worst,
          stuckMm,
          asymmetry(there, back),
          contacts / (double) frames);
    }

    private void frame(int n, Vec3[] forces) {
      Vec3 device = way.get(n);
      solver.follow(obstacles, device, point);
      contact.compute(point, device, force);
      forces[n] = new Vec3().set(force);
      if (n > SLIDE_BEGINS && n < way.size() - 1) {
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
      Vec3 p = point.position;
      double from = metric.distance(heldAt.x, heldAt.y, heldAt.z, p.x, p.y, p.z);
      if (from < STAYS_VOXELS * metric.shortestEdgeMm()) {
        heldMm += motionMm;
      } else {
        heldAt.set(p);
        heldMm = 0;
      }
      stuckMm = Math.max(stuckMm, heldMm);
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

  /** Frames of the approach. */
  private static final int SLIDE_BEGINS = 100;
}
