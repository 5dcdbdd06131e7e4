package org.palpate.device;

import org.palpate.geometry.Vec3;

/**
 * A device that delivers the samples of a trajectory, one a read, and disconnects after the last.
 * It ignores forces and torques. Haptic thread; {@link #close} is for any thread.
 */
public final class ReplayDevice implements HapticDevice {
  private final DeviceSpecification specification;
  private final Trajectory trajectory;
  private int next;
  private volatile boolean closed;

  /**
   * Makes a device that replays a trajectory.
   *
   * @param name name in reports
   * @param trajectory must not change any more
   */
  public ReplayDevice(String name, Trajectory trajectory) {
    specification =
        new DeviceSpecification(
            name,
            "",
            Double.POSITIVE_INFINITY,
            Double.POSITIVE_INFINITY,
            0,
            0,
            trajectory.hasOrientations(),
            Double.POSITIVE_INFINITY);
    this.trajectory = trajectory;
  }

  @Override
  public DeviceSpecification specification() {
    return specification;
  }

  @Override
  public ReadStatus read(DeviceState state) {
    if (closed || next == trajectory.size()) {
      return ReadStatus.DISCONNECTED;
    }
    trajectory.read(next++, state);
    return ReadStatus.FRESH;
  }

  /** Restarts the replay at the first sample. */
  public void rewind() {
    next = 0;
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
