package org.palpate.host;

import org.palpate.device.DeviceSpecification;
import org.palpate.device.DeviceState;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.device.Trajectory;
import org.palpate.geometry.Vec3;

/**
 * Delivers one sample of a trajectory at each read, for frames that run without a clock.
 *
 * <p>Core's {@code ReplayDevice} replays in real time instead: it repeats or skips samples by the
 * clock.
 */
final class TrajectoryDevice implements HapticDevice {
  /** The usual time between two frames. */
  static final long FRAME_NANOS = 1_000_000;

  private static final DeviceSpecification SPECIFICATION =
      new DeviceSpecification(
          "replay",
          "",
          Double.POSITIVE_INFINITY,
          Double.POSITIVE_INFINITY,
          0,
          FRAME_NANOS,
          true,
          Double.POSITIVE_INFINITY);

  private final Trajectory trajectory;
  private final boolean raw;
  private final Vec3 lastPosition = new Vec3();
  private long lastNanos;
  private int next;

  /**
   * Creates a device at the first sample.
   *
   * @param raw whether samples carry the trajectory's times as they are; otherwise each time is at
   *     least a nanosecond after the last one, so that every sample is new
   */
  TrajectoryDevice(Trajectory trajectory, boolean raw) {
    this.trajectory = trajectory;
    this.raw = raw;
  }

  @Override
  public DeviceSpecification specification() {
    return SPECIFICATION;
  }

  @Override
  public ReadStatus read(DeviceState state) {
    if (next == trajectory.size()) {
      return ReadStatus.DISCONNECTED;
    }
    trajectory.read(next, state);
    if (!raw && next > 0) {
      state.timeNanos = Math.max(state.timeNanos, lastNanos + 1);
    }
    lastNanos = state.timeNanos;
    lastPosition.set(state.positionMm);
    next++;
    return ReadStatus.FRESH;
  }

  /**
   * Returns the position that was read last, in the trajectory's coordinates. Owned by the device.
   */
  Vec3 lastPosition() {
    return lastPosition;
  }

  @Override
  public boolean write(Vec3 forceNewton, Vec3 torqueNewtonMm) {
    return true;
  }

  @Override
  public void close() {
    // There is nothing to release.
  }
}
