package org.palpate.host;

import org.palpate.device.DeviceSpecification;
import org.palpate.device.DeviceState;
import org.palpate.device.HandTarget;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.device.SimulatedDevice;
import org.palpate.geometry.Vec3;

/**
 * A mouse as a haptic device without force. With each sample the position covers a fiftieth of the
 * way to the pointer, so it moves smoothly. A new press makes it jump. Any thread moves the
 * pointer; the haptic thread reads the device.
 */
public final class MouseDevice implements HapticDevice {
  /** Part of the remaining distance to the pointer that one sample covers. */
  private static final double APPROACH_FRACTION_PER_SAMPLE = 0.02;

  private final DeviceSpecification specification;
  private final long intervalNanos;
  private final Vec3 position = new Vec3();
  private volatile Motion motion;
  private volatile boolean closed;
  private long reads;

  /** The number of jumps that the haptic thread has made. */
  private long jumpsMade;

  /**
   * The motion that the user asks for.
   *
   * @param jumps number of jumps so far
   * @param from the position of the last jump
   * @param target the position to approach
   */
  private record Motion(long jumps, Vec3 from, Vec3 target) {}

  /**
   * Creates a device that rests beside the region until the pointer moves.
   *
   * @param region the region to touch, world mm
   * @param intervalNanos time between two samples, positive
   */
  public MouseDevice(HandTarget region, long intervalNanos) {
    this.intervalNanos = intervalNanos;
    position.set(beside(region));
    motion = new Motion(0, position, new Vec3().set(position));
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
  public synchronized void moveTo(Vec3 worldMm) {
    Motion now = motion;
    motion = new Motion(now.jumps, now.from, new Vec3().set(worldMm));
  }

  /**
   * Jumps to a position, and approaches another one from there. The interaction point is set free
   * at the first position, or as near to it as the solids permit. Any thread.
   *
   * @param fromMm a position outside all solids, world mm
   * @param toMm the position to approach, world mm
   */
  public synchronized void jump(Vec3 fromMm, Vec3 toMm) {
    motion = new Motion(motion.jumps + 1, new Vec3().set(fromMm), new Vec3().set(toMm));
  }

  /** Whether the device has jumped, because the user pressed somewhere. Any thread. */
  boolean hasJumped() {
    return motion.jumps > 0;
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
    Motion now = motion;
    boolean jumps = now.jumps != jumpsMade;
    if (jumps) {
      jumpsMade = now.jumps;
      position.set(now.from);
    } else {
      approach(now.target);
    }
    state.positionMm.set(position);
    state.relocated = jumps;
    state.timeNanos = reads++ * intervalNanos;
    return ReadStatus.FRESH;
  }

  private void approach(Vec3 end) {
    position.set(
        position.x + (end.x - position.x) * APPROACH_FRACTION_PER_SAMPLE,
        position.y + (end.y - position.y) * APPROACH_FRACTION_PER_SAMPLE,
        position.z + (end.z - position.z) * APPROACH_FRACTION_PER_SAMPLE);
  }

  @Override
  public boolean write(Vec3 forceNewton, Vec3 torqueNewtonMm) {
    return !closed;
  }

  @Override
  public void close() {
    closed = true;
  }
}
