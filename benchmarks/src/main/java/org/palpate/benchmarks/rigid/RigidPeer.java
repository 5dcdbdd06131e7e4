package org.palpate.benchmarks.rigid;

import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;

/** The rigid tool of this project, as one of the compared methods. */
final class RigidPeer implements PeerTool {
  private final ToolRun run;

  RigidPeer(ToolRun run) {
    this.run = run;
  }

  @Override
  public void place(Pose pose) {
    run.start(pose);
  }

  @Override
  public void follow(Pose device) {
    run.follow(device);
  }

  @Override
  public Vec3 force(Pose device, Vec3 dest) {
    return run.motion.pose().translation.sub(device.translation, dest);
  }

  @Override
  public int count() {
    return run.tool.count();
  }

  @Override
  public Vec3 point(int index, Vec3 dest) {
    return run.motion.pose().transform(run.tool.point(index, dest), dest);
  }
}
