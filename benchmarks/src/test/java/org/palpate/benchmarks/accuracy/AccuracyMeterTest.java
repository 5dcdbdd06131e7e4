package org.palpate.benchmarks.accuracy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.AnalyticSurface;
import org.palpate.volume.phantom.Phantom;

/** Measures solvers whose errors the test plants. */
class AccuracyMeterTest {
  private static final double EDGE_MM = 128;
  private static final double DEPTH_MM = 3;
  private static final GridMetric METRIC = new GridMetric(1, 1, 2);
  private static final int FRAMES = 400;

  private final AnalyticSurface sphere =
      Phantom.parse("sphere:128").analyticSurface().orElseThrow();
  private final SlideTrajectory trajectory =
      new SlideTrajectory(sphere, EDGE_MM, DEPTH_MM, 0.5, FRAMES, 3);

  /** Writes where the point goes, mm, for a device at a depth below the surface. */
  private interface Placement {
    void place(int frame, Vec3 deviceMm, Vec3 normal, Vec3 dest);
  }

  private Accuracy measure(Placement placement) {
    ProxySolver solver =
        new ProxySolver() {
          private int frame;

          @Override
          public void follow(CollisionScene scene, Vec3 device, InteractionPoint point) {
            Vec3 mm = new Vec3(device.x, device.y, 2 * device.z);
            Vec3 normal = sphere.normal(mm, new Vec3());
            Vec3 placed = new Vec3();
            placement.place(frame++, mm, normal, placed);
            point.position.set(placed.x, placed.y, placed.z / 2);
            point.contact = true;
          }
        };
    CollisionScene empty = new CollisionScene(List.of(new BitCube(1, 1, 1)));
    return new AccuracyMeter(sphere, METRIC, trajectory, DEPTH_MM).measure(solver, empty);
  }

  private static void add(Vec3 to, double length, Vec3 along, Vec3 dest) {
    along.mul(length, dest).add(to, dest);
  }

  @Test
  void aPointOnTheTrueSurfaceHasNoError() {
    Accuracy accuracy = measure((n, device, normal, dest) -> add(device, DEPTH_MM, normal, dest));
    assertEquals(0, accuracy.angleWorstDegrees(), 1e-5);
    assertEquals(0, accuracy.heightMeanMm(), 1e-9);
    assertEquals(0, accuracy.heightStdMm(), 1e-7);
    assertEquals(1, accuracy.lag(), 1e-9);
    assertEquals(1, accuracy.forceChange(), 1e-6);
    assertEquals(0, accuracy.lostFrames());
  }

  @Test
  void aHeightThatAlternatesHasItsMeanAndDeviation() {
    Accuracy accuracy =
        measure(
            (n, device, normal, dest) ->
                add(device, DEPTH_MM + (n % 2 == 0 ? 0.5 : -0.1), normal, dest));
    assertEquals(0.2, accuracy.heightMeanMm(), 1e-9);
    assertEquals(0.3, accuracy.heightStdMm(), 1e-9);
    assertEquals((DEPTH_MM + 0.2) / DEPTH_MM, accuracy.lag(), 1e-9);
    assertEquals(0, accuracy.angleWorstDegrees(), 1e-5);
    assertTrue(accuracy.forceChange() > 3, "the force jumps by 0.6: " + accuracy);
  }

  @Test
  void everyTenthForceThatLeansByThirtyDegreesShowsInWorstAndMeanSquare() {
    Accuracy accuracy =
        measure(
            (n, device, normal, dest) -> {
              Vec3 sideways = normal.cross(new Vec3(1, 0, 0), new Vec3());
              sideways.mul(Math.tan(Math.toRadians(30)) / sideways.length(), sideways);
              Vec3 lean = n % 10 == 0 ? normal.add(sideways, new Vec3()) : normal;
              add(device, DEPTH_MM, lean, dest);
            });
    assertEquals(30, accuracy.angleWorstDegrees(), 1e-6);
    assertEquals(30 / Math.sqrt(10), accuracy.angleRmsDegrees(), 1e-6);
  }

  @Test
  void aPointThatFollowsTheDeviceIntoTheSolidLosesEveryFrame() {
    Accuracy accuracy = measure((n, device, normal, dest) -> dest.set(device));
    assertEquals(FRAMES, accuracy.lostFrames());
    assertEquals(180, accuracy.angleRmsDegrees(), 1e-9);
    assertEquals(-DEPTH_MM, accuracy.heightMeanMm(), 1e-9);
    assertEquals(0, accuracy.lag());
    assertEquals(0, accuracy.forceChange());
  }

  @Test
  void anAngleIsThatBetweenForceAndNormalAndAHalfTurnWithoutAForce() {
    Vec3 normal = new Vec3(0, 0, 1);
    assertEquals(90, AccuracyMeter.angleDegrees(new Vec3(5, 0, 0), normal), 1e-12);
    assertEquals(45, AccuracyMeter.angleDegrees(new Vec3(0, 2, 2), normal), 1e-12);
    assertEquals(180, AccuracyMeter.angleDegrees(new Vec3(), normal));
    Vec3 odd = new Vec3(0.1, 0.7, 0.3);
    odd.mul(1 / odd.length(), odd);
    assertEquals(0, AccuracyMeter.angleDegrees(odd, odd), 2e-6, "rounding is no NaN");
  }

  @Test
  void aForceOnAPlaneHasNoTrueChangeToCompareWith() {
    AnalyticSurface plane = new HorizontalPlane(64);
    SlideTrajectory slide = new SlideTrajectory(plane, EDGE_MM, DEPTH_MM, 0.5, FRAMES, 3);
    ProxySolver lagging = (scene, device, point) -> point.position.set(device.x, device.y, 32);
    CollisionScene empty = new CollisionScene(List.of(new BitCube(1, 1, 1)));
    Accuracy accuracy = new AccuracyMeter(plane, METRIC, slide, DEPTH_MM).measure(lagging, empty);
    assertEquals(Double.POSITIVE_INFINITY, accuracy.forceChange());
  }

  @Test
  void theDeviceSlidesAtItsDepthWithItsSpeedWithinTheCube() {
    Vec3 device = new Vec3();
    Vec3 normal = new Vec3();
    Vec3 before = new Vec3();
    for (int frame = trajectory.slideStart(); frame < trajectory.frames(); frame++) {
      trajectory.device(frame, device);
      assertEquals(-DEPTH_MM, sphere.signedDistance(device), 1e-9);
      sphere.normal(device, normal);
      assertEquals(1, normal.dot(trajectory.normal(frame, new Vec3())), 1e-12);
      trajectory.device(frame - 1, before);
      double moved = device.sub(before, before).length();
      assertTrue(moved > 0.4 && moved < 0.5, "3 mm below the surface: " + moved);
      for (int axis = 0; axis < 3; axis++) {
        assertTrue(device.get(axis) > 0 && device.get(axis) < EDGE_MM);
      }
    }
    assertEquals(FRAMES, trajectory.frames() - trajectory.slideStart());
  }

  @Test
  void theDeviceComesDownFromFourMillimetresAbove() {
    Vec3 device = new Vec3();
    assertEquals(4, sphere.signedDistance(trajectory.device(0, device)), 1e-9);
    double last = 5;
    for (int frame = 0; frame < 140; frame++) {
      double height = sphere.signedDistance(trajectory.device(frame, device));
      assertTrue(height < last, "frame=" + frame);
      last = height;
    }
  }

  @Test
  void theSeedAloneDecidesOnTheSlide() {
    SlideTrajectory same = new SlideTrajectory(sphere, EDGE_MM, DEPTH_MM, 0.5, FRAMES, 3);
    SlideTrajectory other = new SlideTrajectory(sphere, EDGE_MM, DEPTH_MM, 0.5, FRAMES, 4);
    int differing = 0;
    for (int frame = 0; frame < trajectory.frames(); frame++) {
      Vec3 device = trajectory.device(frame, new Vec3());
      assertTrue(device.sameBits(same.device(frame, new Vec3())));
      differing += device.sameBits(other.device(frame, new Vec3())) ? 0 : 1;
    }
    assertTrue(differing >= FRAMES, "differing=" + differing);
  }

  @Test
  void sampledSolidsHaveTheVoxelsWhoseCentresLieWithin() {
    Vec3 spacing = new Vec3(4, 2, 8);
    BitCube bits = SampledSolids.of(sphere, EDGE_MM, spacing);
    assertEquals(List.of(32, 64, 16), List.of(bits.sizeX(), bits.sizeY(), bits.sizeZ()));
    long solid = 0;
    for (int n = 0; n < 32 * 64 * 16; n++) {
      int i = n % 32;
      int j = n / 32 % 64;
      int k = n / 2048;
      Vec3 centre = new Vec3(4 * i + 2, 2 * j + 1, 8 * k + 4);
      boolean within = sphere.signedDistance(centre) < 0;
      assertEquals(within, bits.get(i, j, k), () -> centre.toString());
      solid += within ? 1 : 0;
    }
    assertTrue(solid > 1_000);
  }
}
