package org.palpate.accuracy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.benchmarks.accuracy.Accuracy;
import org.palpate.benchmarks.accuracy.AccuracyMeter;
import org.palpate.benchmarks.accuracy.SlideTrajectory;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.testing.Seeds;
import org.palpate.volume.phantom.AnalyticSurface;
import org.palpate.volume.phantom.Phantom;

/** Bounds the errors of the smooth solver's force on grey values. */
class GreyAccuracyTest {
  private static final int EDGE = 192;
  private static final int FRAMES = 3000;
  private static final long SEED = 7;
  private static final GridMetric UNIT = new GridMetric(1, 1, 1);

  @ParameterizedTest
  @ValueSource(strings = {"sphere:64:grey", "plane:64:grey", "torus:64:grey"})
  void theContrastIsFoundFromTheValuesAtTheSurface(String spec) {
    GreySolids solid = new GreySolids(Phantom.parse(spec), 0, Seeds.seed());
    double contrast = GreyIsosurface.ofThreshold(solid.volume, Phantom.HALF_GREY).contrast();
    assertEquals(Phantom.HALF_GREY, contrast, 0.15 * Phantom.HALF_GREY, spec);
  }

  @Test
  void theForceOnAPlaneIsWithinAThirdOfADegree() {
    check("plane", 0, new double[][] {{2, 0.3, 1}, {5, 0.3, 1}, {10, 0.3, 1}}, 0.02);
  }

  @Test
  void theForceOnASphereIsWithinHalfADegree() {
    check("sphere", 0, new double[][] {{2, 0.5, 2}, {5, 0.5, 2}, {10, 0.5, 2}}, 0.02);
  }

  @Test
  void theForceOnATorusIsWithinADegree() {
    check("torus", 0, new double[][] {{2, 0.8, 3}, {5, 0.8, 3}, {10, 1.2, 5}}, 0.03);
  }

  @ParameterizedTest
  @CsvSource({
    "1.3, plane, 0.25, 0.6, 0.01, 0.02",
    "1.3, sphere, 0.35, 1.7, 0.03, 0.02",
    "1.3, torus, 0.5, 2.2, 0.03, 0.02",
    "2, plane, 0.2, 0.5, 0.01, 0.02",
    "2, sphere, 0.25, 1.2, 0.03, 0.02",
    "2, torus, 0.45, 1.4, 0.03, 0.02",
    "3, plane, 0.2, 0.5, 0.01, 0.02",
    "3, sphere, 0.25, 1.2, 0.03, 0.02",
    "3, torus, 0.45, 1.4, 0.03, 0.02",
    "5, plane, 0.18, 0.45, 0.01, 0.02",
    "5, sphere, 0.25, 1.2, 0.03, 0.02",
    "5, torus, 0.45, 1.6, 0.04, 0.02",
    "10, plane, 0.2, 0.6, 0.02, 0.04"
  })
  void slicesFartherApartThanPixelsHardlyTiltTheForce(
      double ratio, String shape, double rms, double worst, double heightStd, double lagOff) {
    Vec3 spacing = new Vec3(1, 1, ratio);
    GreySolids solids = solids(shape, spacing);
    for (double speed : new double[] {0.05, 0.3, 2}) {
      assertWithin(measure(solids, shape, spacing, speed), rms, worst, heightStd, lagOff);
    }
  }

  @ParameterizedTest
  @CsvSource({"1, 2, 2", "2, 1, 2", "2, 2, 1"})
  void voxelsThatAreLongAlongTwoAxesHardlyTiltTheForce(double x, double y, double z) {
    Vec3 spacing = new Vec3(x, y, z);
    checkSlides("plane", spacing, 0.25, 0.6, 0.01);
    checkSlides("sphere", spacing, 0.25, 1.2, 0.03);
    checkSlides("torus", spacing, 0.45, 1.4, 0.03);
  }

  @ParameterizedTest
  @CsvSource({"1, 3, 5", "5, 1, 4", "5, 5, 1"})
  void voxelsThatAreVeryLongAlongTwoAxesTiltTheForceByADegreeOrTwo(double x, double y, double z) {
    Vec3 spacing = new Vec3(x, y, z);
    checkSlides("plane", spacing, 0.5, 1.2, 0.03);
    checkSlides("sphere", spacing, 0.6, 2, 0.35);
    checkSlides("torus", spacing, 2, 4, 0.4);
  }

  @ParameterizedTest
  @CsvSource({
    "1, sphere, 1, 4.5",
    "2, plane, 1, 1.8",
    "2, sphere, 0.8, 3.5",
    "3, plane, 0.3, 0.6",
    "3, sphere, 0.4, 3",
    "5, plane, 0.3, 0.7",
    "5, sphere, 0.5, 2"
  })
  void aWallOneSliceThickIsASurfaceFromEitherSide(
      double ratio, String shape, double rms, double worst) {
    Vec3 spacing = new Vec3(1, 1, ratio);
    AnalyticSurface outside = truth(shape);
    GreySolids wall = new GreySolids(new WallSurface(outside, ratio), EDGE, spacing);
    for (AnalyticSurface side : List.of(outside, new CavitySurface(outside, ratio))) {
      assertWithin(measure(wall, side, spacing, 0.3), rms, worst, 0.03, 0.02);
    }
  }

  private static void checkSlides(
      String shape, Vec3 spacing, double rms, double worst, double heightStd) {
    GreySolids solids = solids(shape, spacing);
    for (double speed : new double[] {0.3, 2}) {
      assertWithin(measure(solids, shape, spacing, speed), rms, worst, heightStd, 0.02);
    }
  }

  private static GreySolids solids(String shape, Vec3 spacing) {
    return new GreySolids(truth(shape), EDGE, spacing);
  }

  private static AnalyticSurface truth(String shape) {
    return Phantom.parse(shape + ":" + EDGE).analyticSurface().orElseThrow();
  }

  private static Accuracy measure(GreySolids solids, String shape, Vec3 spacing, double speed) {
    return measure(solids, truth(shape), spacing, speed);
  }

  private static Accuracy measure(
      GreySolids solids, AnalyticSurface truth, Vec3 spacing, double speed) {
    GridMetric metric = GridMetric.of(spacing);
    SlideTrajectory slide = new SlideTrajectory(truth, EDGE, 5, speed, FRAMES, SEED);
    return new AccuracyMeter(truth, metric, slide, 5)
        .measure(solver(solids, metric), new CollisionScene(List.of(solids.bits)));
  }

  @Test
  void tenPercentOfNoiseKeepTheForceWithinTwoDegrees() {
    for (String name : List.of("plane", "sphere", "torus")) {
      check(name, 0.1, new double[][] {{5, 2, 8}}, 0.1);
    }
  }

  @Test
  void anEditOverridesTheGreyValues() {
    GreySolids solids = new GreySolids(Phantom.parse("plane:64:grey"), 0, SEED);
    CollisionScene scene = new CollisionScene(List.of(solids.bits));
    SmoothSolver solver = solver(solids);
    InteractionPoint point = new InteractionPoint();
    point.position.set(32, 32, 62);
    Vec3 device = new Vec3(32.2, 31.7, 28);
    follow(solver, scene, device, point);
    double before = point.position.z;
    for (int k = 0; k < 64; k++) {
      for (int n = 0; n < 25; n++) {
        solids.bits.clear(30 + n % 5, 30 + n / 5, k);
      }
    }
    solver.reset();
    follow(solver, scene, device, point);
    assertTrue(point.position.z < before - 1, "before " + before + " now " + point.position);
  }

  private static void follow(
      SmoothSolver solver, CollisionScene scene, Vec3 device, InteractionPoint point) {
    for (int frame = 0; frame < 50; frame++) {
      solver.follow(scene, device, point);
    }
  }

  /** Checks rows of depth, largest rms angle and largest angle, degrees. */
  private static void check(String name, double noise, double[][] rows, double heightStd) {
    Phantom phantom = Phantom.parse(name + ":" + EDGE + ":grey");
    GreySolids solids = new GreySolids(phantom, noise, SEED);
    for (double[] row : rows) {
      for (double speed : new double[] {0.05, 0.3, 2}) {
        SlideTrajectory slide =
            new SlideTrajectory(
                phantom.analyticSurface().orElseThrow(), EDGE, row[0], speed, FRAMES, SEED);
        Accuracy accuracy =
            new AccuracyMeter(phantom.analyticSurface().orElseThrow(), UNIT, slide, row[0])
                .measure(solver(solids), new CollisionScene(List.of(solids.bits)));
        assertWithin(accuracy, row[1], row[2], heightStd, noise == 0 ? 0.02 : 0.05);
      }
    }
  }

  private static void assertWithin(
      Accuracy accuracy, double rms, double worst, double heightStd, double lagOff) {
    assertTrue(accuracy.angleRmsDegrees() <= rms, accuracy::toString);
    assertTrue(accuracy.angleWorstDegrees() <= worst, accuracy::toString);
    assertTrue(accuracy.heightStdMm() <= heightStd, accuracy::toString);
    assertEquals(1, accuracy.lag(), lagOff, accuracy::toString);
    assertEquals(0, accuracy.lostFrames());
  }

  private static SmoothSolver solver(GreySolids solids) {
    return solver(solids, UNIT);
  }

  private static SmoothSolver solver(GreySolids solids, GridMetric metric) {
    double half = Phantom.HALF_GREY;
    return new SmoothSolver(metric, 8, new GreyIsosurface(solids.volume, half, half));
  }
}
