package org.palpate.benchmarks.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.BoxShape;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;

/** Checks that devices of studies press as deep, move as fast and turn as far as they say. */
class PressedMotionsTest {
  private static final double DEPTH_MM = 5;

  private final Pose pose = new Pose();
  private final Pose next = new Pose();
  private final Vec3 moved = new Vec3();
  private final Vec3 turned = new Vec3();
  private final Quaternion scratch = new Quaternion();

  @ParameterizedTest
  @ValueSource(strings = {"sphere", "plane", "torus"})
  void aBallSlidesAtTheDepthOnTheSurfaceAboveTheTruth(String kind) {
    SurfaceScene scene = SurfaceScene.of(kind, 96);
    double radiusMm = 4;
    BallSlide slide = new BallSlide(scene, radiusMm, 1_500, 3);
    assertEquals(slide.begin() + 1_500, slide.frames());
    Vec3 normal = new Vec3();
    Vec3 truth = new Vec3();
    double path = 0;
    double most = 0;
    for (int frame = slide.begin(); frame + 1 < slide.frames(); frame++) {
      Vec3 centre = slide.device(frame, pose).translation;
      assertEquals(radiusMm - DEPTH_MM, scene.truth().signedDistance(centre), 0.05, kind);
      slide.normal(frame, normal);
      assertEquals(1, normal.dot(scene.truth().normal(centre, truth)), 1e-3, kind);
      pose.differenceTo(slide.device(frame + 1, next), moved, turned, scratch);
      path += moved.length();
      most = Math.max(most, pose.rotation.rotationVector(new Vec3()).length());
    }
    double speed = path / (1_500 - 1);
    assertTrue(speed > 0.15 && speed < 0.4, "mm a frame: " + speed);
    double unit = Math.sqrt(0.25 + 0.36 + 1);
    assertEquals(0.17 * unit, most, 0.001, "the largest turn, rad");
  }

  @Test
  void aPressEndsAtTheDepthBelowTheFirstContact() {
    SurfaceScene scene = SurfaceScene.of("plane", 64);
    RigidTool tool = ToolSampler.ofShape(new BoxShape(4, 4, 4), 1);
    ToolRun run = new ToolRun(scene.bodies(), tool, ToolClearance.POINTS);
    PressAndSlide device = new PressAndSlide(scene, false);
    device.press(run);
    device.device(0, pose);
    double behindMm = run.motion.pose().translation.sub(pose.translation, moved).length();
    assertEquals(DEPTH_MM, behindMm, 0.6, "the depth, a step and what counts as contact");
    assertTrue(scene.truth().signedDistance(run.motion.pose().translation) > 0, "it lies outside");
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void theSlideStartsGentlyAndIsNeverFasterThanHalfAMillimetreAFrame(boolean isFlat) {
    PressAndSlide device = new PressAndSlide(SurfaceScene.of("sphere", 64), isFlat);
    double fastest = 0;
    double farthest = 0;
    double mostTurned = 0;
    Pose start = device.device(0, new Pose());
    device.device(0, pose);
    for (int frame = 1; frame < 3_000; frame++) {
      device.device(frame, next);
      pose.differenceTo(next, moved, turned, scratch);
      assertTrue(frame > 3 || moved.length() < 0.02, "frame " + frame + ": " + moved.length());
      fastest = Math.max(fastest, moved.length());
      start.differenceTo(next, moved, turned, scratch);
      farthest = Math.max(farthest, moved.length());
      mostTurned = Math.max(mostTurned, turned.length());
      pose.set(next);
    }
    assertTrue(fastest > 0.25 && fastest < 0.5, "mm a frame: " + fastest);
    assertTrue(farthest > 20 && farthest <= Math.hypot(20, 14), "mm from the start: " + farthest);
    double largest = (isFlat ? 0.1 : 1) * 0.17 * Math.sqrt(0.25 + 0.36 + 1);
    assertEquals(largest, mostTurned, 0.01 * largest, "rad");
  }

  @Test
  void aFaceLiesFlatOnTheSurface() {
    for (String kind : new String[] {"sphere", "torus"}) {
      SurfaceScene scene = SurfaceScene.of(kind, 64);
      Vec3 normal = new Vec3();
      scene.landing(new Vec3(), normal);
      new PressAndSlide(scene, true).device(0, pose);
      Vec3 face = pose.rotation.rotate(new Vec3(0, 0, 1), new Vec3());
      assertEquals(1, face.dot(normal), 1e-9, kind);
    }
  }
}
