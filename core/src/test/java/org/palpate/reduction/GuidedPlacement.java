package org.palpate.reduction;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.palpate.body.Body;
import org.palpate.body.BodyEvent;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.device.GuidedHand;
import org.palpate.device.HandStop;
import org.palpate.device.Tremor;
import org.palpate.edit.EditQueue;
import org.palpate.force.EffectSite;
import org.palpate.force.ForceSettings;
import org.palpate.force.guide.FitExchange;
import org.palpate.force.guide.FitTarget;
import org.palpate.force.guide.GuideStrength;
import org.palpate.force.guide.Guides;
import org.palpate.fracture.Residual;
import org.palpate.fracture.VoxelOverlap;
import org.palpate.fracture.fit.FaceFit;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.ToolFrame;
import org.palpate.frame.ToolFramePublisher;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.MovableShapes;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.RigidScene;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.YieldingHand;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.fracture.PosedBits;

/**
 * A hand with tremor leads a fragment to a place that is wrong by a known motion, and lets go of it
 * there. A fit may guide it: it is computed every 33 frames and used 33 frames later, as if by
 * another thread.
 */
final class GuidedPlacement {
  /** The stiffness of contact, N/mm. */
  static final double STIFFNESS = 0.5;

  /** The stiffness of a hand that lets itself be led, N/mm, and the lever of its grip, mm. */
  static final double HAND_STIFFNESS = 0.1;

  private static final double GRIP_MM = 15;
  private static final double LIFT_MM = 3;
  private static final double SETTLE_SECONDS = 1.5;
  private static final long MS = 1_000_000;
  private static final int FIT_FRAMES = 33;

  private final VoxelGrid grid;
  private final List<BitCube> cubes;
  private final int held;
  private final Vec3 centroid;
  private final BodyScene bodies;

  /** The distance of a fragment from the truth, and the largest step of the force in a frame. */
  record Result(double mm, double degrees, double largestStepNewton) {}

  /**
   * Prepares fragments at their true places.
   *
   * @param cubes the fragments that are in place, and the one to place last
   */
  GuidedPlacement(VoxelGrid grid, List<BitCube> cubes) {
    this.grid = grid;
    this.cubes = cubes;
    held = cubes.size() - 1;
    centroid = Residual.centroid(new PosedBits(cubes.get(held), grid, new Pose()));
    List<Body> all = new ArrayList<>();
    for (int n = 0; n < cubes.size(); n++) {
      Mobility mobility = n == held ? Mobility.MOVABLE : Mobility.FIXED;
      all.add(new Body("f" + n, cubes.get(n), grid, mobility));
    }
    bodies = new BodyScene(all);
  }

  /**
   * Places the fragment.
   *
   * @param wrongMm how far the hand is wrong, along a random direction
   * @param wrongDegrees the same for its rotation
   * @param fit guides the hand; empty for no guide
   */
  Result place(double wrongMm, double wrongDegrees, long seed, Optional<FaceFit> fit) {
    SplittableRandom random = new SplittableRandom(seed);
    Pose goal = new Pose();
    goal.rotation.setRotationVector(
        RandomGeometry.direction(random).mul(Math.toRadians(wrongDegrees), new Vec3()));
    centroid.add(RandomGeometry.direction(random).mul(wrongMm, new Vec3()), goal.translation);
    Pose start = new Pose().set(goal);
    Vec3 lift = wayOut().mul(LIFT_MM, new Vec3());
    do {
      start.translation.add(lift, start.translation);
      putAt(start);
    } while (overlaps());
    start.translation.add(lift, start.translation);
    putAt(start);
    GuidedHand wanted =
        new GuidedHand(
            List.of(new HandStop(start, 0, 0.1, true), new HandStop(goal, 0, SETTLE_SECONDS, true)),
            Tremor.ofHand(seed),
            100,
            MS);
    return run(wanted, wanted.durationSeconds() + SETTLE_SECONDS, fit);
  }

  /** Moves the fragment such that its centroid has a pose. */
  private void putAt(Pose reference) {
    Pose rest = new Pose();
    rest.rotation.set(reference.rotation);
    reference.translation.sub(reference.rotation.rotate(centroid, new Vec3()), rest.translation);
    bodies.body(held).setPose(rest);
  }

  private boolean overlaps() {
    List<Pose> poses = poses();
    PosedBits moved = new PosedBits(cubes.get(held), grid, poses.get(held));
    for (int n = 0; n < held; n++) {
      if (new VoxelOverlap(moved, new PosedBits(cubes.get(n), grid, poses.get(n))).count() > 0) {
        return true;
      }
    }
    return false;
  }

  private Result run(GuidedHand wanted, double seconds, Optional<FaceFit> fit) {
    YieldingHand hand =
        new YieldingHand(wanted, HAND_STIFFNESS, HAND_STIFFNESS * GRIP_MM * GRIP_MM);
    ToolFrame frame = frame(hand);
    FitExchange exchange = new FitExchange();
    fit.ifPresent(
        any ->
            frame.requestEffects(
                List.of(Guides.fit(exchange, GuideStrength.STANDARD).make(site(wanted)))));
    frame.run(0);
    frame.repeat(held, BodyEvent.TAKEN, new Pose(), new Pose());
    FitTarget next = null;
    double largestStep = 0;
    Vec3 last = new Vec3();
    long frames = Math.round(1000 * seconds);
    for (long n = 1; n < frames; n++) {
      if (fit.isPresent() && n % FIT_FRAMES == 0) {
        exchange.offer(next);
        next = fit.get().fit(held, other -> false, poses()).orElse(null);
      }
      last.set(frame.forceNewton());
      frame.run(n * MS);
      largestStep = Math.max(largestStep, frame.forceNewton().sub(last, new Vec3()).length());
    }
    Pose put = bodies.body(held).pose();
    Vec3 off = put.transform(centroid, new Vec3());
    return new Result(
        off.sub(centroid, off).length(), Math.toDegrees(put.rotation.angle()), largestStep);
  }

  private List<Pose> poses() {
    List<Pose> poses = new ArrayList<>();
    for (int n = 0; n < bodies.count(); n++) {
      poses.add(bodies.body(n).pose());
    }
    return poses;
  }

  private static EffectSite site(GuidedHand device) {
    return new EffectSite(
        RigidTransform.identity(),
        STIFFNESS,
        0,
        device.specification().maxForceNewton(),
        List.of(new Vec3()));
  }

  /** Returns the direction in which the fragment leaves its place most freely. */
  private Vec3 wayOut() {
    RigidTool shape = ToolSampler.ofSegment(cubes.get(held), grid);
    Vec3 reference = shape.referenceMm(new Vec3());
    Vec3[] points = new Vec3[shape.count()];
    for (int n = 0; n < points.length; n++) {
      points[n] = shape.point(n, new Vec3()).add(reference, new Vec3());
    }
    return new WayOut(bodies, held, points, 20).direction();
  }

  private ToolFrame frame(YieldingHand hand) {
    RigidTool point = ToolSampler.point();
    RigidScene scene =
        new RigidScene(
            bodies, point, MovableShapes.ofPoints(bodies), RigidSettings.of(8, Clearance.POINTS));
    return new ToolFrame(
        hand,
        bodies,
        new RigidSolver(scene),
        RigidCoupling.of(point, STIFFNESS),
        FrameSettings.live(hand.specification(), ForceSettings.of(STIFFNESS, 0.2)),
        EditQueue.ofBodies(bodies.grids()),
        ToolFramePublisher.NONE);
  }
}
