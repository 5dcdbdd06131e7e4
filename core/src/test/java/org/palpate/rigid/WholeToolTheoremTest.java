package org.palpate.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.BiPredicate;
import org.junit.jupiter.api.Test;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.body.RandomSolids;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.BoxShape;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * Checks the whole-tool theorem of docs/guarantee.md by brute force: solids that are judged voxel
 * by voxel, at the poses of every step and between them. {@code -Dpalpate.overlapFrames=100000}
 * runs as many frames.
 */
class WholeToolTheoremTest {
  private static final int FRAMES = Integer.getInteger("palpate.overlapFrames", 4000);
  private static final int FRAMES_PER_ROUND = 200;
  private static final double MAX_STEP_MM = 8;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final ToolMotion motion = new ToolMotion();
  private final Pose.Scratch scratch = new Pose.Scratch();

  /** A tool, the clearance that it keeps beyond the theorem's, and what overlaps it. */
  private record Held(RigidTool tool, double marginMm, BiPredicate<BodyScene, Pose> overlaps) {}

  @Test
  void noSolidOverlapsAHostileToolAtOrBetweenItsPoses() {
    int contacts = 0;
    int judged = 0;
    for (int round = 0; round * FRAMES_PER_ROUND < FRAMES; round++) {
      BodyScene scene = scene(1 + round % 3);
      Held held = held(round % 5);
      RigidSolver solver = solver(scene, held);
      Pose start = new Pose();
      start.translation.set(200, 200, 200);
      assertTrue(solver.place(start, motion));
      HostilePoses device = new HostilePoses(random, 22);
      for (int frame = 0; frame < FRAMES_PER_ROUND; frame++) {
        solver.follow(device.next(), motion);
        contacts += motion.contact() ? 1 : 0;
        assertEquals(0, motion.reducedPoints());
        String where = "seed " + Seeds.seed() + " round " + round + " frame " + frame;
        for (int step = 0; step < motion.steps(); step++) {
          double fraction = random.nextBoolean() ? 0.5 : random.nextDouble();
          Pose between = between(motion.pathPose(step), motion.pathPose(step + 1), fraction);
          assertTrue(!held.overlaps.test(scene, between), where + " between poses of " + step);
          assertTrue(!held.overlaps.test(scene, motion.pathPose(step + 1)), where);
          judged += 2;
        }
      }
    }
    System.out.println("WholeToolTheoremTest: " + FRAMES + " frames, " + judged + " poses judged");
    assertTrue(contacts > FRAMES / 15, "frames with contact: " + contacts);
  }

  private Pose between(Pose from, Pose to, double fraction) {
    return from.interpolate(to, fraction, scratch, new Pose());
  }

  private static RigidSolver solver(BodyScene scene, Held held) {
    List<Clearance> clearances = new ArrayList<>();
    for (int n = 0; n < scene.count(); n++) {
      clearances.add(Clearance.ofWholeBody(held.tool, scene.body(n).grid(), held.marginMm));
    }
    RigidSettings settings = new RigidSettings(MAX_STEP_MM, clearances, List.of(), true);
    return new RigidSolver(scene, held.tool, settings);
  }

  private Held held(int kind) {
    if (kind == 0) {
      BoxShape box = new BoxShape(9, 5, 2);
      OverlapJudge judge = new OverlapJudge(box);
      return new Held(ToolSampler.ofShape(box, 0.498), 0, judge::overlaps);
    }
    if (kind == 1) {
      RigidTool ball = ToolSampler.ofShape(RodShape.sphere(3.3), 0.7);
      return new Held(ball, 0.3, (scene, pose) -> isBallNear(scene, pose, 3.6));
    }
    if (kind == 2) {
      return eroded();
    }
    BitCube bits = RandomSolids.clutter(random, 8, 9, 7);
    VoxelGrid grid = ToolScenes.obliqueGrid(bits, new Vec3(1, 1.7, 0.8));
    RigidTool tool = ToolSampler.ofSegment(bits, grid);
    OverlapJudge judge = new OverlapJudge(bits, grid, tool);
    return new Held(tool, 0, judge::overlaps);
  }

  /** Returns a block with a margin of -0.7: the judge sees the part that is deeper than that. */
  private static Held eroded() {
    BitCube bits = ToolScenes.block(6, 5, 7);
    RigidTool tool = ToolSampler.ofErodedSegment(bits, VoxelGrid.ofUnitVoxels(6, 5, 7), 0.7);
    OverlapJudge judge = new OverlapJudge(new BoxShape(6 - 1.4, 5 - 1.4, 7 - 1.4));
    return new Held(tool, 0, judge::overlaps);
  }

  /** Whether a solid voxel is nearer than a distance to the reference point. */
  private static boolean isBallNear(BodyScene scene, Pose pose, double distanceMm) {
    AffineMap toGrid = new AffineMap();
    for (int b = 0; b < scene.count(); b++) {
      Body body = scene.body(b);
      Vec3 c = body.toolToGrid(pose, toGrid).transform(new Vec3(), new Vec3());
      double skew = 1 + body.grid().gridMmToWorld().distortion();
      BitCube bits = body.bits();
      for (int n = 0; n < bits.sizeX() * bits.sizeY() * bits.sizeZ(); n++) {
        int i = n % bits.sizeX();
        int j = n / bits.sizeX() % bits.sizeY();
        int k = n / bits.sizeX() / bits.sizeY();
        if (bits.get(i, j, k)
            && body.metric().distance(c.x, c.y, c.z, clamp(c.x, i), clamp(c.y, j), clamp(c.z, k))
                    * skew
                < distanceMm) {
          return true;
        }
      }
    }
    return false;
  }

  private static double clamp(double v, int low) {
    return Math.max(low, Math.min(low + 1, v));
  }

  /** Returns cluttered bodies whose axes are off by as much as files may have them. */
  private BodyScene scene(int bodies) {
    List<Body> list = new ArrayList<>();
    for (int n = 0; n < bodies; n++) {
      BitCube bits =
          RandomSolids.clutter(
              random, random.nextInt(9, 26), random.nextInt(9, 26), random.nextInt(9, 26));
      Vec3 spacing = new Vec3(1, 1, 1);
      spacing.set(random.nextInt(3), random.nextInt(1, 4));
      double off = n == 0 ? 0 : 6e-5;
      RigidTransform axes =
          new RigidTransform(
              new Vec3(0, 0.6, 0.8),
              new Vec3(1, off, -off),
              new Vec3(0, 0.8 * (1 + off), -0.6 * (1 + off)),
              new Vec3(-9, -9, 2));
      assertTrue(axes.isOrthonormal());
      VoxelGrid grid = new VoxelGrid(bits.sizeX(), bits.sizeY(), bits.sizeZ(), spacing, axes);
      Body body = new Body("body" + n, bits, grid, Mobility.FIXED);
      body.setPose(n == 0 ? new Pose() : RandomGeometry.pose(random, 10));
      list.add(body);
    }
    return new BodyScene(list);
  }

  @Test
  void fewerThanTheClearanceOfTheTheoremWouldLetSolidsThrough() {
    BitCube bits = ToolScenes.block(5, 5, 5);
    BitCube needle = ToolScenes.block(1, 1, 60);
    RigidTransform axes = VoxelGrid.ofUnitVoxels(1, 1, 1).gridMmToWorld();
    VoxelGrid fine = new VoxelGrid(1, 1, 60, new Vec3(0.1, 0.1, 0.1), axes);
    BodyScene scene = new BodyScene(List.of(new Body("needle", needle, fine, Mobility.FIXED)));
    RigidTool tool = ToolSampler.ofSegment(bits, VoxelGrid.ofUnitVoxels(5, 5, 5));
    Clearance whole = Clearance.ofWholeBody(tool, fine, 0);
    for (double part : new double[] {0.6, 1}) {
      double growth = part * whole.growthMm();
      RigidSettings settings = RigidSettings.of(MAX_STEP_MM, new Clearance(growth, growth, 1));
      RigidSolver solver = new RigidSolver(scene, tool, settings);
      Pose pose = new Pose();
      pose.translation.set(0.55, 0.55, 12); // the needle points between four sample points
      assertTrue(solver.place(pose, motion));
      for (int frame = 0; frame < 80; frame++) {
        pose.translation.z = Math.max(5, 12 - 0.1 * frame);
        solver.follow(pose, motion);
      }
      double depth = 6 - (motion.pose().translation.z - 2.5);
      assertTrue(part < 1 ? depth > 3 : depth <= 0, part + " of the clearance: depth " + depth);
    }
  }

  @Test
  void quaternionsOfOtherNormsNeitherScaleTheToolNorTheBody() {
    BodyScene scene = scene(1);
    RigidTool tool = ToolSampler.ofShape(RodShape.sphere(2), 0.5);
    RigidSolver solver = new RigidSolver(scene, tool, RigidSettings.ofWholeBodies(8, scene, tool));
    Pose pose = new Pose();
    pose.translation.set(200, 0, 0);
    pose.rotation.set(1.001, 0, 0, 0);
    assertTrue(solver.place(pose, motion));
    assertTrue(motion.pose().rotation.isUnit());
    pose.rotation.set(0, 0, 0, 0);
    assertThrows(IllegalArgumentException.class, () -> solver.place(pose, motion));
    pose.rotation.set(1 + 1e-9, 0, 0, 0);
    assertThrows(IllegalArgumentException.class, () -> scene.body(0).setPose(pose));
  }

  @Test
  void theArcOfAStepLeavesItsChordByLessThanTheClearanceAllows() {
    for (int n = 0; n < 2000; n++) {
      double radius = Math.pow(10, random.nextDouble(-2, 3));
      double edge = Math.pow(10, random.nextDouble(-2, 1));
      double turn = StepLimits.largestTurn(radius, edge);
      double t = random.nextDouble();
      Vec3 axis = RandomGeometry.vector(random, 1);
      axis.mul(1 / axis.length(), axis);
      Vec3 p = RandomGeometry.vector(random, 1);
      p.mul(radius / p.length(), p);
      Pose from = new Pose();
      Pose to = new Pose();
      to.translation.set(RandomGeometry.vector(random, radius));
      to.rotation.setRotationVector(axis.mul(turn, axis));
      Vec3 arc = between(from, to, t).transform(p, new Vec3());
      Vec3 end = to.transform(p, new Vec3());
      Vec3 chord = end.sub(p, end).mul(t, end).add(p, end);
      double off = arc.sub(chord, arc).length();
      assertTrue(off <= StepLimits.SAGITTA_EDGES * edge * (1 + 1e-6), "off " + off);
    }
  }
}
