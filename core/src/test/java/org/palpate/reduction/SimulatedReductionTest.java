package org.palpate.reduction;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.device.GuidedHand;
import org.palpate.device.Tremor;
import org.palpate.edit.EditQueue;
import org.palpate.force.ForceSettings;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.ToolFrame;
import org.palpate.frame.ToolFramePublisher;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.MovableShapes;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.RigidScene;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.volume.fracture.Fragments;
import org.palpate.volume.phantom.FracturePhantom;

/** A hand with tremor that knows the truth puts the fragments of a bone back, touch by touch. */
class SimulatedReductionTest {
  private static final long MS = 1_000_000;
  private static final double MOST_MM = 0.5;
  private static final double MOST_RAD = Math.toRadians(1);

  @ParameterizedTest
  @ValueSource(strings = {"fracture:96:3:1:1", "fracture:160:4:11:1"})
  void everyFragmentIsTakenLedHomeAndPutDownThere(String spec) {
    FracturePhantom phantom = FracturePhantom.parse(spec);
    Fragments fragments = phantom.fragments();
    List<Pose> starts = phantom.startPoses(fragments);
    BodyScene bodies = scene(fragments, starts);
    List<Pose> truth = Collections.nCopies(bodies.count(), new Pose());
    GuidedHand hand =
        new GuidedHand(
            ReductionPlan.of(scene(fragments, starts), truth, bodies),
            new Tremor(0.3, Math.toRadians(1), 8, 1),
            100,
            MS);
    ToolFrame frame = frame(hand, bodies);
    long frames = Math.round(1000 * hand.durationSeconds()) + 500;
    int taken = 0;
    int before = -1;
    for (long n = 0; n < frames; n++) {
      frame.run(n * MS);
      if (frame.heldBody() >= 0 && before < 0) {
        taken++;
      }
      before = frame.heldBody();
    }
    StringBuilder result = new StringBuilder(spec + ": " + frames + " frames, took " + taken);
    boolean good = true;
    for (int n = 1; n < bodies.count(); n++) {
      double mm = displacementMm(bodies.body(n));
      double rad = bodies.body(n).pose().rotation.angle();
      good &= mm <= MOST_MM && rad <= MOST_RAD;
      result.append(", ").append(mm).append(" mm ").append(Math.toDegrees(rad)).append(" deg");
    }
    assertEquals(bodies.count() - 1, taken, result.toString());
    assertTrue(good, result.toString());
  }

  private static double displacementMm(Body body) {
    Vec3 at = ToolSampler.ofSegment(body.bits(), body.grid()).referenceMm(new Vec3());
    return body.pose().transform(at, new Vec3()).sub(at, at).length();
  }

  private static ToolFrame frame(GuidedHand hand, BodyScene bodies) {
    RigidTool point = ToolSampler.point();
    RigidScene scene =
        new RigidScene(
            bodies, point, MovableShapes.ofPoints(bodies), RigidSettings.of(8, Clearance.POINTS));
    ForceSettings force = ForceSettings.of(0.5, 0.2);
    return new ToolFrame(
        hand,
        bodies,
        new RigidSolver(scene),
        RigidCoupling.of(point, 0.5),
        FrameSettings.live(hand.specification(), force),
        EditQueue.ofBodies(bodies.grids()),
        ToolFramePublisher.NONE);
  }

  private static BodyScene scene(Fragments fragments, List<Pose> starts) {
    List<Body> bodies = new ArrayList<>();
    for (int n = 0; n < starts.size(); n++) {
      Mobility mobility = n == 0 ? Mobility.FIXED : Mobility.MOVABLE;
      Body body = new Body("f" + n, fragments.bits().get(n), fragments.grid(), mobility);
      body.setPose(starts.get(n));
      bodies.add(body);
    }
    return new BodyScene(bodies);
  }
}
