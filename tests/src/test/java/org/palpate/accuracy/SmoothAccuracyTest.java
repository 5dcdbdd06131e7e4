package org.palpate.accuracy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.benchmarks.accuracy.Accuracy;
import org.palpate.benchmarks.accuracy.AccuracyMeter;
import org.palpate.benchmarks.accuracy.SampledSolids;
import org.palpate.benchmarks.accuracy.SlideTrajectory;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.AnalyticSurface;
import org.palpate.volume.phantom.Phantom;

/** Bounds the errors of the smooth solver's force, which do not depend on the machine. */
class SmoothAccuracyTest {
  private static final int EDGE = 192;
  private static final int LARGE_EDGE = 256;
  private static final int FRAMES = 4000;
  private static final long SEED = 7;
  private static final Vec3 CUBES = new Vec3(1, 1, 1);

  @Test
  void onAPlaneForcesAreWithinHalfADegree() {
    for (double depth : new double[] {2, 5, 10}) {
      for (double speed : new double[] {0.05, 0.3, 2}) {
        Accuracy accuracy = measure("plane", depth, speed);
        check(accuracy, 0.5, 1, 0.05, 0.03);
      }
    }
  }

  @Test
  void onASphereForcesAreWithinADegree() {
    for (double depth : new double[] {2, 5, 10}) {
      for (double speed : new double[] {0.05, 0.3, 2}) {
        check(measure("sphere", depth, speed), 0.9, 3.5, 0.04, 0.02);
      }
    }
  }

  @Test
  void onATorusForcesAreWithinADegreeAndAQuarter() {
    for (double depth : new double[] {2, 5, 10}) {
      for (double speed : new double[] {0.05, 0.3, 2}) {
        boolean deep = depth == 10;
        check(measure("torus", depth, speed), deep ? 1.25 : 1, deep ? 7 : 5.2, 0.06, 0.02);
      }
    }
  }

  @ParameterizedTest
  @CsvSource({"plane, 0.35, 0.8, 0.02", "sphere, 0.9, 3.7, 0.04", "torus, 0.8, 4.5, 0.05"})
  void widerTerracesOfALargeSurfaceAreFeltNoMore(
      String shape, double rms, double worst, double heightStd) {
    Phantom large = Phantom.parse(shape + ":" + LARGE_EDGE);
    BitCube bits = large.segments().segments().get(0).bits();
    AnalyticSurface truth = large.analyticSurface().orElseThrow();
    SlideTrajectory slide = new SlideTrajectory(truth, LARGE_EDGE, 5, 0.3, FRAMES, SEED);
    Accuracy accuracy =
        new AccuracyMeter(truth, GridMetric.of(CUBES), slide, 5)
            .measure(new SmoothSolver(GridMetric.of(CUBES), 8), new CollisionScene(List.of(bits)));
    check(accuracy, rms, worst, heightStd, 0.02);
  }

  @Test
  void theForceChangesAboutAsMuchAsTheSurfaceRequires() {
    assertTrue(measure("sphere", 5, 0.3).forceChange() < 1.25);
    assertTrue(measure("torus", 5, 0.3).forceChange() < 1.15);
  }

  @Test
  void aShellOfOneVoxelFeelsLikeASolidFromEitherSide() {
    Phantom shell = Phantom.parse("shell:" + EDGE);
    BitCube bits = shell.segments().segments().get(0).bits();
    AnalyticSurface ball = Phantom.parse("sphere:" + EDGE).analyticSurface().orElseThrow();
    check(measure(ball, CUBES, bits, 5, 0.3), 1.5, 6, 0.15, 0.05);
    check(measure(new CavitySurface(ball, 1), CUBES, bits, 5, 0.3), 1.5, 6, 0.15, 0.3);
  }

  @Test
  void tenPercentOfInvertedBorderVoxelsHardlyChangeTheForce() {
    for (String name : List.of("plane", "sphere", "torus")) {
      AnalyticSurface truth = Phantom.parse(name + ":" + EDGE).analyticSurface().orElseThrow();
      BitCube noisy = BorderNoise.flipped(SampledSolids.of(truth, EDGE, CUBES), 0.1, SEED);
      check(measure(truth, CUBES, noisy, 5, 0.3), 2.2, 8, 0.2, 0.03);
      check(measure(truth, CUBES, noisy, 5, 0.05), 2.2, 8, 0.2, 0.03);
    }
  }

  @ParameterizedTest
  @CsvSource({
    "1.2, plane, 0.4, 1, 0.02, 0.02",
    "1.2, sphere, 0.8, 3.7, 0.04, 0.02",
    "1.2, torus, 0.9, 4.6, 0.06, 0.02",
    "1.4, plane, 0.3, 0.8, 0.02, 0.02",
    "1.4, sphere, 0.8, 3.6, 0.04, 0.02",
    "1.4, torus, 0.9, 4.6, 0.06, 0.02",
    "2, plane, 0.3, 0.7, 0.02, 0.02",
    "2, sphere, 1, 4.8, 0.06, 0.02",
    "2, torus, 1.2, 5, 0.07, 0.02",
    "3, plane, 0.4, 0.9, 0.02, 0.02",
    "3, sphere, 1.2, 5.2, 0.07, 0.02",
    "3, torus, 2, 8.2, 0.13, 0.02",
    "5, plane, 0.7, 1.3, 0.03, 0.02",
    "5, sphere, 1.5, 6.5, 0.09, 0.02",
    "5, torus, 3.5, 12.5, 0.25, 0.03",
    "9, plane, 1.2, 3.5, 0.06, 0.06",
    "10, plane, 1.1, 6, 0.05, 0.07"
  })
  void slicesFartherApartThanPixelsHardlyTiltTheForce(
      double ratio, String shape, double rms, double worst, double heightStd, double lagOff) {
    Vec3 tall = new Vec3(1, 1, ratio);
    for (double speed : new double[] {0.05, 0.3, 2}) {
      check(measureSampled(shape, tall, 5, speed), rms, worst, heightStd, lagOff);
    }
  }

  @Test
  void slicesFartherApartThanPixelsHardlyTiltTheForceAtOtherDepths() {
    for (double depth : new double[] {2, 10}) {
      for (double ratio : new double[] {2, 3}) {
        Vec3 tall = new Vec3(1, 1, ratio);
        check(measureSampled("plane", tall, depth, 0.3), 0.4, 0.9, 0.02, 0.02);
        check(measureSampled("sphere", tall, depth, 0.3), 1.3, 6, 0.06, 0.02);
        check(measureSampled("torus", tall, depth, 0.3), 2.5, 7, 0.13, 0.03);
      }
      Vec3 fiveTimes = new Vec3(1, 1, 5);
      check(measureSampled("plane", fiveTimes, depth, 0.3), 0.7, 1.3, 0.03, 0.02);
      check(measureSampled("sphere", fiveTimes, depth, 0.3), 1.7, 7.5, 0.1, 0.04);
    }
  }

  @Test
  void anyAxisMayBeTheLongOneAndRatiosNeedNotBeWhole() {
    for (Vec3 spacing : List.of(new Vec3(3, 1, 1), new Vec3(1, 2.5, 1), new Vec3(1, 1, 1.6))) {
      check(measureSampled("plane", spacing, 5, 0.3), 1, 2, 0.03, 0.02);
      check(measureSampled("sphere", spacing, 5, 0.3), 1.3, 5.5, 0.06, 0.02);
      check(measureSampled("torus", spacing, 5, 0.3), 1.9, 6, 0.11, 0.02);
    }
  }

  @ParameterizedTest
  @CsvSource({
    "1, 2, 2", "2, 1, 2", "2, 2, 1", "1, 2, 3", "2, 1, 3", "2, 3, 1", "1, 3, 2", "3, 1, 2",
    "3, 2, 1"
  })
  void voxelsThatAreLongAlongTwoAxesHardlyTiltTheForce(double x, double y, double z) {
    Vec3 spacing = new Vec3(x, y, z);
    check(measureSampled("plane", spacing, 5, 0.3), 2.4, 4.5, 0.07, 0.03);
    check(measureSampled("sphere", spacing, 5, 0.3), 2.4, 10, 0.15, 0.03);
    check(measureSampled("torus", spacing, 5, 0.3), 4, 13, 0.24, 0.04);
  }

  @ParameterizedTest
  @CsvSource({"1, 3, 3", "3, 1, 3", "3, 3, 1"})
  void voxelsThreeTimesAsLongAlongTwoAxesTiltTheForceByAFewDegrees(double x, double y, double z) {
    Vec3 spacing = new Vec3(x, y, z);
    check(measureSampled("plane", spacing, 5, 0.3), 1.7, 3.5, 0.07, 0.02);
    check(measureSampled("sphere", spacing, 5, 0.3), 2.8, 11, 0.17, 0.03);
    check(measureSampled("torus", spacing, 5, 0.3), 4.6, 17, 0.26, 0.03);
  }

  @ParameterizedTest
  @CsvSource({
    "1, 1, 10, sphere, 2.8, 9, 0.45, 0.06",
    "1, 1, 10, torus, 7, 13, 0.75, 0.09",
    "1, 5, 5, plane, 3.2, 6.8, 0.12, 0.04",
    "1, 5, 5, sphere, 4.2, 18, 0.27, 0.06",
    "1, 5, 5, torus, 7, 18, 0.38, 0.06"
  })
  void veryLongVoxelsTiltTheForceByAFewDegrees(
      double x,
      double y,
      double z,
      String shape,
      double rms,
      double worst,
      double heightStd,
      double lagOff) {
    check(measureSampled(shape, new Vec3(x, y, z), 5, 0.3), rms, worst, heightStd, lagOff);
  }

  @ParameterizedTest
  @CsvSource({"1.2, 0.4, 1", "2, 0.4, 0.9", "3, 0.8, 1.7", "5, 3.1, 5.7"})
  void aPlaneThatIsNearlyParallelToTheSlicesHardlyTiltsTheForce(
      double ratio, double rms, double worst) {
    AnalyticSurface truth = new TiltedPlane(5);
    Vec3 tall = new Vec3(1, 1, ratio);
    BitCube bits = SampledSolids.of(truth, EDGE, tall);
    check(measure(truth, tall, bits, 5, 0.3), rms, worst, 0.1 * ratio, 0.02);
  }

  @ParameterizedTest
  @CsvSource({
    "1.2, plane, 0.8, 1.8, 0.03, 0.01",
    "1.2, sphere, 0.8, 3.7, 0.04, 0.01",
    "1.5, plane, 0.3, 0.7, 0.02, 0.01",
    "1.5, sphere, 0.9, 4, 0.05, 0.01",
    "2, plane, 0.3, 0.7, 0.02, 0.01",
    "2, sphere, 1, 5, 0.06, 0.01",
    "2.5, plane, 0.4, 0.9, 0.02, 0.01",
    "2.5, sphere, 1.2, 5, 0.08, 0.01",
    "3, plane, 0.4, 0.9, 0.02, 0.01",
    "3, sphere, 1.3, 5.2, 0.09, 0.01",
    "5, plane, 0.7, 1.4, 0.03, 0.01",
    "5, sphere, 1.9, 6.5, 0.15, 0.03"
  })
  void aWallOneSliceThickIsASurfaceFromEitherSide(
      double ratio, String shape, double rms, double worst, double heightStd, double lagOff) {
    AnalyticSurface solid = Phantom.parse(shape + ":" + EDGE).analyticSurface().orElseThrow();
    Vec3 tall = new Vec3(1, 1, ratio);
    BitCube bits = SampledSolids.of(new WallSurface(solid, ratio), EDGE, tall);
    check(measure(solid, tall, bits, 5, 0.3), rms, worst, heightStd, lagOff);
    check(
        measure(new CavitySurface(solid, ratio), tall, bits, 5, 0.3),
        rms,
        worst,
        heightStd,
        lagOff);
  }

  @Test
  void everyLegOverLongVoxelsIsDisjointFromAllSolids() {
    AnalyticSurface truth = Phantom.parse("torus:96").analyticSurface().orElseThrow();
    for (Vec3 spacing :
        List.of(
            new Vec3(1, 1, 1.2),
            new Vec3(1, 1, 2),
            new Vec3(3, 1, 1),
            new Vec3(1, 5, 1),
            new Vec3(1, 3, 3),
            new Vec3(2, 3, 1))) {
      BitCube exact = SampledSolids.of(truth, 96, spacing);
      assertNoLegTouches(truth, BorderNoise.flipped(exact, 0.1, SEED), spacing);
    }
  }

  @Test
  void everyLegOfASlideIsDisjointFromAllSolids() {
    AnalyticSurface truth = Phantom.parse("torus:96").analyticSurface().orElseThrow();
    BitCube bits = BorderNoise.flipped(SampledSolids.of(truth, 96, CUBES), 0.1, SEED);
    assertNoLegTouches(truth, bits, CUBES);
  }

  private static void assertNoLegTouches(AnalyticSurface truth, BitCube bits, Vec3 spacingMm) {
    SlideTrajectory slide = new SlideTrajectory(truth, 96, 4, 0.3, 1500, SEED);
    GridMetric metric = GridMetric.of(spacingMm);
    AccuracyMeter meter = new AccuracyMeter(truth, metric, slide, 4);
    JudgedSolver solver = new JudgedSolver(new SmoothSolver(metric, 8), bits);
    assertEquals(0, meter.measure(solver, new CollisionScene(List.of(bits))).lostFrames());
  }

  private static Accuracy measure(String name, double depth, double speed) {
    Phantom phantom = Phantom.parse(name + ":" + EDGE);
    BitCube bits = phantom.segments().segments().get(0).bits();
    return measure(phantom.analyticSurface().orElseThrow(), CUBES, bits, depth, speed);
  }

  private static Accuracy measureSampled(String name, Vec3 spacingMm, double depth, double speed) {
    AnalyticSurface truth = Phantom.parse(name + ":" + EDGE).analyticSurface().orElseThrow();
    return measure(truth, spacingMm, SampledSolids.of(truth, EDGE, spacingMm), depth, speed);
  }

  private static Accuracy measure(
      AnalyticSurface truth, Vec3 spacingMm, BitCube bits, double depth, double speed) {
    SlideTrajectory slide = new SlideTrajectory(truth, EDGE, depth, speed, FRAMES, SEED);
    GridMetric metric = GridMetric.of(spacingMm);
    return new AccuracyMeter(truth, metric, slide, depth)
        .measure(new SmoothSolver(metric, 8), new CollisionScene(List.of(bits)));
  }

  private static void check(
      Accuracy accuracy, double rms, double worst, double heightStd, double lagOff) {
    assertTrue(accuracy.angleRmsDegrees() <= rms, accuracy::toString);
    assertTrue(accuracy.angleWorstDegrees() <= worst, accuracy::toString);
    assertTrue(accuracy.heightStdMm() <= heightStd, accuracy::toString);
    assertTrue(Math.abs(accuracy.lag() - 1) <= lagOff, accuracy::toString);
    assertEquals(0, accuracy.lostFrames(), accuracy::toString);
  }

  /** A plane through the middle, by an angle off the slices. */
  private record TiltedPlane(double degrees) implements AnalyticSurface {
    @Override
    public double signedDistance(Vec3 point) {
      double middle = EDGE / 2.0 + 0.23;
      Vec3 from = new Vec3(point.x - middle, point.y - middle, point.z - middle);
      return from.dot(normal(point, new Vec3()));
    }

    @Override
    public Vec3 normal(Vec3 point, Vec3 dest) {
      double tilt = StrictMath.toRadians(degrees);
      double across = StrictMath.sin(tilt);
      return dest.set(0.8 * across, 0.6 * across, StrictMath.cos(tilt));
    }
  }
}
