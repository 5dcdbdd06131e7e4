package org.palpate.proxy;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayHit;

/**
 * Finds the object that stops the interaction point on its straight segment to the device. Works
 * with every solver.
 *
 * <p>Haptic thread; allocates nothing. Cost: one exact ray.
 */
public final class TouchedObjectFinder {
  private final ExactRayCaster caster = new ExactRayCaster();
  private final Ray ray = new Ray();
  private final RayHit hit = new RayHit();

  /**
   * Writes {@link InteractionPoint#touchedObject}: the object that the ray hits first, and the
   * first of several objects that share the voxel. Writes {@link InteractionPoint#NO_OBJECT}
   * without contact, or if no solid lies between the point and the device.
   *
   * @param scene the solids
   * @param device the device position, grid coordinates
   * @param point read, and its touched object is written
   */
  public void find(CollisionScene scene, Vec3 device, InteractionPoint point) {
    Vec3 p = point.position;
    point.touchedObject = InteractionPoint.NO_OBJECT;
    if (point.contact
        && device.isFinite()
        && scene.cast(caster, ray.from(p.x, p.y, p.z).to(device.x, device.y, device.z), hit)) {
      point.touchedObject = scene.objectAt(hit.i, hit.j, hit.k);
    }
  }
}
