package org.palpate.benchmarks.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.body.BodyScene;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.tool.BoxShape;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.volume.BitCube;

class JudgesTest {
  private static BodyScene dot() {
    BitCube bits = new BitCube(3, 3, 3);
    bits.set(1, 1, 1);
    return SurfaceScene.scene(bits);
  }

  @Test
  void cuboidsThatTouchDoNotOverlapButTheSmallestDepthDoes() {
    SolidOverlap overlap = SolidOverlap.ofBox(new BoxShape(1, 1, 1));
    assertFalse(overlap.overlaps(dot(), Pose.at(2.5, 1.5, 1.5)));
    assertTrue(overlap.overlaps(dot(), Pose.at(2.5 - 1e-6, 1.5, 1.5)));
    Pose turned = Pose.at(2 + Math.sqrt(0.5) + 1e-6, 1.5, 1.5);
    turned.rotation.setRotationVector(new Vec3(0, 0, Math.PI / 4));
    assertFalse(overlap.overlaps(dot(), turned));
    turned.translation.x -= 1e-5;
    assertTrue(overlap.overlaps(dot(), turned));
  }

  @Test
  void onlyACrossProductOfEdgesSeparatesTwoCuboidsEdgeToEdge() {
    SolidOverlap overlap = SolidOverlap.ofBox(new BoxShape(20, 1, 1));
    Pose pose = new Pose();
    pose.rotation.setRotationVector(new Vec3(Math.PI / 4, 0, 0));
    Pose turned = new Pose();
    turned.rotation.setRotationVector(new Vec3(0, 0, Math.PI / 4));
    turned.multiply(pose, pose);
    double far = Math.sqrt(0.5) + Math.sqrt(0.5); // voxel's edge z to the cuboid's long edge
    Vec3 out = new Vec3(Math.sqrt(0.5), -Math.sqrt(0.5), 0);
    out.mul(far + 1e-6, pose.translation).add(new Vec3(1.5, 1.5, 1.5), pose.translation);
    assertFalse(overlap.overlaps(dot(), pose));
    out.mul(far - 1e-4, pose.translation).add(new Vec3(1.5, 1.5, 1.5), pose.translation);
    assertTrue(overlap.overlaps(dot(), pose));
  }

  @Test
  void aBallOverlapsACornerExactlyFromItsRadiusOn() {
    SolidOverlap overlap = SolidOverlap.ofBall(2);
    double side = 2 / Math.sqrt(3);
    assertFalse(overlap.overlaps(dot(), Pose.at(2 + side + 1e-6, 2 + side, 2 + side)));
    assertTrue(overlap.overlaps(dot(), Pose.at(2 + side - 1e-6, 2 + side - 1e-6, 2 + side - 1e-6)));
  }

  @Test
  void theLegJudgeFindsALegThroughASolidAndABrokenChain() {
    RigidTool point = ToolSampler.point();
    BodyScene empty = SurfaceScene.scene(new BitCube(3, 3, 3));
    ToolRun run = new ToolRun(empty, point, ToolClearance.POINTS);
    run.start(Pose.at(0.5, 1.5, 1.5));
    RigidLegJudge judge = new RigidLegJudge(10);
    judge.begin(run.motion);
    run.follow(Pose.at(2.5, 1.5, 1.5));
    judge.judge(dot(), point, run.motion); // the solver did not know this solid
    assertEquals(List.of(1L, 1L, 0L), List.of(judge.legs(), judge.touching(), judge.broken()));
    run.follow(Pose.at(2.5, 2.5, 1.5));
    run.follow(Pose.at(2.5, 2.5, 2.5));
    judge.judge(dot(), point, run.motion);
    assertEquals(List.of(2L, 1L, 1L), List.of(judge.legs(), judge.touching(), judge.broken()));
    assertEquals(2, judge.compared());
    assertEquals(0, judge.disagreements());
  }

  @Test
  void aKeepOutMeasuresTheDistanceOfALineFromTheNearestCell() {
    KeepOut keepOut = new KeepOut(dot(), ToolSampler.point(), Clearance.POINTS);
    Vec3 origin = new Vec3(1.5, 3.25, -7);
    assertEquals(1.25, keepOut.distanceFromLineMm(origin, new Vec3(0, 0, 1)), 1e-9);
    Vec3 diagonal = new Vec3(Math.sqrt(0.5), -Math.sqrt(0.5), 0);
    assertEquals(Math.sqrt(0.5), keepOut.distanceFromLineMm(new Vec3(3, 2, 1.5), diagonal), 1e-9);
    assertTrue(keepOut.isFree(Pose.at(2.5, 1.5, 1.5)));
    assertFalse(keepOut.isFree(Pose.at(1.5, 1.5, 1.5)));
    assertFalse(keepOut.isFree(Pose.at(0.5, 1.5, 1.5), Pose.at(2.5, 1.5, 1.5)));
  }

  /** Grown cells begin before the grid, and there are several for each voxel. */
  @Test
  void aKeepOutOfGrownCellsIsAsFarFromALineAsTheClearanceSays() {
    Clearance clearance = new Clearance(0.5, 0.5, 1);
    KeepOut keepOut = new KeepOut(dot(), ToolSampler.point(), clearance);
    Vec3 up = new Vec3(0, 0, 1);
    double voxelMm = 3.25 - 2;
    double grownMm = keepOut.distanceFromLineMm(new Vec3(1.5, 3.25, -7), up);
    assertEquals(voxelMm - 0.5, grownMm, 0.5, "a voxel less its growth");
    assertTrue(grownMm < voxelMm - 0.2, "the growth counts: " + grownMm);
    assertEquals(
        grownMm, keepOut.distanceFromLineMm(new Vec3(1.5, -0.25, -7), up), 1e-9, "on both sides");
    assertFalse(keepOut.isFree(Pose.at(2.2, 1.5, 1.5)), "0.2 mm from the voxel");
    assertFalse(keepOut.isFree(Pose.at(1.5, 0.8, 1.5)), "0.2 mm from the voxel");
    assertFalse(keepOut.isFree(Pose.at(1.5, 1.5, 2.2)), "0.2 mm from the voxel");
    assertTrue(keepOut.isFree(Pose.at(2.9, 1.5, 1.5)));
  }

  /** The nearest of many cells counts, in whatever order they come. */
  @Test
  void aKeepOutOfManyCellsIsAsFarAsTheNearest() {
    BitCube bits = new BitCube(9, 9, 2);
    bits.set(0, 0, 0);
    bits.set(4, 1, 1);
    bits.set(8, 1, 1);
    bits.set(8, 8, 0);
    KeepOut keepOut = new KeepOut(SurfaceScene.scene(bits), ToolSampler.point(), Clearance.POINTS);
    Vec3 up = new Vec3(0, 0, 1);
    assertEquals(1.3, keepOut.distanceFromLineMm(new Vec3(6.3, 1.5, 0), up), 1e-9);
    assertEquals(1.4, keepOut.distanceFromLineMm(new Vec3(6.6, 1.5, 0), up), 1e-9);
    assertEquals(Math.hypot(1, 2), keepOut.distanceFromLineMm(new Vec3(7, 6, 0), up), 1e-9);
    assertEquals(0.5, keepOut.distanceFromLineMm(new Vec3(0.5, 1.5, 0), up), 1e-9);
  }
}
