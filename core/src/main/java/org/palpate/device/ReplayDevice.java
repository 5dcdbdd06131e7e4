package org.palpate.device;

import org.palpate.geometry.Vec3;

/**
 * A device that gives the samples of a trajectory, one a read, and is gone after the last. It feels
 * nothing: forces are taken and forgotten.
 */
public final class ReplayDevice implements HapticDevice {
  private final DeviceSpecification specification;
  private final Trajectory trajectory;
  private int next;
  private volatile boolean closed;

  /**
   * Replays {@code trajectory}, which must not change any more.
   *
   * @param name what reports call it
   */
  public ReplayDevice(String name, Trajectory trajectory) {
    specification =
        new DeviceSpecification(name, "", Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, 0, 0);
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

  /** The number of samples read since the start or the last {@link #rewind}. */
  public int samplesRead() {
    return next;
  }

  /** Starts again at the first sample. */
  public void rewind() {
    next = 0;
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
