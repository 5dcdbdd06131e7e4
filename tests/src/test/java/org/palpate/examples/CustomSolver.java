package org.palpate.examples;

import org.palpate.collision.CollisionScene;
import org.palpate.device.ReplayDevice;
import org.palpate.device.Trajectory;
import org.palpate.edit.EditQueue;
import org.palpate.force.ForceSettings;
import org.palpate.frame.FrameOutcome;
import org.palpate.frame.FramePublisher;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.GridDevice;
import org.palpate.frame.PointFrame;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayHit;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.phantom.Phantom;

/** A solver of your own: it moves straight towards the device and stops before the first solid. */
public final class CustomSolver implements ProxySolver {
  private static final double FRACTION_TO_SOLID = 0.99;

  private final GridMetric metric;
  private final double maxPathMm;
  private final ExactRayCaster caster = new ExactRayCaster();
  private final Ray ray = new Ray();
  private final RayHit hit = new RayHit();
  private final Vec3 goal = new Vec3();

  private CustomSolver(GridMetric metric, double maxPathMm) {
    this.metric = metric;
    this.maxPathMm = maxPathMm;
  }

  @Override
  public void follow(CollisionScene scene, Vec3 device, InteractionPoint point) {
    Vec3 p = point.position;
    point.legs.clear();
    point.contact = isBlocked(scene, p, device);
    double distanceMm = metric.distance(p.x, p.y, p.z, device.x, device.y, device.z);
    double fraction =
        Math.min(point.contact ? FRACTION_TO_SOLID * hit.t : 1, maxPathMm / distanceMm);

    // Propose, verify, commit: rounding may have moved the goal, so its leg has its own test.
    device.sub(p, goal).mul(fraction, goal).add(p, goal);
    if (!goal.sameBits(p) && goal.isFinite() && !isBlocked(scene, p, goal)) {
      double lengthMm = metric.distance(p.x, p.y, p.z, goal.x, goal.y, goal.z);
      point.legs.add(p.x, p.y, p.z, goal.x, goal.y, goal.z, lengthMm, false);
      p.set(goal);
    }
  }

  private boolean isBlocked(CollisionScene scene, Vec3 from, Vec3 to) {
    return scene.cast(caster, ray.from(from.x, from.y, from.z).to(to.x, to.y, to.z), hit);
  }

  /** Pushes a device through a sphere, in grid coordinates, with the module core alone. */
  public static void main(String[] args) {
    SegmentedVolume volume = Phantom.parse("sphere:64").segments();
    Trajectory trajectory = new Trajectory();
    for (int ms = 0; ms <= 1000; ms++) {
      trajectory.add(ms, 32, 32, 64 - 0.064 * ms);
    }
    GridMetric metric = GridMetric.of(volume.grid().spacingMm());
    ReplayDevice device = new ReplayDevice("push", trajectory);
    PointFrame frame =
        new PointFrame(
            GridDevice.inGridCoordinates(device),
            new CustomSolver(metric, 3),
            new CollisionScene(volume.segments().stream().map(s -> s.bits()).toList()),
            metric,
            FrameSettings.live(device.specification(), ForceSettings.of(0.5, 0)),
            new EditQueue(volume.grid(), volume.segments().size()),
            FramePublisher.NONE);
    for (long ms = 0; frame.run(ms * 1_000_000) == FrameOutcome.RUNNING; ms++) {
      if (ms % 100 == 0) {
        System.out.println(ms + " ms: " + frame.point().position + " " + frame.forceNewton());
      }
    }
  }
}
