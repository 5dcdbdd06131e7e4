package org.palpate.proxy;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayHit;

/**
 * Finds which object stops the interaction point on its straight way to the device, whatever the
 * solver. Haptic thread; allocates nothing; one exact ray.
 */
public final class TouchedObjectFinder {
  private final ExactRayCaster caster = new ExactRayCaster();
  private final Ray ray = new Ray();
  private final RayHit hit = new RayHit();

  /**
   * Writes {@link InteractionPoint#touched}: the object hit first, the first of several that share
   * the voxel; {@link InteractionPoint#NOTHING} without contact or where the way is free.
   */
  public void find(CollisionScene obstacles, Vec3 device, InteractionPoint point) {
    Vec3 p = point.position;
    point.touched = InteractionPoint.NOTHING;
    if (point.contact
        && device.isFinite()
        && obstacles.cast(caster, ray.from(p.x, p.y, p.z).to(device.x, device.y, device.z), hit)) {
      point.touched = obstacles.objectAt(hit.i, hit.j, hit.k);
    }
  }
}
