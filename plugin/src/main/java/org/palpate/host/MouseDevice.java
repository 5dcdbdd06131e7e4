package org.palpate.host;

import org.palpate.device.DeviceSpecification;
import org.palpate.device.DeviceState;
import org.palpate.device.HandTarget;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.device.SimulatedDevice;
import org.palpate.geometry.Vec3;

/**
 * A mouse as a haptic device without force. The position approaches the pointer smoothly, no faster
 * than a hand. Any thread moves the pointer; the haptic thread reads the device.
 */
public final class MouseDevice implements HapticDevice {
  /** Part of the remaining distance to the pointer that one sample covers. */
  private static final double APPROACH_FRACTION_PER_SAMPLE = 0.02;

  private final DeviceSpecification specification;
  private final long intervalNanos;
  private final Vec3 position = new Vec3();
  private volatile Vec3 target;
  private volatile boolean closed;
  private long reads;

  /**
   * Creates a device that rests beside the region until the pointer moves.
   *
   * @param region the region to touch, world mm
   * @param intervalNanos time between two samples, positive
   */
  public MouseDevice(HandTarget region, long intervalNanos) {
    this.intervalNanos = intervalNanos;
    target = beside(region);
    position.set(target);
    specification =
        new DeviceSpecification(
            "mouse",
            "",
            SimulatedDevice.MAX_FORCE_NEWTON,
            SimulatedDevice.MAX_STIFFNESS_NEWTON_PER_MM,
            radiusMm(region),
            0);
  }

  private static double radiusMm(HandTarget region) {
    return region.highMm().sub(region.lowMm(), new Vec3()).length() / 2;
  }

  private static Vec3 beside(HandTarget region) {
    Vec3 middle = region.lowMm().add(region.highMm(), new Vec3());
    middle.mul(0.5, middle);
    middle.x = region.highMm().x + 0.1 * radiusMm(region);
    return middle;
  }

  /** Sets the position that the device approaches, world mm. Any thread. */
  public void moveTo(Vec3 worldMm) {
    target = new Vec3().set(worldMm);
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
    Vec3 end = target;
    position.set(
        position.x + (end.x - position.x) * APPROACH_FRACTION_PER_SAMPLE,
        position.y + (end.y - position.y) * APPROACH_FRACTION_PER_SAMPLE,
        position.z + (end.z - position.z) * APPROACH_FRACTION_PER_SAMPLE);
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
