package org.palpate.host;

import org.palpate.device.DeviceSpecification;
import org.palpate.device.DeviceState;
import org.palpate.device.HandTarget;
import org.palpate.device.ReadStatus;
import org.palpate.device.SimulatedDevice;
import org.palpate.device.TurnableDevice;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

/**
 * A mouse as a haptic device without force. In each millisecond its pose covers a fiftieth of the
 * way to the pointer, so it moves and turns smoothly. A new press makes it jump. Any thread moves
 * the pointer; the haptic thread reads the device.
 */
public final class MouseDevice implements TurnableDevice {
  /** Part of the remaining distance to the pointer that is covered in a millisecond. */
  private static final double APPROACH_PER_MS = 0.02;

  private static final double NANOS_PER_MS = 1e6;

  private final DeviceSpecification specification;
  private final long intervalNanos;
  private final double approach;
  private final Pose pose = new Pose();
  private final Pose.Scratch scratch = new Pose.Scratch();
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
   * @param target the pose to approach
   */
  private record Motion(long jumps, Vec3 from, Pose target) {}

  /**
   * Creates a device that rests beside the region until the pointer moves.
   *
   * @param region the region to touch, world mm
   * @param intervalNanos time between two samples, positive
   */
  public MouseDevice(HandTarget region, long intervalNanos) {
    this.intervalNanos = intervalNanos;
    approach = Math.min(1, APPROACH_PER_MS * (intervalNanos / NANOS_PER_MS));
    Vec3 start = beside(region);
    pose.translation.set(start);
    motion = new Motion(0, start, new Pose().set(pose));
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

  /**
   * Sets the position that the device approaches. Any thread.
   *
   * @param worldMm the position, world mm; copied
   */
  public synchronized void moveTo(Vec3 worldMm) {
    Motion now = motion;
    motion = new Motion(now.jumps, now.from, new Pose().set(worldMm, now.target.rotation));
  }

  /**
   * Turns the orientation that the device approaches, which a rigid tool follows. Any thread.
   *
   * @param rotationVector axis times angle, world axes, rad
   */
  @Override
  public synchronized void turn(Vec3 rotationVector) {
    Motion now = motion;
    Pose target = new Pose();
    now.target.displace(new Vec3(), rotationVector, 1, new Quaternion(), target);
    motion = new Motion(now.jumps, now.from, target);
  }

  /**
   * Jumps to a position, and approaches another one from there. The interaction point is set free
   * at the first position, or as near to it as the solids permit. Any thread.
   *
   * @param fromMm a position outside all solids, world mm
   * @param toMm the position to approach, world mm
   */
  public synchronized void jump(Vec3 fromMm, Vec3 toMm) {
    Pose target = new Pose().set(toMm, motion.target.rotation);
    motion = new Motion(motion.jumps + 1, new Vec3().set(fromMm), target);
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
      pose.translation.set(now.from);
    } else {
      pose.interpolate(now.target, approach, scratch, pose);
    }
    state.positionMm.set(pose.translation);
    state.orientation.set(pose.rotation);
    state.relocated = jumps;
    state.timeNanos = reads++ * intervalNanos;
    return ReadStatus.FRESH;
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
