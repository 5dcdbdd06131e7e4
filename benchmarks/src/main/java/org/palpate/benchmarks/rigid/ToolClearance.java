package org.palpate.benchmarks.rigid;

import org.palpate.body.BodyScene;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.tool.RigidTool;

/** The clearance that a measured tool keeps. */
enum ToolClearance {
  /** No leg of a sample point touches a voxel. */
  POINTS("points"),

  /** The solids of tool and bodies do not overlap. */
  BODY("body");

  /** The longest path of a point in a frame, mm. */
  static final double MAX_STEP_MM = 8;

  /** The name that {@code --clearance} takes. */
  final String option;

  ToolClearance(String option) {
    this.option = option;
  }

  RigidSettings settings(BodyScene bodies, RigidTool tool) {
    return this == POINTS
        ? RigidSettings.of(MAX_STEP_MM, Clearance.POINTS)
        : RigidSettings.ofWholeBodies(MAX_STEP_MM, bodies, tool);
  }

  /** Returns the clearance of a tool from the only body of a scene. */
  Clearance clearance(BodyScene bodies, RigidTool tool) {
    return this == POINTS
        ? Clearance.POINTS
        : Clearance.ofWholeBody(tool, bodies.body(0).grid(), 0);
  }
}
