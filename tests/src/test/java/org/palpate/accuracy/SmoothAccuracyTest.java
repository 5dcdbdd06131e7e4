package org.palpate.accuracy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.benchmarks.accuracy.Accuracy;
import org.palpate.benchmarks.accuracy.AccuracyMeter;
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
  void onASphereForcesAreWithinADegreeAndAHalf() {
    for (double depth : new double[] {2, 5, 10}) {
      for (double speed : new double[] {0.05, 0.3, 2}) {
        check(measure("sphere", depth, speed), 1.5, 6.5, 0.05, 0.03);
      }
    }
  }

  @Test
  void onATorusForcesAreWithinTwoAndAHalfDegrees() {
    for (double depth : new double[] {2, 5, 10}) {
      for (double speed : new double[] {0.05, 0.3, 2}) {
        boolean deep = depth == 10;
        check(measure("torus", depth, speed), deep ? 3.3 : 2.5, deep ? 13 : 10, 0.11, 0.03);
      }
    }
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
    check(measure(new Cavity(ball, 1), CUBES, bits, 5, 0.3), 1.5, 6, 0.15, 0.3);
  }

  @Test
  void tenPercentOfInvertedBorderVoxelsHardlyChangeTheForce() {
    for (String name : List.of("plane", "sphere", "torus")) {
      AnalyticSurface truth = Phantom.parse(name + ":" + EDGE).analyticSurface().orElseThrow();
      BitCube noisy = SampledSolids.flipped(SampledSolids.of(truth, EDGE, CUBES), 0.1, SEED);
      check(measure(truth, CUBES, noisy, 5, 0.3), 2.2, 8, 0.2, 0.03);
      check(measure(truth, CUBES, noisy, 5, 0.05), 2.2, 8, 0.2, 0.03);
    }
  }

  @Test
  void voxelsTwiceAsTallAtMostDoubleTheAngles() {
    Vec3 tall = new Vec3(1, 1, 2);
    check(measureSampled("plane", tall, 5), 1, 2, 0.1, 0.03);
    check(measureSampled("sphere", tall, 5), 3, 12, 0.1, 0.03);
    check(measureSampled("torus", tall, 5), 5.5, 20, 0.3, 0.03);
  }

  @Test
  void everyLegOfASlideIsDisjointFromAllSolids() {
    AnalyticSurface truth = Phantom.parse("torus:96").analyticSurface().orElseThrow();
    BitCube bits = SampledSolids.flipped(SampledSolids.of(truth, 96, CUBES), 0.1, SEED);
    SlideTrajectory slide = new SlideTrajectory(truth, 96, 4, 0.3, 1500, SEED);
    GridMetric metric = GridMetric.of(CUBES);
    AccuracyMeter meter = new AccuracyMeter(truth, metric, slide, 4);
    JudgedSolver solver = new JudgedSolver(new SmoothSolver(metric, 8), bits);
    assertEquals(0, meter.measure(solver, new CollisionScene(List.of(bits))).lostFrames());
  }

  private static Accuracy measure(String name, double depth, double speed) {
    Phantom phantom = Phantom.parse(name + ":" + EDGE);
    BitCube bits = phantom.segments().segments().get(0).bits();
    return measure(phantom.analyticSurface().orElseThrow(), CUBES, bits, depth, speed);
  }

  private static Accuracy measureSampled(String name, Vec3 spacingMm, double depth) {
    AnalyticSurface truth = Phantom.parse(name + ":" + EDGE).analyticSurface().orElseThrow();
    return measure(truth, spacingMm, SampledSolids.of(truth, EDGE, spacingMm), depth, 0.3);
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

  /** The inside of a ball with a wall of some thickness, touched from the cavity. */
  private record Cavity(AnalyticSurface ball, double wallMm) implements AnalyticSurface {
    @Override
    public double signedDistance(Vec3 point) {
      return -ball.signedDistance(point) - wallMm;
    }

    @Override
    public Vec3 normal(Vec3 point, Vec3 dest) {
      return ball.normal(point, dest).mul(-1, dest);
    }
  }
}
