package org.palpate.benchmarks.shell;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayCaster;
import org.palpate.raycast.RayHit;

/**
 * Tests each point of a shell for collision on the segment from its previous to its present
 * position. Owns scratch: one thread per instance. Allocates nothing.
 */
public final class ShellCollider {
  private final RayCaster caster;
  private final Ray ray = new Ray();
  private final RayHit hit = new RayHit();
  private final Vec3 end = new Vec3();

  /** Creates an exact collider. */
  public ShellCollider() {
    this(new ExactRayCaster());
  }

  /** Creates a collider that owns the given caster. */
  public ShellCollider(RayCaster caster) {
    this.caster = caster;
  }

  /**
   * Tests a range of points.
   *
   * @param scene the solids, this thread's own view of them
   * @param from the first point
   * @param to one past the last point
   * @param dest gets the contact flag and the hit of each point
   * @return the number of points with contact
   */
  public int cast(CollisionScene scene, PointShell shell, int from, int to, ShellContacts dest) {
    int contacts = 0;
    for (int point = from; point < to; point++) {
      shell.before(point, end);
      ray.from(end.x, end.y, end.z);
      shell.now(point, end);
      if (scene.cast(caster, ray.to(end.x, end.y, end.z), hit)) {
        dest.put(point, hit);
        contacts++;
      } else {
        dest.clear(point);
      }
    }
    return contacts;
  }
}
