package org.palpate.benchmarks.baseline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.benchmarks.input.Trajectories;
import org.palpate.device.Trajectory;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.AnalyticSurface;
import org.palpate.volume.phantom.Phantom;

class PlainBaselineTest {
  private static final long SEED = 3;

  @Test
  void movesStraightWithoutObstacles() {
    PlainBaseline baseline = new PlainBaseline(new BitCube(9, 9, 9), 100);
    baseline.place(1.5, 1.5, 1.5);
    baseline.frame(7.25, 6.5, 5.5);
    assertEquals(7.25, baseline.x());
    assertFalse(baseline.contact());
  }

  @ParameterizedTest
  @ValueSource(strings = {"sphere:64", "plane:64", "torus:96"})
  void comesToRestOnSlopes(String spec) {
    Phantom phantom = Phantom.parse(spec);
    PlainBaseline baseline = new PlainBaseline(phantom.segments().segments().get(0).bits(), 8);
    AnalyticSurface truth = phantom.analyticSurface().orElseThrow();
    Trajectory slide = Trajectories.slide(truth, phantom.edge(), 4, 0.7, 900, SEED);
    Vec3 device = slide.position(0, new Vec3());
    baseline.place(device.x, device.y, device.z);
    for (int frame = 0; frame < slide.size(); frame++) {
      slide.position(frame, device);
      baseline.frame(device.x, device.y, device.z);
      if (frame % 90 == 89) {
        assertComesToRest(baseline, device);
      }
    }
  }

  private static void assertComesToRest(PlainBaseline baseline, Vec3 device) {
    for (int n = 0; n < 50; n++) {
      baseline.frame(device.x, device.y, device.z);
    }
    Vec3 rest = new Vec3(baseline.x(), baseline.y(), baseline.z());
    baseline.frame(device.x, device.y, device.z);
    assertTrue(rest.sameBits(new Vec3(baseline.x(), baseline.y(), baseline.z())), "" + device);
    assertTrue(baseline.contact());
  }

  @Test
  void slidesKeepTheirDepthAndSpeed() {
    Phantom torus = Phantom.parse("torus:192");
    AnalyticSurface truth = torus.analyticSurface().orElseThrow();
    Trajectory slide = Trajectories.slide(truth, 192, 5, 0.3, 3000, SEED);
    Vec3 last = slide.position(100, new Vec3());
    for (int frame = 101; frame < slide.size(); frame++) {
      Vec3 device = slide.position(frame, new Vec3());
      assertEquals(-5, truth.signedDistance(device), 1e-6);
      assertEquals(0.3, device.sub(last, last).length(), 0.01);
      last = device;
    }
  }

  @Test
  void theSameSeedGivesTheSameTrajectory() {
    Trajectory one = Trajectories.jumps(50, 60, 70, 500, SEED);
    assertTrue(haveSamePositions(one, Trajectories.jumps(50, 60, 70, 500, SEED)));
    assertFalse(haveSamePositions(one, Trajectories.jumps(50, 60, 70, 500, SEED + 1)));
  }

  private static boolean haveSamePositions(Trajectory one, Trajectory other) {
    boolean same = one.size() == other.size();
    for (int sample = 0; same && sample < one.size(); sample++) {
      same = one.position(sample, new Vec3()).sameBits(other.position(sample, new Vec3()));
    }
    return same;
  }
}
