package org.palpate.frame;

import org.palpate.body.BodyScene;
import org.palpate.edit.ToolPlace;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.BlockingVoxels;
import org.palpate.rigid.ToolMotion;

/** The place of a rigid tool among bodies, for edits. Haptic thread only; allocates nothing. */
final class RigidPlace implements ToolPlace {
  private final BodyScene bodies;
  private final BlockingVoxels blocking;
  private final ToolMotion motion;
  private final Pose device;
  private final Pose atRest = new Pose();

  /** For each body the map from its grid coordinates to its rest position, world mm. */
  private final AffineMap[] gridToRest;

  private final AffineMap map = new AffineMap();
  private final AffineMap scratch = new AffineMap();
  private boolean isPlaced;

  /**
   * Creates the place of a tool that has none yet.
   *
   * @param motion the motion of the tool, which the solver writes
   * @param device the device pose, which the frame writes
   */
  RigidPlace(BodyScene bodies, BlockingVoxels blocking, ToolMotion motion, Pose device) {
    this.bodies = bodies;
    this.blocking = blocking;
    this.motion = motion;
    this.device = device;
    gridToRest = new AffineMap[bodies.count()];
    for (int n = 0; n < gridToRest.length; n++) {
      gridToRest[n] = bodies.body(n).grid().gridToWorld(new AffineMap());
    }
  }

  /** Notes that the tool has a place from now on. */
  void place() {
    isPlaced = true;
  }

  /** Whether the tool has a place. */
  boolean isPlaced() {
    return isPlaced;
  }

  /** Returns the finder of the voxels that block the tool. */
  BlockingVoxels blocking() {
    return blocking;
  }

  @Override
  public boolean touchedPoint(int segment, Vec3 destGrid) {
    if (isPlaced) {
      if (motion.contacts().count() > 0) {
        motion.contactMm(0, destGrid);
      } else {
        destGrid.set(motion.pose().translation);
      }
      worldToGrid(segment, destGrid);
    }
    return isPlaced;
  }

  @Override
  public boolean devicePosition(int segment, Vec3 destGrid) {
    if (isPlaced) {
      worldToGrid(segment, destGrid.set(device.translation));
    }
    return isPlaced;
  }

  private void worldToGrid(int segment, Vec3 point) {
    bodies.body(segment).toolToGrid(atRest, map).transform(point, point);
  }

  @Override
  public boolean gridToDevice(int segment, AffineMap dest) {
    if (isPlaced) {
      map.set(bodies.body(segment).pose()).multiply(gridToRest[segment], scratch);
      map.setInverse(device).multiply(scratch, dest);
    }
    return isPlaced;
  }

  @Override
  public boolean meets(int segment, int i, int j, int k) {
    return isPlaced && blocking.meets(segment, i, j, k);
  }
}
