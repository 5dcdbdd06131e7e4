package org.palpate.accuracy;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.benchmarks.baseline.PlainBaseline;
import org.palpate.benchmarks.input.Trajectories;
import org.palpate.collision.CollisionScene;
import org.palpate.device.Trajectory;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.AnalyticSurface;
import org.palpate.volume.phantom.Phantom;

/** The guarded solver stays at least as close to the device as the plain baseline does. */
class DistanceBehindDeviceTest {
  private static final double MAX_STEP_VOXELS = 8;
  private static final int FRAMES = 4000;
  private static final double[] SPEEDS = {0.05, 0.3, 2};

  @ParameterizedTest
  @CsvSource({
    "sphere:192, 2", "sphere:192, 5", "sphere:192, 10",
    "plane:192, 2", "plane:192, 5", "plane:192, 10",
    "torus:192, 2", "torus:192, 5"
  })
  void guardedIsNoFartherThanTheBaseline(String spec, double depth) {
    for (double speed : SPEEDS) {
      assertNoFarther(spec, depth, 1, speed);
    }
  }

  /**
   * Compares the means of many slides at all speeds. Half a tube deep, the nearest points of all
   * sides are almost equally far, and chance decides at which one a solver rests in a single slide.
   */
  @Test
  void guardedIsNoFartherThanTheBaselineHalfATubeDeep() {
    assertNoFarther("torus:192", 10, 40, SPEEDS);
  }

  private static void assertNoFarther(String spec, double depth, int slides, double... speeds) {
    Phantom phantom = Phantom.parse(spec);
    BitCube bits = phantom.segments().segments().get(0).bits();
    AnalyticSurface truth = phantom.analyticSurface().orElseThrow();
    double guarded = 0;
    double baseline = 0;
    for (double speed : speeds) {
      for (int n = 0; n < slides; n++) {
        Trajectory slide =
            Trajectories.slide(truth, phantom.edge(), depth, speed, FRAMES, Seeds.seed() + n);
        guarded += meanOfGuarded(bits, slide) / (slides * speeds.length);
        baseline += meanOfBaseline(bits, slide) / (slides * speeds.length);
      }
    }
    String what = spec + " depth " + depth + " speeds " + Arrays.toString(speeds);
    assertTrue(
        guarded <= baseline,
        what + " seed " + Seeds.seed() + ": guarded " + guarded + " baseline " + baseline);
  }

  private static double meanOfGuarded(BitCube bits, Trajectory slide) {
    GuardedSolver solver = new GuardedSolver(new GridMetric(1, 1, 1), MAX_STEP_VOXELS);
    CollisionScene scene = new CollisionScene(List.of(bits));
    InteractionPoint point = new InteractionPoint();
    slide.position(0, point.position);
    Vec3 device = new Vec3();
    double sum = 0;
    for (int frame = 0; frame < slide.size(); frame++) {
      slide.position(frame, device);
      solver.follow(scene, device, point);
      sum += point.position.sub(device, device).length();
    }
    return sum / slide.size();
  }

  private static double meanOfBaseline(BitCube bits, Trajectory slide) {
    PlainBaseline baseline = new PlainBaseline(bits, MAX_STEP_VOXELS);
    Vec3 device = slide.position(0, new Vec3());
    baseline.place(device.x, device.y, device.z);
    double sum = 0;
    for (int frame = 0; frame < slide.size(); frame++) {
      slide.position(frame, device);
      baseline.frame(device.x, device.y, device.z);
      sum += new Vec3(baseline.x(), baseline.y(), baseline.z()).sub(device, device).length();
    }
    return sum / slide.size();
  }
}
