package org.palpate.benchmarks.rigid;

import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;

/** A method that moves a tool of many points, to compare methods on one scene of unit voxels. */
interface PeerTool {
  /** Places the tool at a free pose. */
  void place(Pose pose);

  /** Runs one frame. */
  void follow(Pose device);

  /** Writes the direction and the size of the force on the hand, up to a factor. */
  Vec3 force(Pose device, Vec3 dest);

  /** Returns the number of points. */
  int count();

  /** Writes the position of a point after the last frame, world mm. */
  Vec3 point(int index, Vec3 dest);
}
