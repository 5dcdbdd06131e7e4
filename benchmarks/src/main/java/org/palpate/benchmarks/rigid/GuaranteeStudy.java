package org.palpate.benchmarks.rigid;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import org.palpate.benchmarks.stress.HostileScene;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.tool.BoxShape;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.volume.VoxelGrid;

/**
 * Attacks the guarantee: hostile devices hold tools of several kinds among bodies at odd poses and
 * spacings. Every leg of every sample point is judged exactly. The solids of balls and cuboids are
 * compared voxel by voxel as well.
 */
final class GuaranteeStudy {
  private static final String STUDY = "guarantee";
  private static final String HOSTILE = "hostile frames";
  private static final int FRAMES_PER_ROUND = 400;
  private static final int MOST_BODIES = 3;

  /** The rounding of a path whose poses are some metres from the origin, mm. */
  private static final double ROUNDING_MM = 1e-9;

  private final long legs;
  private final long overlapFrames;
  private final RigidLegJudge judge;
  private final SplittableRandom random;
  private final Consumer<String> progress;
  private long judgedFrames;
  private long contacts;
  private long frames;
  private long overlaps;
  private long reducedFrames;
  private long jumps;

  /** A tool, and the judge of its solid if it is a ball or a cuboid that keeps the clearance. */
  private record Held(RigidTool tool, SolidOverlap overlap) {}

  /**
   * Creates a study.
   *
   * @param legs the number of legs to judge at least
   * @param compared the number of legs that are also decided in decimals of unlimited precision
   * @param overlapFrames the number of frames in which solids are compared at least
   */
  GuaranteeStudy(
      long legs, long compared, long overlapFrames, long seed, Consumer<String> progress) {
    this.legs = legs;
    this.overlapFrames = overlapFrames;
    this.progress = progress;
    judge = new RigidLegJudge(compared);
    random = new SplittableRandom(seed);
  }

  List<RigidFigure> figures() {
    long reported = 0;
    for (int round = 0; judge.legs() < legs || judgedFrames < overlapFrames; round++) {
      attack(round);
      if (judge.legs() - reported > legs / 10) {
        reported = judge.legs();
        progress.accept(reported + " legs judged");
      }
    }
    return List.of(
        new RigidFigure(STUDY, HOSTILE, "legs that touch a solid", judge.touching(), "", 0),
        RigidFigure.of(STUDY, HOSTILE, "legs judged", (double) judge.legs(), ""),
        new RigidFigure(STUDY, HOSTILE, "broken chains", judge.broken(), "", 0),
        new RigidFigure(
            STUDY, HOSTILE, "disagreements of the filter", judge.disagreements(), "", 0),
        RigidFigure.of(STUDY, HOSTILE, "legs decided twice", (double) judge.compared(), ""),
        new RigidFigure(STUDY, HOSTILE, "frames with overlapping solids", overlaps, "", 0),
        RigidFigure.of(STUDY, HOSTILE, "frames judged for overlap", (double) judgedFrames, ""),
        RigidFigure.of(STUDY, HOSTILE, "frames with reduced clearance", (double) reducedFrames, ""),
        RigidFigure.of(STUDY, HOSTILE, "frames with contact", 100.0 * contacts / frames, "%"),
        new RigidFigure(STUDY, HOSTILE, "paths beyond the longest step", jumps, "", 0));
  }

  private void attack(int round) {
    HostileScene first = HostileScene.next(random);
    BodyScene bodies = bodies(first);
    Held held = held(round % 5, bodies.shortestEdgeMm());
    double maxStepMm = first.maxStepMm();
    RigidSettings settings =
        held.overlap != null
            ? RigidSettings.ofWholeBodies(maxStepMm, bodies, held.tool)
            : RigidSettings.of(maxStepMm, Clearance.POINTS);
    ToolRun run = new ToolRun(bodies, held.tool, settings);
    HostileDevice device = new HostileDevice(random, bodies.shortestEdgeMm(), reachMm(first));
    placeNear(run, device);
    for (int frame = 0; frame < FRAMES_PER_ROUND; frame++) {
      boolean reducedBefore = run.motion.reducedPoints() > 0;
      run.follow(device.next());
      judge.judge(bodies, held.tool, run.motion);
      frames++;
      contacts += run.motion.contact() ? 1 : 0;
      jumps += run.motion.pathMm() > maxStepMm * (1 + 1e-9) + ROUNDING_MM ? 1 : 0;
      if (held.overlap != null && judgedFrames < overlapFrames) {
        judgeOverlap(run, held.overlap, reducedBefore);
      }
    }
  }

  /** Begins near the bodies, where a device with a tiny step would never arrive. */
  private void placeNear(ToolRun run, HostileDevice device) {
    Pose near = new Pose();
    do {
      near.set(device.next());
    } while (!near.isFinite() || !near.rotation.normalize());
    run.solver.place(near, run.motion);
    judge.begin(run.motion);
  }

  /** Compares solids, unless points that started nearer than the clearance suspend the theorem. */
  private void judgeOverlap(ToolRun run, SolidOverlap overlap, boolean reducedBefore) {
    if (reducedBefore || run.motion.reducedPoints() > 0) {
      reducedFrames++;
    } else {
      judgedFrames++;
      overlaps += overlaps(run, overlap) ? 1 : 0;
    }
  }

  private static boolean overlaps(ToolRun run, SolidOverlap overlap) {
    for (int step = 1; step <= run.motion.steps(); step++) {
      if (overlap.overlaps(run.bodies, run.motion.pathPose(step))) {
        return true;
      }
    }
    return false;
  }

  private static double reachMm(HostileScene scene) {
    Vec3 s = scene.spacingMm();
    double x = scene.bits().sizeX() * s.x;
    double y = scene.bits().sizeY() * s.y;
    double z = scene.bits().sizeZ() * s.z;
    return 0.7 * Math.max(x, Math.max(y, z));
  }

  private BodyScene bodies(HostileScene first) {
    List<Body> bodies = new ArrayList<>();
    int count = random.nextInt(1, MOST_BODIES + 1);
    for (int n = 0; n < count; n++) {
      HostileScene scene = n == 0 ? first : HostileScene.next(random);
      VoxelGrid grid =
          new VoxelGrid(
              scene.bits().sizeX(),
              scene.bits().sizeY(),
              scene.bits().sizeZ(),
              scene.spacingMm(),
              RigidTransform.identity());
      Body body = new Body(scene.kind() + n, scene.bits(), grid, Mobility.FIXED);
      body.setPose(pose(scene));
      bodies.add(body);
    }
    return new BodyScene(bodies);
  }

  /** Returns a pose that turns a grid about its middle, which lies near the origin. */
  private Pose pose(HostileScene scene) {
    Vec3 s = scene.spacingMm();
    Pose centred =
        Pose.at(
            -scene.bits().sizeX() * s.x / 2,
            -scene.bits().sizeY() * s.y / 2,
            -scene.bits().sizeZ() * s.z / 2);
    Pose turned = new Pose();
    double reach = reachMm(scene);
    turned.rotation.setRotationVector(new Vec3(angle(), angle(), angle()));
    turned.translation.set(
        random.nextDouble(-reach, reach) / 3, random.nextDouble(-reach, reach) / 3, 0);
    Pose pose = turned.multiply(centred, new Pose());
    pose.rotation.normalize();
    return pose;
  }

  private double angle() {
    return random.nextDouble(-2, 2);
  }

  private Held held(int kind, double edgeMm) {
    double cover = MeasuredTools.COVER_MM * edgeMm;
    double size = edgeMm * random.nextDouble(1, 5);
    return switch (kind) {
      case 0 -> {
        BoxShape box = new BoxShape(size, 2 * size, 0.7 * size);
        yield new Held(ToolSampler.ofShape(box, cover), SolidOverlap.ofBox(box));
      }
      case 1 ->
          new Held(ToolSampler.ofShape(RodShape.sphere(size), cover), SolidOverlap.ofBall(size));
      case 2 -> new Held(ToolSampler.ofShape(RodShape.needle(edgeMm, 4 * size), cover), null);
      case 3 ->
          new Held(
              ToolSampler.ofShape(new BoxShape(size, size, 3 * size), cover).thinned(20), null);
      default -> new Held(ToolSampler.ofShape(RodShape.capsule(size, size), cover), null);
    };
  }
}
