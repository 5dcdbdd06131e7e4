package org.palpate.body;

import java.util.ArrayList;
import java.util.List;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;

/**
 * The pose of a body when a scene starts, and its mobility.
 *
 * @param mobility whether and how the body can move
 * @param pose the pose, from rest to present, world mm; not to be written
 */
public record Placement(Mobility mobility, Pose pose) {

  /**
   * {@return the pose of each body as a transform, from rest to present, world mm}
   *
   * @param placements one for each body, in the order of the scene
   */
  public static List<RigidTransform> transforms(List<Placement> placements) {
    List<RigidTransform> transforms = new ArrayList<>();
    for (Placement placement : placements) {
      transforms.add(placement.pose.transform(RigidTransform.identity()));
    }
    return transforms;
  }

  /** {@return whether the body is fixed where it rests} */
  public boolean isAtRest() {
    return mobility == Mobility.FIXED && pose.sameBits(new Pose());
  }
}
