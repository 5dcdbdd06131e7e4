package org.palpate.reduction;

import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayHit;

/** Finds out whether straight lines touch bodies of a scene. World mm. One thread. */
final class FreeLines {
  private final BodyScene scene;
  private final ExactRayCaster caster = new ExactRayCaster();
  private final Ray ray = new Ray();
  private final RayHit hit = new RayHit();
  private final AffineMap toGrid = new AffineMap();
  private final Pose world = new Pose();
  private final Vec3 gridFrom = new Vec3();
  private final Vec3 gridTo = new Vec3();

  FreeLines(BodyScene scene) {
    this.scene = scene;
  }

  /** Whether a straight line touches no body at its present pose. */
  boolean isFree(Vec3 from, Vec3 to) {
    return isFreeBut(-1, from, to);
  }

  /** Whether a straight line touches no other body than one at its present pose. */
  boolean isFreeBut(int one, Vec3 from, Vec3 to) {
    for (int n = 0; n < scene.count(); n++) {
      if (n != one && touches(n, from, to)) {
        return false;
      }
    }
    return true;
  }

  /** Whether a point lies in a solid voxel of a body. */
  boolean isSolid(int index, Vec3 point) {
    return touches(index, point, point);
  }

  private boolean touches(int index, Vec3 from, Vec3 to) {
    Body body = scene.body(index);
    body.toolToGrid(world, toGrid);
    toGrid.transform(from, gridFrom);
    toGrid.transform(to, gridTo);
    ray.from(gridFrom.x, gridFrom.y, gridFrom.z).to(gridTo.x, gridTo.y, gridTo.z);
    return caster.cast(body.bits(), ray, hit);
  }
}
