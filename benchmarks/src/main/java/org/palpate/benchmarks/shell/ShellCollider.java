package org.palpate.benchmarks.shell;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayCaster;
import org.palpate.raycast.RayHit;

/**
 * Tests the points of a shell for collision, each along the straight way from where it was to where
 * it is. Keeps scratch: one thread an instance. Allocates nothing.
 */
public final class ShellCollider {
  private final RayCaster caster;
  private final Ray ray = new Ray();
  private final RayHit hit = new RayHit();
  private final Vec3 end = new Vec3();

  /** Tests exactly. */
  public ShellCollider() {
    this(new ExactRayCaster());
  }

  /** Tests as {@code caster} does, which belongs to this from now on. */
  public ShellCollider(RayCaster caster) {
    this.caster = caster;
  }

  /**
   * Tests a range of points.
   *
   * @param obstacles the solids, this thread's own view of them
   * @param from the first point
   * @param to one past the last
   * @param dest gets contact flag and hit of each
   * @return how many have contact
   */
  public int cast(
      CollisionScene obstacles, PointShell shell, int from, int to, ShellContacts dest) {
    int contacts = 0;
    for (int point = from; point < to; point++) {
      shell.before(point, end);
      ray.from(end.x, end.y, end.z);
      shell.now(point, end);
      if (obstacles.cast(caster, ray.to(end.x, end.y, end.z), hit)) {
        dest.put(point, hit);
        contacts++;
      } else {
        dest.clear(point);
      }
    }
    return contacts;
  }
}
