package org.palpate.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.rigid.BodyMover.ClearCheck;
import org.palpate.rigid.BodyMover.ClearCheck.Answer;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/** Compares checks in parts with a look at every point and every voxel. */
class ClearCheckTest {
  private static final int EDGE = 20;
  private static final int LEAF_POINTS = 24;
  private static final Vec3 MIDDLE = new Vec3(10, 10, 10);

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final ExactRayCaster caster = new ExactRayCaster();

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void aCheckInPartsAnswersAsALookAtAllPointsAndVoxels(boolean wholeBodies) {
    int[] seen = new int[3];
    for (int n = 0; n < 300; n++) {
      BodyScene scene = new BodyScene(List.of(body("one", 0), body("other", 60)));
      MovableShapes shapes =
          wholeBodies ? MovableShapes.ofWholeBodies(scene, 0) : MovableShapes.ofPoints(scene);
      RigidSettings settings = RigidSettings.of(4, Clearance.POINTS);
      RigidScene rigid = new RigidScene(scene, ToolSampler.point(), shapes, settings);
      int body = random.nextInt(2);
      scene.body(1 - body).setPose(somewhere(3));
      Pose pose = somewhere(random.nextInt(3) == 0 ? 40 : 10);
      boolean clear = isClear(rigid.pair(0, 1), rigid.mover(body), pose);
      ClearCheck check = new BodyMover(rigid).clearCheck();
      boolean near = check.isNear(body, pose, 1 - body);
      assertTrue(near || clear, "seed " + Seeds.seed() + " case " + n);
      check.begin(body, pose, 1 - body);
      while (check.answer() == Answer.UNDECIDED) {
        int most = 1 + random.nextInt(200);
        assertTrue(check.goOn(most) <= most + LEAF_POINTS);
      }
      assertEquals(clear, check.answer() == Answer.CLEAR, "seed " + Seeds.seed() + " case " + n);
      seen[!near ? 0 : clear ? 1 : 2]++;
    }
    assertTrue(
        seen[0] > 5 && seen[1] > 20 && seen[2] > 20,
        "far, clear, blocked: " + List.of(seen[0], seen[1], seen[2]));
  }

  /** Makes a body of some balls, which may be hollow. */
  private Body body(String name, double x) {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    double radius = 4 + random.nextDouble(5);
    double hollow = random.nextBoolean() ? 0 : radius - 2;
    Vec3 at = new Vec3();
    for (int k = 0; k < EDGE; k++) {
      for (int j = 0; j < EDGE; j++) {
        for (int i = 0; i < EDGE; i++) {
          double distance = at.set(i + 0.5, j + 0.5, k + 0.5).sub(MIDDLE, at).length();
          if (distance <= radius && distance >= hollow) {
            bits.set(i, j, k);
          }
        }
      }
    }
    VoxelGrid grid = VoxelGrid.ofUnitVoxels(EDGE, EDGE, EDGE);
    Body body = new Body(name, bits, grid, Mobility.MOVABLE);
    body.setPose(Pose.at(x, 0, 0));
    return body;
  }

  /** Returns a pose that moves the middle of a body at most so far along each axis. */
  private Pose somewhere(double mostMm) {
    Pose pose = new Pose();
    pose.rotation.setRotationVector(
        new Vec3(random.nextDouble(2), random.nextDouble(2), random.nextDouble(2)));
    Vec3 away = RandomGeometry.vector(random, mostMm);
    MIDDLE.add(away, away).sub(pose.rotation.rotate(MIDDLE, new Vec3()), pose.translation);
    return ReferencePose.snap(pose);
  }

  private boolean isClear(BodyVerifier pair, Mover moved, Pose pose) {
    boolean movesPoints = pair.points == moved;
    Pose ofPoints =
        pair.points.toReference(movesPoints ? pose : pair.points.bodyPose(), new Pose());
    Pose ofVoxels = movesPoints ? pair.solid.bodyPose() : pose;
    AffineMap toGrid = pair.levels.body.toolToGrid(ofVoxels, ofPoints, new AffineMap());
    Vec3 point = new Vec3();
    for (int n = 0; n < pair.points.shape.count(); n++) {
      pair.points.shape.point(n, point);
      if (pair.levels.touches(point, toGrid, pair.levels.highest, caster)) {
        return false;
      }
    }
    return !pair.enclosure().enclosesAny(ofPoints, ofVoxels);
  }
}
