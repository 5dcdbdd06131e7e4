package org.palpate.benchmarks.stability;

import org.palpate.device.DeviceDecorator;
import org.palpate.device.DeviceState;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.geometry.Vec3;

/**
 * A hand that rests where it is before it moves, until effects have faded in and the force of a
 * session is on. Forces that are written meanwhile do not reach it.
 */
final class SettlingDevice extends DeviceDecorator {
  private static final double REST_SECONDS = 0.3;

  private final DeviceState start = new DeviceState();
  private final long restFrames;
  private long reads;

  SettlingDevice(HapticDevice plant, Sampling sampling) {
    super(plant);
    restFrames = Math.round(REST_SECONDS * sampling.rateHz());
  }

  @Override
  public ReadStatus read(DeviceState state) {
    if (reads == 0) {
      device.read(start);
    }
    if (reads++ >= restFrames) {
      return device.read(state);
    }
    state.set(start);
    return ReadStatus.FRESH;
  }

  @Override
  public boolean write(Vec3 forceNewton, Vec3 torqueNewtonMm) {
    return reads <= restFrames || device.write(forceNewton, torqueNewtonMm);
  }
}
