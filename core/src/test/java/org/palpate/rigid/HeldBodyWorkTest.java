package org.palpate.rigid;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import java.util.stream.LongStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.palpate.body.BodyScene;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.RoughBlocks;
import org.palpate.testing.Seeds;
import org.palpate.volume.VoxelGrid;

/**
 * Bounds the work of a body in hand, in units that no machine changes, for several seeds. A
 * trembling hand presses blocks into others whose rough faces fit: turned, and too low. So they are
 * stuck, and each frame may try steps along faces of voxels.
 */
class HeldBodyWorkTest {
  /** The most work of a frame, in its budget. */
  private static final double MOST_BUDGETS = 3;

  /** The most work of all but a hundredth of the frames, in that without steps along faces. */
  private static final double MOST_WITHOUT_STEPS = 2;

  private static final Vec3[] SPACINGS_MM = {
    new Vec3(1, 1, 1), new Vec3(0.8, 1, 1.3), new Vec3(1, 1, 2)
  };

  private static final int EDGE = 12;
  private static final int SCENES = 36;
  private static final int FRAMES = 300;
  private static final double APPROACH_FRAMES = 120;
  private static final double FROM_VOXELS = 6;
  private static final double TREMOR_MM = 0.1;

  private final RigidTool point = ToolSampler.point();
  private final Quaternion scratch = new Quaternion();

  private static LongStream seeds() {
    return LongStream.of(Seeds.seed(), 1, 7);
  }

  @ParameterizedTest
  @MethodSource("seeds")
  void framesAmongTeethStayNearTheirBudgetAndRarelyTakeMuchMoreThanWithoutStepsAlongFaces(
      long seed) {
    long[] work = new long[SCENES * FRAMES];
    pressAll(seed, false, work);
    long usualWithout = usual(work);
    double mostBudgets = pressAll(seed, true, work);
    String found =
        String.format(
            "budgets=%.2f usual=%d without=%d seed=%d",
            mostBudgets, usual(work), usualWithout, seed);
    System.out.println("work units of a body in hand: " + found);
    assertTrue(mostBudgets <= MOST_BUDGETS, found);
    assertTrue(usual(work) <= MOST_WITHOUT_STEPS * usualWithout, found);
  }

  /** Returns the most work of all but a hundredth of the frames. */
  private static long usual(long[] work) {
    return LongStream.of(work).sorted().skip(work.length * 99L / 100).findFirst().orElseThrow();
  }

  /** Presses blocks into others; returns the most work of a frame, in its budget. */
  private double pressAll(long seed, boolean leavesSurface, long[] work) {
    SplittableRandom random = new SplittableRandom(seed);
    double mostBudgets = 0;
    for (int n = 0; n < SCENES; n++) {
      mostBudgets = Math.max(mostBudgets, press(random, n, leavesSurface, work));
    }
    return mostBudgets;
  }

  /** Presses a block into another one; returns the most work of a frame, in its budget. */
  private double press(SplittableRandom random, int number, boolean leavesSurface, long[] work) {
    Vec3 spacing = SPACINGS_MM[number % SPACINGS_MM.length];
    BodyScene scene = scene(random, spacing);
    RigidSolver tool = solver(scene, number / SPACINGS_MM.length % 3);
    ToolMotion motion = tool.newMotion();
    scene.body(1).setPose(Pose.at(0, 0, FROM_VOXELS * spacing.z));
    tool.place(Pose.at(-1000, 0, 0), motion);
    RigidSolver hand = tool.ofBody(1, leavesSurface);
    hand.takeOver(motion);
    Pose end = new Pose();
    hand.shape().referenceMm(end.translation);
    Vec3 skewMm = RandomGeometry.vector(random, 0.5);
    skewMm.z = random.nextDouble(-1.5, 0);
    end.displace(skewMm, RandomGeometry.vector(random, 0.05), 1, scratch, end);
    Pose device = new Pose();
    double mostBudgets = 0;
    for (int n = 0; n < FRAMES; n++) {
      Vec3 tremor = RandomGeometry.vector(random, TREMOR_MM);
      device.set(end).translation.add(tremor, device.translation);
      device.translation.z += FROM_VOXELS * spacing.z * Math.max(0, 1 - n / APPROACH_FRAMES);
      hand.follow(device, motion);
      work[number * FRAMES + n] = hand.work();
      mostBudgets = Math.max(mostBudgets, (double) hand.work() / hand.budget.limit());
    }
    return mostBudgets;
  }

  private static BodyScene scene(SplittableRandom random, Vec3 spacing) {
    VoxelGrid grid = new VoxelGrid(EDGE, EDGE, EDGE, spacing, RigidTransform.identity());
    int rough = random.nextInt(1, 5);
    return RoughBlocks.scene(random, grid, EDGE / 2 - rough / 2, EDGE / 2 + (rough + 1) / 2);
  }

  /** Makes a solver with one of three kinds of clearance. */
  private RigidSolver solver(BodyScene scene, int kind) {
    double margin = -0.5 * scene.shortestEdgeMm();
    MovableShapes shapes =
        switch (kind) {
          case 0 -> MovableShapes.ofWholeBodies(scene, margin);
          case 1 -> MovableShapes.ofPoints(scene);
          default -> MovableShapes.ofWholeBodies(scene, 0);
        };
    RigidSettings settings =
        kind == 2
            ? RigidSettings.ofWholeBodies(8, scene, point)
            : RigidSettings.of(8, Clearance.POINTS);
    return new RigidSolver(new RigidScene(scene, point, shapes, settings));
  }
}
