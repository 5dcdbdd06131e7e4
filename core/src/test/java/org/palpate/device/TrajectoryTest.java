package org.palpate.device;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;

class TrajectoryTest {
  private static final int SAMPLES = 5000;

  private final DeviceState state = new DeviceState();

  @Test
  void keepsEverySampleBitForBitFromAnyFirstOrientationOn() {
    for (int first : new int[] {0, 1, 1023, 1024, SAMPLES}) {
      Trajectory trajectory = new Trajectory();
      for (int n = 0; n < SAMPLES; n++) {
        boolean turned = n >= first;
        trajectory.add(n, n, -n, Double.NaN, turned ? -0.0 : 0, turned ? n : 0, 0, turned ? 0 : 1);
      }
      assertEquals(SAMPLES, trajectory.size());
      for (int n = 0; n < SAMPLES; n++) {
        assertSample(trajectory, n, n >= first);
      }
    }
  }

  private void assertSample(Trajectory trajectory, int n, boolean turned) {
    trajectory.read(n, state);
    assertTrue(state.positionMm.sameBits(new Vec3(n, -n, Double.NaN)));
    assertTrue(trajectory.position(n, new Vec3()).sameBits(state.positionMm));
    assertEquals(turned ? -0.0 : 0.0, state.qx);
    assertEquals(turned ? n : 0.0, state.qy);
    assertEquals(0.0, state.qz);
    assertEquals(turned ? 0.0 : 1.0, state.qw);
    assertEquals(n, trajectory.timeMs(n));
    assertEquals(n * 1_000_000L, state.timeNanos);
  }

  @Test
  void anArrayOfPositionsHasEvenTimesAndNoOrientation() {
    Trajectory trajectory = Trajectory.ofPositions(new double[] {1, 2, 3, 4, 5, 6}, 0.5);
    state.qx = 1;
    state.qw = 0;
    trajectory.read(1, state);
    assertEquals(2, trajectory.size());
    assertTrue(state.positionMm.sameBits(new Vec3(4, 5, 6)));
    assertEquals(500_000, state.timeNanos);
    assertEquals(0, state.qx);
    assertEquals(1, state.qw);
  }

  @Test
  void samplesCanBeAddedToAnArrayOfPositions() {
    Trajectory trajectory = Trajectory.ofPositions(new double[3], 1);
    trajectory.add(1, 7, 8, 9, 0, 1, 0, 0);
    trajectory.read(0, state);
    assertEquals(1, state.qw);
    trajectory.read(1, state);
    assertEquals(1, state.qy);
    assertEquals(9, state.positionMm.z);
  }
}
