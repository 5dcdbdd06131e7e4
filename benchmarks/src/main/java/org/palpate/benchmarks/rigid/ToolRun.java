package org.palpate.benchmarks.rigid;

import org.palpate.body.BodyScene;
import org.palpate.geometry.Pose;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.ToolMotion;
import org.palpate.rigid.tool.RigidTool;

/** A tool that follows device poses among bodies. One thread. */
final class ToolRun {
  /** Frames at rest after which a tool that still moves counts as restless. */
  private static final int MOST_FRAMES_TO_REST = 400;

  /** Frames that must repeat the same bits before the tool counts as resting. */
  private static final int FRAMES_AT_REST = 20;

  final BodyScene bodies;
  final RigidTool tool;
  final RigidSolver solver;
  final ToolMotion motion = new ToolMotion();

  ToolRun(BodyScene bodies, RigidTool tool, RigidSettings settings) {
    this.bodies = bodies;
    this.tool = tool;
    solver = new RigidSolver(bodies, tool, settings);
  }

  ToolRun(BodyScene bodies, RigidTool tool, ToolClearance clearance) {
    this(bodies, tool, clearance.settings(bodies, tool));
  }

  /**
   * Places the tool.
   *
   * @throws IllegalStateException if the pose is not free; studies start in free space
   */
  void start(Pose pose) {
    if (!solver.place(pose, motion)) {
      throw new IllegalStateException("a study must start in free space: pose=" + pose);
    }
  }

  void follow(Pose device) {
    solver.follow(device, motion);
  }

  /** Returns the distance between the tool and a device pose in the kinetic metric, mm. */
  double behindMm(Pose device) {
    return tool.metric().distance(motion.pose(), device);
  }

  /**
   * Holds the device still.
   *
   * @return the number of frames until the tool keeps its bits; {@link #MOST_FRAMES_TO_REST} if it
   *     never does
   */
  int framesToRest(Pose device) {
    Pose last = new Pose();
    int moved = 0;
    for (int frame = 1; frame <= MOST_FRAMES_TO_REST; frame++) {
      last.set(motion.pose());
      follow(device);
      if (!last.sameBits(motion.pose())) {
        moved = frame;
      } else if (frame - moved >= FRAMES_AT_REST) {
        return moved;
      }
    }
    return MOST_FRAMES_TO_REST;
  }
}
