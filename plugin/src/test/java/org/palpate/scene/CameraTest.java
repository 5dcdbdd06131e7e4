package org.palpate.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;

class CameraTest {
  private static final long SEED = Seeds.seed();
  private static final double ASPECT = 1.6;
  private static final double NEAR = 1e-9;

  private final SplittableRandom random = new SplittableRandom(SEED);

  private Camera randomCamera() {
    List<Vec3> points = List.of(RandomGeometry.vector(random, 90));
    Camera camera = Camera.seeing(new Vec3(5, -7, 11), points, StandardView.OBLIQUE, 1);
    return camera.orbit(random.nextDouble(-3, 3), random.nextDouble(-1, 1));
  }

  /** Returns where a point lies in the picture of an eye: from -1 to 1 along both edges. */
  private static Vec3 inPicture(Camera camera, int eye, Vec3 point) {
    Matrix4 projection =
        camera.perspective(eye, ASPECT, new Vec3(5, -7, 11), 500).times(camera.view(eye));
    Vec3 found = new Vec3();
    assertTrue(projection.project(point, found) > 0, "seed=" + SEED + " behind the eye");
    return found;
  }

  /** Returns a point in front of the target, as the camera sees it. */
  private static Vec3 inFront(Camera camera, double mm) {
    Vec3 target = camera.eye().sub(camera.back().mul(camera.distanceMm(), new Vec3()), new Vec3());
    return target.add(camera.back().mul(mm, new Vec3()), target);
  }

  @ParameterizedTest
  @EnumSource(StandardView.class)
  void allPointsAreInThePictureAndItsEdgeIsNear(StandardView view) {
    for (int round = 0; round < 50; round++) {
      Vec3 middle = RandomGeometry.vector(random, 100);
      List<Vec3> points = new ArrayList<>();
      for (int n = 0; n < 8; n++) {
        points.add(RandomGeometry.vector(random, 40).add(middle, new Vec3()));
      }
      Camera camera = Camera.seeing(middle, points, view, ASPECT);
      double most = 0;
      for (Vec3 point : points) {
        Vec3 seen = inPicture(camera, 0, point);
        most = Math.max(most, Math.max(Math.abs(seen.x), Math.abs(seen.y)));
      }
      assertEquals(1 / 1.06, most, 1e-9, "seed=" + SEED + " round=" + round);
      assertEquals(0, inPicture(camera, 0, middle).x, NEAR);
      assertEquals(0, inPicture(camera, 0, middle).y, NEAR);
    }
  }

  @Test
  void withoutPointsTheCameraStandsJustBeforeItsTarget() {
    Camera camera = Camera.seeing(new Vec3(1, 2, 3), List.of(), StandardView.FRONT, 1);
    assertEquals(1e-3, camera.distanceMm());
    assertEquals("(1.0, 1.999, 3.0)", camera.eye().toString());
  }

  @Test
  void aTurnToTheRightMovesTheNearSideToTheRightAndKeepsTheDistance() {
    for (int round = 0; round < 50; round++) {
      Camera camera = randomCamera();
      Vec3 near = inFront(camera, camera.distanceMm() / 4);
      Camera right = camera.orbit(0.2, 0);
      assertEquals(camera.distanceMm(), right.distanceMm());
      assertEquals(0, inFront(right, 0).sub(inFront(camera, 0), new Vec3()).length(), 1e-9);
      assertTrue(inPicture(right, 0, near).x > 0.01, "seed=" + SEED);
      assertEquals(0, inPicture(right, 0, near).y, NEAR);
      Camera up = camera.orbit(0, 0.2);
      assertTrue(inPicture(up, 0, near).y > 0.01, "seed=" + SEED);
      assertEquals(0, inPicture(up, 0, near).x, NEAR);
      assertEquals(Math.cos(0.2), camera.back().dot(up.back()), 1e-12);
      assertAxes(camera.orbit(1.1, -0.4));
    }
  }

  private static void assertAxes(Camera camera) {
    Vec3 cross = camera.right().cross(camera.up(), new Vec3());
    assertEquals(0, cross.sub(camera.back(), cross).length(), 1e-12, "right-handed unit axes");
    assertEquals(1, camera.right().length(), 1e-12);
  }

  @Test
  void aPanMovesTheTargetByTheAskedHeightsOfThePicture() {
    for (int round = 0; round < 50; round++) {
      Camera camera = randomCamera();
      Vec3 target = inFront(camera, 0);
      double right = random.nextDouble(-0.4, 0.4);
      double up = random.nextDouble(-0.4, 0.4);
      Vec3 seen = inPicture(camera.pan(right, up), 0, target);
      assertEquals(2 * right / ASPECT, seen.x, NEAR, "seed=" + SEED);
      assertEquals(2 * up, seen.y, NEAR, "seed=" + SEED);
    }
  }

  @Test
  void zoomChangesTheDistanceAlone() {
    Camera camera = randomCamera();
    Camera nearer = camera.zoom(0.25);
    assertEquals(camera.distanceMm() / 4, nearer.distanceMm(), 1e-12);
    assertEquals(0, inFront(nearer, 0).sub(inFront(camera, 0), new Vec3()).length(), 1e-9);
    assertTrue(nearer.right().sameBits(camera.right()) && nearer.up().sameBits(camera.up()));
  }

  @Test
  void upsideDownTurnsThePictureByHalfATurn() {
    Camera camera = randomCamera();
    Vec3 point = RandomGeometry.vector(random, 20);
    Vec3 before = inPicture(camera, 0, point);
    Vec3 after = inPicture(camera.upsideDown(), 0, point);
    assertEquals(-before.x, after.x, NEAR);
    assertEquals(-before.y, after.y, NEAR);
  }

  @Test
  void twoEyesSeeTheTargetAtTheSamePlaceAndNearerPointsApart() {
    Camera camera = randomCamera();
    assertTrue(camera.eye(0).sub(camera.eye(), new Vec3()).length() == 0);
    Vec3 between = camera.eye(1).sub(camera.eye(-1), new Vec3());
    assertEquals(camera.distanceMm() / 15, between.length(), 1e-9);
    assertEquals(camera.distanceMm() / 15, between.dot(camera.right()), 1e-9);
    Vec3 target = inFront(camera, 0);
    assertEquals(inPicture(camera, -1, target).x, inPicture(camera, 1, target).x, NEAR);
    Vec3 near = inFront(camera, camera.distanceMm() / 4);
    assertTrue(
        inPicture(camera, -1, near).x > inPicture(camera, 1, near).x,
        "the left eye sees what is near further to the right");
  }

  @Test
  void aDragTurnsTheNearSideAlongWithTheMouseInEveryWorld() {
    for (WorldAxes world : WorldAxes.values()) {
      Camera camera = randomCamera();
      Vec3 rotation = camera.dragRotation(0.3, -0.1, world);
      assertEquals(Math.PI * Math.hypot(0.3, 0.1), rotation.length(), 1e-12);
      Vec3 near = world.toSceneOrBack(camera.back(), new Vec3());
      Quaternion small = new Quaternion();
      small.setRotationVector(rotation.mul(1e-4, rotation));
      Vec3 moved = small.rotate(near, new Vec3()).sub(near, new Vec3());
      world.toSceneOrBack(moved, moved);
      assertEquals(0.3 * Math.PI * 1e-4, moved.dot(camera.right()), 1e-8, "" + world);
      assertEquals(-0.1 * Math.PI * 1e-4, moved.dot(camera.up()), 1e-8, "" + world);
    }
  }

  @Test
  void theBallOfTheSceneLiesBetweenTheNearAndTheFarPlane() {
    Camera camera = Camera.seeing(new Vec3(), List.of(new Vec3(30, 0, 0)), StandardView.FRONT, 1);
    Matrix4 projection = camera.perspective(0, 1, new Vec3(), 30).times(camera.view(0));
    for (double depth : new double[] {-30, -29, 0, 29, 30}) {
      Vec3 seen = new Vec3();
      projection.project(new Vec3(0, depth, 0), seen);
      assertTrue(seen.z > -1 && seen.z < 1, "depth " + depth + " at " + seen.z);
    }
    Vec3 beyond = new Vec3();
    projection.project(new Vec3(0, 40, 0), beyond);
    assertTrue(beyond.z > 1, "beyond the far plane");
  }
}
