package org.palpate.benchmarks.fracture;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.device.GuidedHand;
import org.palpate.device.Tremor;
import org.palpate.edit.EditQueue;
import org.palpate.force.ForceSettings;
import org.palpate.fracture.Residual;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.ToolFrame;
import org.palpate.frame.ToolFramePublisher;
import org.palpate.geometry.Pose;
import org.palpate.reduction.Disassembly;
import org.palpate.reduction.ReductionPlan;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.RigidScene;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.volume.fracture.PosedBits;

/**
 * The result of a simulated hand that knows the truth, trembles, and puts the fragments of a bone
 * back one by one.
 *
 * @param parts each fragment but the largest
 * @param frames the number of frames at 1 kHz
 */
record Reduction(List<PutBack> parts, long frames) {
  private static final long FRAME_NANOS = 1_000_000;

  /** Frames after the last stop of the hand, in which its tremor has ended. */
  private static final int LAST_FRAMES = 500;

  private static final double REACH_MM = 100;
  private static final double MAX_STEP_MM = 8;
  private static final double STIFFNESS_NEWTON_PER_MM = 0.5;
  private static final double FRICTION = 0.2;

  /**
   * Lets the hand put the fragments of a bone back.
   *
   * @param seed chooses the phases of its tremor
   */
  static Reduction of(BrokenBone bone, Contact contact, long seed) {
    BodyScene bodies = bone.bodies();
    List<Pose> truth = Collections.nCopies(bodies.count(), new Pose());
    ReductionPlan plan = ReductionPlan.of(bone.bodies(), truth, contact.shapes(bodies), bodies);
    GuidedHand hand = new GuidedHand(plan.stops(), Tremor.ofHand(seed), REACH_MM, FRAME_NANOS);
    ToolFrame frame = frame(hand, bodies, contact);
    BitSet taken = new BitSet();
    long frames = 0;
    for (int left = LAST_FRAMES; left > 0; left -= hand.hasArrived() ? 1 : 0) {
      frame.run(frames++ * FRAME_NANOS);
      if (frame.heldBody() >= 0) {
        taken.set(frame.heldBody());
      }
    }
    List<PutBack> parts = new ArrayList<>();
    for (Disassembly.Exit exit : plan.exits()) {
      Body body = bodies.body(exit.fragment());
      PosedBits left = new PosedBits(body.bits(), body.grid(), body.pose());
      Residual residual = Residual.fromRest(left, bodies.body(0).pose());
      boolean hasWay = exit.pulled().isOut();
      parts.add(new PutBack(body.name(), residual, taken.get(exit.fragment()), hasWay));
    }
    parts.sort(Comparator.comparing(PutBack::name));
    return new Reduction(parts, frames);
  }

  private static ToolFrame frame(GuidedHand hand, BodyScene bodies, Contact contact) {
    RigidTool point = ToolSampler.point();
    RigidScene scene =
        new RigidScene(
            bodies, point, contact.shapes(bodies), RigidSettings.of(MAX_STEP_MM, Clearance.POINTS));
    ForceSettings force = ForceSettings.of(STIFFNESS_NEWTON_PER_MM, FRICTION);
    return new ToolFrame(
        hand,
        bodies,
        new RigidSolver(scene),
        RigidCoupling.of(point, STIFFNESS_NEWTON_PER_MM),
        FrameSettings.live(hand.specification(), force),
        EditQueue.ofBodies(bodies.grids()),
        ToolFramePublisher.NONE);
  }
}
