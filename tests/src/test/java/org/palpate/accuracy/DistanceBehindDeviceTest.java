package org.palpate.accuracy;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.benchmarks.PlainTwin;
import org.palpate.benchmarks.Trajectories;
import org.palpate.benchmarks.Trajectory;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.GuardedSolver;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.Metric;
import org.palpate.proxy.Obstacles;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.Phantom;
import org.palpate.volume.phantom.SurfaceTruth;

/**
 * The guarded solver stays at least as close behind the device as the plain twin does.
 *
 * <p>A torus ten voxels deep is left out: that is half of its tube, the nearest points of all sides
 * are nearly equal there, and which one a solver is caught at is chance. README tells the figures.
 */
class DistanceBehindDeviceTest {
  private static final double MAX_STEP_VOXELS = 8;
  private static final int FRAMES = 4000;

  @ParameterizedTest
  @CsvSource({
    "sphere:192, 2", "sphere:192, 5", "sphere:192, 10",
    "plane:192, 2", "plane:192, 5", "plane:192, 10",
    "torus:192, 2", "torus:192, 5"
  })
  void guardedIsNoFartherThanTheTwin(String spec, double depth) {
    Phantom phantom = Phantom.parse(spec);
    BitCube bits = phantom.segments().segments().get(0).bits();
    SurfaceTruth truth = phantom.truth().orElseThrow();
    for (double speed : new double[] {0.05, 0.3, 2}) {
      Trajectory slide =
          Trajectories.slide(truth, phantom.edge(), depth, speed, FRAMES, Seeds.seed());
      double guarded = meanOfGuarded(bits, slide);
      double twin = meanOfTwin(bits, slide);
      String what = spec + " depth " + depth + " speed " + speed + " seed " + Seeds.seed();
      assertTrue(guarded <= twin, what + ": guarded " + guarded + " twin " + twin);
    }
  }

  private static double meanOfGuarded(BitCube bits, Trajectory slide) {
    GuardedSolver solver = new GuardedSolver(new Metric(1, 1, 1), MAX_STEP_VOXELS);
    Obstacles obstacles = new Obstacles(List.of(bits));
    InteractionPoint point = new InteractionPoint();
    slide.at(0, point.position);
    Vec3 device = new Vec3();
    double sum = 0;
    for (int frame = 0; frame < slide.frames(); frame++) {
      slide.at(frame, device);
      solver.follow(obstacles, device, point);
      sum += point.position.sub(device, device).length();
    }
    return sum / slide.frames();
  }

  private static double meanOfTwin(BitCube bits, Trajectory slide) {
    PlainTwin twin = new PlainTwin(bits, MAX_STEP_VOXELS);
    Vec3 device = slide.at(0, new Vec3());
    twin.place(device.x, device.y, device.z);
    double sum = 0;
    for (int frame = 0; frame < slide.frames(); frame++) {
      slide.at(frame, device);
      twin.frame(device.x, device.y, device.z);
      sum += new Vec3(twin.x(), twin.y(), twin.z()).sub(device, device).length();
    }
    return sum / slide.frames();
  }
}
