package org.palpate.device;

import org.palpate.geometry.Vec3;

/**
 * A device in a simulated hand that approaches, presses, slides, taps, tears away and tunnels.
 *
 * <p>Each read is the next sample. The motion depends on the seed, the target and the number of
 * reads alone, never on a clock or on the forces. A session can therefore be repeated.
 *
 * <p>Haptic thread; {@link #close} is for any thread.
 */
public final class SimulatedDevice implements HapticDevice {
  /** Nominal maximum force, that of a desktop device. */
  public static final double MAX_FORCE_NEWTON = 3.3;

  /** Largest stiffness, that of a desktop device. */
  public static final double MAX_STIFFNESS_NEWTON_PER_MM = 1;

  private final DeviceSpecification specification;
  private final SimulatedHand hand;
  private final long intervalNanos;
  private long reads;
  private volatile boolean closed;

  /**
   * Makes a device in a hand over {@code target}.
   *
   * @param intervalNanos time between samples, positive; most speeds of the hand are per second,
   *     but those of tearing away and tunnelling are per sample
   */
  public SimulatedDevice(long seed, HandTarget target, long intervalNanos) {
    if (intervalNanos <= 0) {
      throw new IllegalArgumentException(
          "intervalNanos must be positive: intervalNanos=" + intervalNanos);
    }
    this.intervalNanos = intervalNanos;
    hand = new SimulatedHand(seed, target, intervalNanos);
    specification =
        new DeviceSpecification(
            "simulated",
            Long.toString(seed),
            MAX_FORCE_NEWTON,
            MAX_STIFFNESS_NEWTON_PER_MM,
            target.radiusMm(),
            0);
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
    hand.next(state.positionMm);
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
