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

  /** Returns the anchor of a point that lies on a body at present. */
  public static BodyAnchor at(Vec3 worldMm, int body, List<RigidTransform> poses) {
    return body < 0 || body >= poses.size()
        ? new BodyAnchor(-1, new Vec3().set(worldMm))
        : new BodyAnchor(body, poses.get(body).inverseTransform(worldMm, new Vec3()));
  }

  /** Returns where the point is at present, world mm; a new vector. */
  public Vec3 present(List<RigidTransform> poses) {
    return body < 0 ? new Vec3().set(restMm) : poses.get(body).transform(restMm, new Vec3());
  }
}
