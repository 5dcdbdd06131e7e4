package org.palpate.host.placing;

import java.util.List;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/**
 * A point that moves with a body.
 *
 * @param body index of the body; negative if the point stays where it is
 * @param restMm the point where the body rests, world mm; not to be written
 */
public record BodyAnchor(int body, Vec3 restMm) {

  /**
   * {@return the anchor of a point that lies on a body at present}
   *
   * @param worldMm where the point is at present, world mm
   * @param body the index of the body; if there is none, the point stays where it is
   * @param poses the present pose of each body, from rest to present, world mm
   */
  public static BodyAnchor at(Vec3 worldMm, int body, List<RigidTransform> poses) {
    return body < 0 || body >= poses.size()
        ? new BodyAnchor(-1, new Vec3().set(worldMm))
        : new BodyAnchor(body, poses.get(body).inverseTransform(worldMm, new Vec3()));
  }

  /**
   * {@return where the point is at present, world mm; a new vector}
   *
   * @param poses the present pose of each body, from rest to present, world mm
   */
  public Vec3 present(List<RigidTransform> poses) {
    return body < 0 ? new Vec3().set(restMm) : poses.get(body).transform(restMm, new Vec3());
  }
}
