package org.palpate.benchmarks.stability;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.DeviceState;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.geometry.Vec3;

class SettlingDeviceTest {
  private final List<Double> written = new ArrayList<>();
  private int reads;

  /** A hand that moves on by 1 mm with each read. */
  private final HapticDevice moving =
      new HapticDevice() {
        @Override
        public DeviceSpecification specification() {
          return new DeviceSpecification("moving", "", 10, 1, 100, 0, true, 200);
        }

        @Override
        public ReadStatus read(DeviceState state) {
          state.positionMm.set(5 + reads, 0, 0);
          state.timeNanos = 7L + reads++;
          return ReadStatus.FRESH;
        }

        @Override
        public boolean write(Vec3 forceNewton, Vec3 torqueNewtonMm) {
          written.add(forceNewton.x);
          return true;
        }

        @Override
        public void close() {}
      };

  @Test
  void restsForThreeTenthsOfASecondAndFeelsNoForceMeanwhile() {
    SettlingDevice device = new SettlingDevice(moving, new Sampling(5_000, 1));
    DeviceState state = new DeviceState();
    for (int frame = 0; frame < 1_503; frame++) {
      assertEquals(ReadStatus.FRESH, device.read(state));
      double expected = frame < 1_500 ? 5 : 6 + frame - 1_500;
      assertEquals(expected, state.positionMm.x, "frame " + frame);
      assertEquals((long) expected + 2, state.timeNanos, "frame " + frame);
      device.write(new Vec3(frame, 0, 0), new Vec3());
    }
    assertEquals(List.of(1_500.0, 1_501.0, 1_502.0), written);
  }
}
