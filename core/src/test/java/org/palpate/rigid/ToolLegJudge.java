package org.palpate.rigid;

import org.palpate.body.BodyScene;
import org.palpate.geometry.Pose;
import org.palpate.rigid.tool.RigidTool;

/**
 * Judges frame after frame whether a rigid tool kept the guarantee: each step starts bit for bit at
 * the pose where the last one ended, and no leg of any point touches a voxel of any body, in exact
 * arithmetic. It sees the committed poses alone, not what verification looked at.
 */
final class ToolLegJudge {
  private final NaiveVerifier naive;
  private final Pose end = new Pose();

  ToolLegJudge(BodyScene scene, RigidTool tool) {
    naive = new NaiveVerifier(scene, tool);
  }

  long legs() {
    return naive.legs();
  }

  /** Begins a new chain of legs; returns a point that touches a voxel there, or null. */
  String begin(ToolMotion motion) {
    end.set(motion.pose());
    return naive.fault(end, end);
  }

  /** Begins a chain of legs at the beginning of a frame, as {@link #begin} does. */
  String beginOfFrame(ToolMotion motion) {
    end.set(motion.pathPose(0));
    return naive.fault(end, end);
  }

  /** Returns what is wrong with the last frame, or null. */
  String fault(ToolMotion motion) {
    if (motion.freed()) {
      end.set(motion.pathPose(0));
      String buried = naive.fault(end, end);
      if (buried != null) {
        return "set free in a solid: " + buried;
      }
    }
    if (!motion.pathPose(0).sameBits(end)) {
      return "frame starts at " + motion.pathPose(0) + " but the last one ended at " + end;
    }
    for (int step = 0; step < motion.steps(); step++) {
      String touching = naive.fault(motion.pathPose(step), motion.pathPose(step + 1));
      if (touching != null) {
        return "step " + step + " of " + motion.steps() + ": " + touching;
      }
    }
    end.set(motion.pose());
    return null;
  }
}
