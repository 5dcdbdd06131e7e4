package org.palpate.benchmarks.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.palpate.collision.CollisionDevice;
import org.palpate.collision.DeviceVoxels;
import org.palpate.volume.BitCube;

class DeviceFrameTimesTest {
  private static final int FRAMES = 20;

  @Test
  void countsTheLaunchesOfTimedFramesAlone() {
    CountedCpu device = new CountedCpu(Optional.empty());
    DeviceFrameTimes times = DeviceFrameTimes.of(0, device, FRAMES);
    assertEquals("sphere, 1000 points, points", times.condition());
    assertEquals(1_016, times.points());
    assertEquals(1.0 / FRAMES, times.launches());
    assertTrue(times.cpuP50() > 0 && times.cpuP50() <= times.cpuP999(), times.toString());
    assertTrue(times.deviceP50() > 0 && times.deviceP50() <= times.deviceP999(), times.toString());
  }

  @Test
  void aDeviceThatFailedHasNoTimes() {
    CountedCpu device = new CountedCpu(Optional.of("it did not answer in time"));
    IllegalStateException failure =
        assertThrows(IllegalStateException.class, () -> DeviceFrameTimes.of(0, device, FRAMES));
    assertEquals("counted failed: it did not answer in time", failure.getMessage());
  }

  /** The CPU under another name. Each time that it is asked, it has made one launch more. */
  private static final class CountedCpu implements CollisionDevice {
    private final Optional<String> failure;
    private long launches;

    CountedCpu(Optional<String> failure) {
      this.failure = failure;
    }

    @Override
    public DeviceVoxels keep(BitCube voxels) {
      return CPU.keep(voxels);
    }

    @Override
    public long batches() {
      return launches++;
    }

    @Override
    public String name() {
      return "counted";
    }

    @Override
    public Optional<String> failure() {
      return failure;
    }

    @Override
    public void close() {}
  }
}
