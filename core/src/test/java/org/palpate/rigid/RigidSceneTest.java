package org.palpate.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Pose;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

class RigidSceneTest {
  private static Body block(String name, int edge, Mobility mobility, double x) {
    VoxelGrid grid = VoxelGrid.ofUnitVoxels(edge, edge, edge);
    Body body = new Body(name, ToolScenes.block(edge, edge, edge), grid, mobility);
    body.setPose(Pose.at(x, 0, 0));
    return body;
  }

  @Test
  void aBodyThatEnclosesAnotherForGoodDelaysNoOtherExamination() {
    Body dot = block("dot", 1, Mobility.FIXED, 0);
    Body block = block("block", 12, Mobility.MOVABLE, 40);
    Body wall = block("wall", 8, Mobility.FIXED, -40);
    BodyScene scene = new BodyScene(List.of(dot, block, wall));
    RigidTool ball = ToolSampler.ofShape(RodShape.sphere(2), 0.5);
    RigidScene rigid =
        new RigidScene(
            scene,
            ball,
            MovableShapes.ofWholeBodies(scene, 0),
            RigidSettings.ofWholeBodies(4, scene, ball));
    RigidSolver solver = new RigidSolver(rigid);
    ToolMotion motion = solver.newMotion();
    block.setPose(Pose.at(-5.5, -5.5, -5.5)); // the dot is in its middle
    assertTrue(solver.place(Pose.at(-29.9, 4, 4), motion), "0.1 mm from the wall");
    assertTrue(motion.reducedPoints() > 0, "nearer than the clearance");
    for (int frame = 0; frame < 100; frame++) {
      solver.follow(Pose.at(-25, 4, 4), motion);
    }
    assertTrue(rigid.verifier(1).pair(0).enclosure().isPending(), "the block encloses the dot");
    assertEquals(0, motion.reducedPoints(), "the tool encloses nothing");
  }

  @Test
  void bodiesThatWerePutIntoEachOtherStayIfASamplePointTouchesAndElseMove() {
    Body dot = block("dot", 1, Mobility.FIXED, 0);
    Body block = block("block", 12, Mobility.MOVABLE, 40);
    BodyScene scene = new BodyScene(List.of(dot, block));
    RigidSettings settings = RigidSettings.of(4, Clearance.POINTS);
    RigidSolver solver =
        new RigidSolver(
            new RigidScene(
                scene, ToolSampler.point(), MovableShapes.ofWholeBodies(scene, 0), settings));
    ToolMotion motion = solver.newMotion();
    for (double x : new double[] {-0.5, -5.5}) { // the dot at the surface, and in the middle
      block.setPose(Pose.at(x, -5.5, -5.5));
      solver.place(Pose.at(0, 0, 90), motion);
      solver.bodies().setGoal(1, Pose.at(x - 1, -5.5, -5.5));
      solver.rest(motion);
      solver.rest(motion);
      assertEquals(x == -0.5 ? x : x - 1, block.pose().translation.x);
    }
    assertEquals(2, solver.bodies().heldBack());
  }

  @Test
  void pointsOfBodiesThatTouchAtTheStartOrAfterAnEditCountAsReducedThoughTheToolIsFar() {
    BodyScene apart = bodies(Pose.at(5.2, 0, 0));
    RigidSolver solver = solver(apart);
    ToolMotion motion = solver.newMotion();
    solver.place(Pose.at(0, 0, 90), motion);
    solver.rest(motion);
    assertEquals(0, solver.bodies().mostReducedPoints());
    apart.body(0).bits().set(4, 2, 2); // 0.2 mm from the block
    IntBox added = new IntBox();
    added.include(4, 2, 2);
    apart.body(0).voxelsChanged(added);
    solver.follow(Pose.at(0, 0, 91), motion);
    int near = solver.bodies().mostReducedPoints();
    assertTrue(near > 0 && near < 16, "a voxel is near: " + near);

    BodyScene touching = bodies(Pose.at(4, 0, 0));
    solver = solver(touching);
    motion = solver.newMotion();
    solver.place(Pose.at(0, 0, 90), motion);
    assertEquals(0, motion.reducedPoints(), "the tool is far");
    int most = solver.bodies().mostReducedPoints();
    assertTrue(most >= 16, "a face of 4 x 4 voxels touches: " + most);
    solver.bodies().setGoal(1, Pose.at(9, 0, 0));
    for (int frame = 0; frame < 20; frame++) {
      solver.rest(motion);
    }
    assertEquals(9, touching.body(1).pose().translation.x);
    assertEquals(most, solver.bodies().mostReducedPoints(), "the most of any frame");
  }

  /** Returns a block in a larger grid that stands still, and one that moves. */
  private static BodyScene bodies(Pose ofSecond) {
    BitCube bits = new BitCube(6, 6, 6);
    for (int n = 0; n < 64; n++) {
      bits.set(n % 4, n / 4 % 4, n / 16);
    }
    Body first = new Body("first", bits, VoxelGrid.ofUnitVoxels(6, 6, 6), Mobility.FIXED);
    Body second = block("second", 4, Mobility.MOVABLE, 0);
    second.setPose(ofSecond);
    return new BodyScene(List.of(first, second));
  }

  private static RigidSolver solver(BodyScene scene) {
    RigidSettings settings = RigidSettings.of(4, Clearance.POINTS);
    MovableShapes shapes = MovableShapes.ofWholeBodies(scene, 0);
    return new RigidSolver(new RigidScene(scene, ToolSampler.point(), shapes, settings));
  }

  @ParameterizedTest
  @ValueSource(doubles = {-0.5, -0.4, -0.25})
  void partsOfOneVolumeKeepANegativeMarginWhereTheyFit(double marginMm) {
    SplittableRandom random = new SplittableRandom(Double.hashCode(marginMm));
    VoxelGrid grid = VoxelGrid.ofUnitVoxels(12, 12, 24);
    BitCube low = new BitCube(12, 12, 24);
    BitCube high = new BitCube(12, 12, 24);
    for (int k = 2; k < 22; k++) {
      for (int j = 2; j < 10; j++) {
        for (int i = 2; i < 10; i++) {
          (k + random.nextInt(7) < 15 ? low : high).set(i, j, k); // pits and steps of six voxels
        }
      }
    }
    BodyScene scene =
        new BodyScene(
            List.of(
                new Body("low", low, grid, Mobility.FIXED),
                new Body("high", high, grid, Mobility.MOVABLE)));
    MovableShapes shapes = MovableShapes.ofWholeBodies(scene, marginMm);
    RigidScene rigid =
        new RigidScene(scene, ToolSampler.point(), shapes, RigidSettings.of(4, Clearance.POINTS));
    assertEquals(0, rigid.verifier(1).pair(0).reducedCount());
    assertTrue(shapes.shapes().get(1).count() > 1000);
  }
}
