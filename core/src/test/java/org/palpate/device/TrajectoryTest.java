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
        trajectory.add(n, n, -n, Double.NaN, turned ? 0 : 1, turned ? -0.0 : 0, turned ? n : 0, 0);
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
    assertEquals(turned ? -0.0 : 0.0, state.orientation.x);
    assertEquals(turned ? n : 0.0, state.orientation.y);
    assertEquals(0.0, state.orientation.z);
    assertEquals(turned ? 0.0 : 1.0, state.orientation.w);
    assertEquals(n, trajectory.timeMs(n));
    assertEquals(n * 1_000_000L, state.timeNanos);
  }

  @Test
  void anArrayOfPositionsHasEvenTimesAndNoOrientation() {
    Trajectory trajectory = Trajectory.ofPositions(new double[] {1, 2, 3, 4, 5, 6}, 0.5);
    state.orientation.x = 1;
    state.orientation.w = 0;
    trajectory.read(1, state);
    assertEquals(2, trajectory.size());
    assertTrue(state.positionMm.sameBits(new Vec3(4, 5, 6)));
    assertEquals(500_000, state.timeNanos);
    assertEquals(0, state.orientation.x);
    assertEquals(1, state.orientation.w);
  }

  @Test
  void samplesCanBeAddedToAnArrayOfPositions() {
    Trajectory trajectory = Trajectory.ofPositions(new double[3], 1);
    trajectory.add(1, 7, 8, 9, 0, 0, 1, 0);
    trajectory.read(0, state);
    assertEquals(1, state.orientation.w);
    trajectory.read(1, state);
    assertEquals(1, state.orientation.y);
    assertEquals(9, state.positionMm.z);
  }
}
