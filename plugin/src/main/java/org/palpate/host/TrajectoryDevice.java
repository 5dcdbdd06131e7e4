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
  /** Time between two frames if the trajectory's own times are not used. */
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
  private final boolean ownTimes;
  private final Vec3 lastPosition = new Vec3();
  private int next;

  /**
   * Creates a device at the first sample.
   *
   * @param ownTimes whether samples carry the trajectory's times; otherwise they are equidistant
   */
  TrajectoryDevice(Trajectory trajectory, boolean ownTimes) {
    this.trajectory = trajectory;
    this.ownTimes = ownTimes;
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
    if (!ownTimes) {
      state.timeNanos = next * FRAME_NANOS;
    }
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
