package org.palpate.host;

import org.palpate.device.DeviceSpecification;
import org.palpate.device.DeviceState;
import org.palpate.device.HandTarget;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.device.SimulatedDevice;
import org.palpate.geometry.Vec3;

/**
 * A mouse as a device: it follows where the pointer wants to be, no faster than a hand, and feels
 * nothing. Any thread moves it, the haptic thread reads it.
 */
public final class MouseDevice implements HapticDevice {
  /** How far the hand comes in a sample, as a share of what is left to the pointer. */
  private static final double APPROACH_FRACTION_PER_SAMPLE = 0.02;

  private final DeviceSpecification specification;
  private final long intervalNanos;
  private final Vec3 position = new Vec3();
  private volatile Vec3 wanted;
  private volatile boolean closed;
  private long reads;

  /**
   * A hand that rests beside what can be touched until the pointer moves it.
   *
   * @param intervalNanos time between samples, positive
   */
  public MouseDevice(HandTarget target, long intervalNanos) {
    this.intervalNanos = intervalNanos;
    wanted = beside(target);
    position.set(wanted);
    specification =
        new DeviceSpecification(
            "mouse",
            "",
            SimulatedDevice.MAX_FORCE_NEWTON,
            SimulatedDevice.MAX_STIFFNESS_NEWTON_PER_MM,
            radiusMm(target),
            0);
  }

  private static double radiusMm(HandTarget target) {
    return target.highMm().sub(target.lowMm(), new Vec3()).length() / 2;
  }

  private static Vec3 beside(HandTarget target) {
    Vec3 middle = target.lowMm().add(target.highMm(), new Vec3());
    middle.mul(0.5, middle);
    middle.x = target.highMm().x + 0.1 * radiusMm(target);
    return middle;
  }

  /** Says where the hand is to go, world mm. Any thread. */
  public void moveTo(Vec3 worldMm) {
    wanted = new Vec3().set(worldMm);
  }

  @Override
  public DeviceSpecification specification() {
    return specification;
  }

  @Override
  public ReadStatus read(DeviceState state) {
    if (closed) {
      return ReadStatus.DISCONNECTED;
    }
    Vec3 to = wanted;
    position.set(
        position.x + (to.x - position.x) * APPROACH_FRACTION_PER_SAMPLE,
        position.y + (to.y - position.y) * APPROACH_FRACTION_PER_SAMPLE,
        position.z + (to.z - position.z) * APPROACH_FRACTION_PER_SAMPLE);
    state.positionMm.set(position);
    state.timeNanos = reads++ * intervalNanos;
    return ReadStatus.FRESH;
  }

  @Override
  public boolean write(Vec3 forceNewton) {
    return !closed;
  }

  @Override
  public void close() {
    closed = true;
  }
}
