package org.palpate.benchmarks.stability;

import java.util.List;
import java.util.Optional;
import org.palpate.body.Body;
import org.palpate.force.EffectPlan;
import org.palpate.force.ToolProposal;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.tool.RigidTool;

/** A tool that the hand holds in a {@link ToolTrial}, and the solid on which it presses it. */
interface HeldTool {
  /** Returns the name in tables. */
  String name();

  /** Returns the distance between the centres of the caps, mm. */
  double lengthMm();

  /** Returns the tool, whose axis is z. */
  RigidTool tool();

  /** Returns the solid. */
  Body solid();

  /** Returns the orientation that the hand intends. */
  Quaternion orientation();

  /** Returns the centre of the tool where it meets what it is pressed on, mm. */
  Vec3 touchMm();

  /** Returns what proposes where the tool goes; empty if it follows the hand. */
  Optional<ToolProposal> proposal(RigidCoupling coupling);

  /** Returns the guides and effects that the hand feels. */
  List<EffectPlan> effects();
}
