package org.palpate.device;

import org.palpate.geometry.Vec3;

/**
 * A device moved by a seeded hand that approaches, presses, slides, taps, jerks away and tunnels.
 *
 * <p>Each read is the next sample. Where the hand is depends on the seed, the target and the number
 * of reads alone, never on a clock or on the forces, so that a session can be run again; a force is
 * kept for {@link #lastForceNewton} and otherwise forgotten.
 */
public final class SimulatedDevice implements HapticDevice {
  /** Nominal maximum force, that of a desktop device. */
  public static final double MAX_FORCE_NEWTON = 3.3;

  /** Largest stiffness, that of a desktop device. */
  public static final double MAX_STIFFNESS_NEWTON_PER_MM = 1;

  private final DeviceSpecification specification;
  private final SimulatedHand hand;
  private final long intervalNanos;
  private final Vec3 lastForceNewton = new Vec3();
  private long reads;
  private volatile boolean closed;

  /**
   * A hand over {@code target}.
   *
   * @param intervalNanos time between samples, positive; speeds of the hand are per second but for
   *     tearing away and tunnelling, which are per sample
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
    lastForceNewton.set(forceNewton);
    return !closed;
  }

  /** The force that was written last. The device's own. */
  public Vec3 lastForceNewton() {
    return lastForceNewton;
  }

  /** The number of reads so far. */
  public long reads() {
    return reads;
  }

  @Override
  public void close() {
    closed = true;
  }
}
