package org.palpate.benchmarks.moving;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import org.palpate.benchmarks.stress.HostileScene;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.fracture.VoxelOverlap;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.MovableShapes;
import org.palpate.rigid.RigidScene;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.ToolMotion;
import org.palpate.rigid.tool.BoxShape;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.fracture.PosedBits;

/**
 * Attacks bodies that move: random goals drive them into each other and into a tool that moves too.
 * From time to time the hand holds a body instead of the tool, or several as one. Every leg of
 * every pair is judged exactly. In mode {@code body}, all voxels of all bodies are compared at
 * regular intervals.
 */
public final class MovingBodiesStudy {
  private static final int FRAMES_PER_ROUND = 1_000;
  private static final int MOST_FRAMES_TO_A_GOAL = 30;
  private static final int MOST_FRAMES_TO_A_GRASP = 100;
  private static final double REACH_MM = 18;

  private final long frames;
  private final int overlapEvery;
  private final SplittableRandom random;
  private final SplittableRandom goals;
  private final Consumer<String> progress;
  private final Quaternion scratch = new Quaternion();
  private Result total = new Result(0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);

  /**
   * The figures of an attack.
   *
   * @param frames the number of frames
   * @param legs the number of legs judged
   * @param touching the number of legs that touch a voxel
   * @param broken the number of motions that do not begin where the last one ended
   * @param motions the number of motions of bodies
   * @param pushes the number of motions that pushed the tool
   * @param heldBack the number of frames in which a body was held back
   * @param contacts the number of frames in which what is held had contact
   * @param holds the number of frames in which the hand held a body
   * @param compared the number of pairs of bodies whose voxels were compared
   * @param overlapping the number of pairs of voxels that overlap
   */
  public record Result(
      long frames,
      long legs,
      long touching,
      long broken,
      long motions,
      long pushes,
      long heldBack,
      long contacts,
      long holds,
      long compared,
      long overlapping) {

    private String progress() {
      return frames
          + " frames of moving bodies, "
          + legs
          + " legs judged, "
          + touching
          + " touch, "
          + broken
          + " chains broken, "
          + overlapping
          + " voxels overlap";
    }

    private Result plus(Result o) {
      return new Result(
          frames + o.frames,
          legs + o.legs,
          touching + o.touching,
          broken + o.broken,
          motions + o.motions,
          pushes + o.pushes,
          heldBack + o.heldBack,
          contacts + o.contacts,
          holds + o.holds,
          compared + o.compared,
          overlapping + o.overlapping);
    }
  }

  /**
   * Creates a study.
   *
   * @param frames the number of frames at least
   * @param overlapEvery the number of frames from one comparison of voxels to the next
   * @param seed of scenes, devices and goals
   */
  public MovingBodiesStudy(long frames, int overlapEvery, long seed, Consumer<String> progress) {
    this.frames = frames;
    this.overlapEvery = overlapEvery;
    this.progress = progress;
    random = new SplittableRandom(seed);
    goals = random.split();
  }

  /** Runs the attack. */
  public Result run() {
    long reported = 0;
    for (int round = 0; total.frames < frames; round++) {
      total = total.plus(attack(round % 2 == 1));
      if (total.frames - reported > frames / 10) {
        reported = total.frames;
        progress.accept(total.progress());
      }
    }
    return total;
  }

  private Result attack(boolean wholeBodies) {
    BodyScene bodies = bodies();
    RigidTool tool = tool();
    double maxStepMm = random.nextDouble(0.5, 8);
    MovableShapes shapes =
        wholeBodies ? MovableShapes.ofWholeBodies(bodies, 0) : MovableShapes.ofPoints(bodies);
    RigidSettings settings =
        wholeBodies
            ? RigidSettings.ofWholeBodies(maxStepMm, bodies, tool)
            : RigidSettings.of(maxStepMm, Clearance.POINTS);
    RigidSolver solver = new RigidSolver(new RigidScene(bodies, tool, shapes, settings));
    ToolMotion motion = solver.newMotion();
    Pose device = pose(random, 60);
    solver.place(device, motion);
    SceneLegJudge judge = new SceneLegJudge(bodies, tool, shapes);
    judge.begin(motion);
    RigidSolver hand = solver;
    Result counts = new Result(0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
    for (int frame = 0; frame < FRAMES_PER_ROUND; frame++) {
      if (random.nextInt(MOST_FRAMES_TO_A_GRASP) == 0) {
        hand = change(hand, solver, bodies, device, motion, judge);
      }
      setGoals(solver, bodies);
      moveDevice(device, frame);
      hand.follow(device, motion);
      judge.judge(motion);
      boolean compares = wholeBodies && frame % overlapEvery == 0;
      counts =
          counts.plus(
              new Result(
                  1,
                  0,
                  0,
                  0,
                  motion.bodies().count(),
                  0,
                  0,
                  motion.contact() ? 1 : 0,
                  hand == solver ? 0 : 1,
                  compares ? pairs(bodies) : 0,
                  compares ? overlapping(bodies) : 0));
    }
    return counts.plus(
        new Result(
            0,
            judge.legs(),
            judge.touching(),
            judge.broken(),
            0,
            solver.bodies().pushes(),
            solver.bodies().heldBack(),
            0,
            0,
            0,
            0));
  }

  /** Takes hold of a movable body, or lets go of one and places the tool at the device. */
  private RigidSolver change(
      RigidSolver hand,
      RigidSolver tool,
      BodyScene bodies,
      Pose device,
      ToolMotion motion,
      SceneLegJudge judge) {
    int body = random.nextInt(bodies.count());
    if (hand != tool) {
      hand.carryNone();
      tool.place(device, motion);
      judge.letGo(motion);
      return tool;
    }
    if (!tool.canMove(body)) {
      return tool;
    }
    RigidSolver holding = tool.ofBody(body);
    holding.takeOver(motion);
    judge.take(body, motion);
    for (int n = 0; n < bodies.count(); n++) {
      if (n != body && tool.canMove(n) && random.nextInt(3) == 0) {
        holding.carry(n);
        judge.join(n);
      }
    }
    device.set(motion.pose());
    return holding;
  }

  private static long pairs(BodyScene bodies) {
    return (long) bodies.count() * (bodies.count() - 1) / 2;
  }

  private static PosedBits posed(Body body) {
    return new PosedBits(body.bits(), body.grid(), body.pose());
  }

  private static long overlapping(BodyScene bodies) {
    long sum = 0;
    for (int a = 0; a < bodies.count(); a++) {
      for (int b = 0; b < a; b++) {
        sum += new VoxelOverlap(posed(bodies.body(a)), posed(bodies.body(b))).count();
      }
    }
    return sum;
  }

  private void setGoals(RigidSolver solver, BodyScene bodies) {
    for (int n = 0; n < bodies.count(); n++) {
      if (bodies.body(n).mobility() == Mobility.MOVABLE
          && goals.nextInt(MOST_FRAMES_TO_A_GOAL) == 0) {
        solver.bodies().setGoal(n, goal(bodies.body(n)));
      }
    }
  }

  /** Returns a pose that brings the middle of a body near the origin, or a step from here. */
  private Pose goal(Body body) {
    if (goals.nextBoolean()) {
      return around(body, pose(goals, REACH_MM));
    }
    Pose here = new Pose().set(body.pose());
    double size = Math.pow(10, goals.nextDouble(-6, 1));
    return here.displace(vector(goals, size), vector(goals, size / 20), 1, scratch, here);
  }

  private void moveDevice(Pose device, int frame) {
    switch (frame / 25 % 8) {
      case 0 -> device.displace(vector(random, 6), vector(random, 1), 1, scratch, device);
      case 1 -> device.displace(vector(random, 0.3), vector(random, 0.1), 1, scratch, device);
      case 2 -> device.displace(vector(random, 2), vector(random, 0.1), 1, scratch, device);
      default -> {} // rests, while bodies move
    }
    for (int axis = 0; axis < 3; axis++) {
      double at = device.translation.get(axis);
      device.translation.set(axis, Math.max(-REACH_MM, Math.min(REACH_MM, at)));
    }
  }

  /** Returns bodies in a row that are apart; the first one may stand still. */
  private BodyScene bodies() {
    List<Body> bodies = new ArrayList<>();
    int count = random.nextInt(1, 5);
    for (int n = 0; n < count; n++) {
      HostileScene scene = HostileScene.next(random);
      BitCube bits = scene.bits();
      Vec3 spacing = random.nextBoolean() ? new Vec3(1, 1, 1) : new Vec3(0.8, 1, 1.3);
      VoxelGrid grid =
          new VoxelGrid(
              bits.sizeX(), bits.sizeY(), bits.sizeZ(), spacing, RigidTransform.identity());
      boolean stands = n == 0 && random.nextBoolean();
      Body body =
          new Body(scene.kind() + n, bits, grid, stands ? Mobility.FIXED : Mobility.MOVABLE);
      Pose pose = pose(random, 3);
      pose.translation.x += 60 * n;
      body.setPose(around(body, pose));
      bodies.add(body);
    }
    return new BodyScene(bodies);
  }

  /** Returns the pose that turns a body about the middle of its grid and puts that somewhere. */
  private static Pose around(Body body, Pose middleTo) {
    VoxelGrid grid = body.grid();
    Pose centred = new Pose();
    Vec3 middle = new Vec3(grid.sizeX() / 2.0, grid.sizeY() / 2.0, grid.sizeZ() / 2.0);
    grid.gridToWorld(middle, middle).mul(-1, centred.translation);
    middleTo.multiply(centred, centred);
    centred.rotation.normalize();
    return centred;
  }

  private RigidTool tool() {
    return switch (random.nextInt(4)) {
      case 0 -> ToolSampler.point();
      case 1 -> ToolSampler.ofShape(RodShape.sphere(random.nextDouble(1, 3)), 0.6);
      case 2 -> ToolSampler.ofShape(new BoxShape(3, 6, 2), 0.6);
      default -> ToolSampler.ofShape(RodShape.needle(1, 9), 0.6);
    };
  }

  private static Pose pose(SplittableRandom random, double reachMm) {
    Pose pose = new Pose();
    pose.translation.set(vector(random, reachMm));
    pose.rotation.setRotationVector(vector(random, 2));
    return pose;
  }

  private static Vec3 vector(SplittableRandom random, double size) {
    return new Vec3(
        random.nextDouble(-size, size),
        random.nextDouble(-size, size),
        random.nextDouble(-size, size));
  }
}
