package org.palpate.benchmarks.elastic;

import org.palpate.device.DeviceSpecification;
import org.palpate.device.DeviceState;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.geometry.Vec3;

/** A device whose position a study sets, with a new sample each millisecond. One thread. */
final class MovedHand implements HapticDevice {
  private static final long FRAME_NANOS = 1_000_000;

  final Vec3 position = new Vec3();
  private long reads;

  @Override
  public DeviceSpecification specification() {
    return new DeviceSpecification("moved", "", 10, 1, 100, 0, false, 200);
  }

  @Override
  public ReadStatus read(DeviceState state) {
    state.positionMm.set(position);
    state.timeNanos = FRAME_NANOS * reads++;
    return ReadStatus.FRESH;
  }

  @Override
  public boolean write(Vec3 forceNewton, Vec3 torqueNewtonMm) {
    return true;
  }

  @Override
  public void close() {}
}
