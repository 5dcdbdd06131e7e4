package org.palpate.device;

import org.palpate.geometry.Vec3;

/**
 * A device in a simulated hand that approaches, presses, slides, taps, tears away and tunnels.
 *
 * <p>Each read is the next sample. The motion depends on the seed, the target and the number of
 * reads alone, never on a clock, on forces or on torques. A session can therefore be repeated.
 *
 * <p>Haptic thread; {@link #close} is for any thread.
 */
public final class SimulatedDevice implements HapticDevice {
  /** Nominal maximum force, that of a desktop device. */
  public static final double MAX_FORCE_NEWTON = 3.3;

  /** Largest stiffness, that of a desktop device. */
  public static final double MAX_STIFFNESS_NEWTON_PER_MM = 1;

  /** Nominal maximum torque of a device with orientation, that of a desktop device. */
  public static final double MAX_TORQUE_NEWTON_MM = 188;

  private final DeviceSpecification specification;
  private final SimulatedHand hand;
  private final SimulatedWrist wrist;
  private final long intervalNanos;
  private long reads;
  private volatile boolean closed;

  /**
   * Makes a device of three degrees of freedom in a hand over a target.
   *
   * @param seed selects the motion
   * @param target what the hand touches
   * @param intervalNanos time between samples, positive; most speeds of the hand are per second,
   *     but those of tearing away and tunnelling are per sample
   */
  public SimulatedDevice(long seed, HandTarget target, long intervalNanos) {
    this(seed, target, intervalNanos, false);
  }

  /**
   * {@return a device of six degrees of freedom: the same positions, in a hand that turns too}
   *
   * @param seed selects the motion
   * @param target what the hand touches
   * @param intervalNanos time between samples, positive
   */
  public static SimulatedDevice withOrientation(long seed, HandTarget target, long intervalNanos) {
    return new SimulatedDevice(seed, target, intervalNanos, true);
  }

  private SimulatedDevice(long seed, HandTarget target, long intervalNanos, boolean turns) {
    if (intervalNanos <= 0) {
      throw new IllegalArgumentException(
          "intervalNanos must be positive: intervalNanos=" + intervalNanos);
    }
    this.intervalNanos = intervalNanos;
    hand = new SimulatedHand(seed, target, intervalNanos);
    wrist = turns ? new SimulatedWrist(seed, intervalNanos) : null;
    specification =
        new DeviceSpecification(
            "simulated",
            Long.toString(seed),
            MAX_FORCE_NEWTON,
            MAX_STIFFNESS_NEWTON_PER_MM,
            target.radiusMm(),
            0,
            turns,
            turns ? MAX_TORQUE_NEWTON_MM : 0);
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
    if (wrist != null) {
      wrist.next(state.orientation);
    }
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
