package org.palpate.proxy.reference;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayCaster;
import org.palpate.raycast.RayHit;
import org.palpate.statistics.SkipCounters;
import org.palpate.statistics.SkipKind;

/**
 * Collision detection without a response: p is the device position, even inside a solid. The
 * contact flag reports whether the last motion hit a solid. w_max does not bound the motion.
 *
 * <p>Haptic thread. Cost: one ray a frame.
 */
public final class CollisionOnlySolver implements ProxySolver {
  private final RayCaster caster;
  private final GridMetric metric;
  private final Ray ray = new Ray();
  private final RayHit hit = new RayHit();
  private long frames;

  /**
   * Creates a solver.
   *
   * @param caster decides whether the motion of a frame hit a solid
   * @param metric the spacing of the grid
   */
  public CollisionOnlySolver(RayCaster caster, GridMetric metric) {
    this.caster = caster;
    this.metric = metric;
  }

  @Override
  public void addSkips(SkipCounters dest) {
    dest.add(SkipKind.RESPONSE, frames);
    if (caster instanceof ExactRayCaster exact) {
      exact.addSkips(dest);
    }
  }

  @Override
  public void follow(CollisionScene scene, Vec3 device, InteractionPoint point) {
    frames++;
    Vec3 p = point.position;
    ray.from(p.x, p.y, p.z).to(device.x, device.y, device.z);
    point.contact = scene.cast(caster, ray, hit);
    point.legs.clear();
    if (!p.sameBits(device)) {
      double lengthMm = metric.distance(p.x, p.y, p.z, device.x, device.y, device.z);
      point.legs.add(p.x, p.y, p.z, device.x, device.y, device.z, lengthMm, false);
      p.set(device);
    }
  }
}
