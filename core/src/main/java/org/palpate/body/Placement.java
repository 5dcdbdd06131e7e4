package org.palpate.body;

import java.util.ArrayList;
import java.util.List;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.volume.VoxelGrid;

/**
 * The pose of a body when a scene starts, and its mobility.
 *
 * @param mobility whether and how the body can move
 * @param pose the pose, from rest to present, world mm; not to be written
 */
public record Placement(Mobility mobility, Pose pose) {

  /**
   * Returns the pose of each body in the world, from the millimetres of its grid.
   *
   * @param grid the grid of all bodies at rest
   */
  public static List<RigidTransform> poses(List<Placement> placements, VoxelGrid grid) {
    List<RigidTransform> poses = new ArrayList<>();
    for (Placement placement : placements) {
      poses.add(placement.applyTo(grid.gridMmToWorld()));
    }
    return poses;
  }

  private RigidTransform applyTo(RigidTransform toRest) {
    return new RigidTransform(
        pose.rotation.rotate(toRest.axisX(), new Vec3()),
        pose.rotation.rotate(toRest.axisY(), new Vec3()),
        pose.rotation.rotate(toRest.axisZ(), new Vec3()),
        pose.transform(toRest.origin(), new Vec3()));
  }
}
