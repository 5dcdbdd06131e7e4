package org.palpate.benchmarks.stability;

import org.hipparchus.ode.nonstiff.ClassicalRungeKuttaIntegrator;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.DeviceState;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.geometry.Vec3;

/**
 * The plant of the closed loop: a person with a device, seen by a frame as a device. A read
 * advances the plant by one period under the present force and returns the encoder's position in
 * grid coordinates. A written force acts after the delay and lasts until the next one.
 *
 * <p>It records the energy that the contact puts into the handle, the change of the force, and the
 * excursion of the handle while the hand tries to rest.
 */
final class Plant implements HapticDevice {
  /** Each frame has at least this many integration steps. */
  private static final int MIN_STEPS = 4;

  /** The longest integration step; the fastest mode of the models has about 400 rad/s. */
  private static final double MAX_STEP_SECONDS = 1e-4;

  private static final double MM_PER_M = 1e3;

  /** The length of the last part of the stay, in which the handle should rest. */
  private static final double WINDOW_SECONDS = 0.25;

  /** The distance to an earlier window of that length, which shows whether an excursion decays. */
  static final double WINDOW_DISTANCE_SECONDS = 1;

  private final DeviceModel device;
  private final Sampling sampling;
  private final Reach reach;
  private final double voxelMm;
  private final HandleMotion motion;
  private final ClassicalRungeKuttaIntegrator integrator;
  private final int steps;
  private final double stepSeconds;
  private final Vec3[] pending;
  private double[] state;
  private double seconds;
  private long samples;

  private final Vec3 lastForce = new Vec3();
  private double energyJoule;
  private double maxEnergyJoule;
  private double steepestNewtonPerMs;
  private final HandleExcursion before;
  private final HandleExcursion last;

  Plant(DeviceModel device, Grip grip, Sampling sampling, Reach reach, double voxelMm) {
    this.device = device;
    this.sampling = sampling;
    this.reach = reach;
    this.voxelMm = voxelMm;
    double leave = reach.leaveSeconds();
    before =
        new HandleExcursion(
            leave - WINDOW_DISTANCE_SECONDS - WINDOW_SECONDS, leave - WINDOW_DISTANCE_SECONDS);
    last = new HandleExcursion(leave - WINDOW_SECONDS, leave);
    motion = new HandleMotion(device, grip, reach);
    state = motion.start();
    double period = 1 / sampling.rateHz();
    steps = (int) Math.max(MIN_STEPS, Math.ceil(period / MAX_STEP_SECONDS));
    stepSeconds = period / steps;
    integrator = new ClassicalRungeKuttaIntegrator(stepSeconds);
    pending = new Vec3[sampling.delaySamples() + 1];
    for (int i = 0; i < pending.length; i++) {
      pending[i] = new Vec3();
    }
  }

  @Override
  public DeviceSpecification specification() {
    return new DeviceSpecification(
        device.name(), "model", device.maxForceNewton(), device.maxStiffnessNewtonPerMm(), 100, 0);
  }

  @Override
  public ReadStatus read(DeviceState sample) {
    if (samples > 0) {
      advance();
    }
    for (int axis = 0; axis < 3; axis++) {
      double mm = state[HandleMotion.HANDLE + axis] * MM_PER_M;
      double seen = Math.rint(mm / device.encoderStepMm()) * device.encoderStepMm();
      sample.positionMm.set(axis, seen / voxelMm);
    }
    sample.timeNanos = samples++ * sampling.periodNanos();
    return seconds < reach.endSeconds() ? ReadStatus.FRESH : ReadStatus.DISCONNECTED;
  }

  /** Advances by one period under the force that has arrived. */
  private void advance() {
    Vec3 force = pending[(int) (samples % pending.length)];
    motion.setForce(force);
    double x = state[HandleMotion.HANDLE];
    double y = state[HandleMotion.HANDLE + 1];
    double z = state[HandleMotion.HANDLE + 2];
    for (int step = 0; step < steps; step++) {
      state = integrator.singleStep(motion, seconds, state, seconds + stepSeconds);
      seconds += stepSeconds;
    }
    energyJoule +=
        force.x * (state[HandleMotion.HANDLE] - x)
            + force.y * (state[HandleMotion.HANDLE + 1] - y)
            + force.z * (state[HandleMotion.HANDLE + 2] - z);
    maxEnergyJoule = Math.max(maxEnergyJoule, energyJoule);
    before.record(seconds, state);
    last.record(seconds, state);
  }

  @Override
  public boolean write(Vec3 forceNewton, Vec3 torqueNewtonMm) {
    // The force written after sample n arrives in slot n + delay; advance() reads its sample's
    // slot.
    pending[(int) ((samples + sampling.delaySamples()) % pending.length)].set(forceNewton);
    double change = forceNewton.sub(lastForce, new Vec3()).length();
    steepestNewtonPerMs = Math.max(steepestNewtonPerMs, change * sampling.rateHz() / MM_PER_M);
    lastForce.set(forceNewton);
    return true;
  }

  @Override
  public void close() {}

  /** Returns the largest energy that the contact had put into the handle at any time, J. */
  double maxEnergyJoule() {
    return maxEnergyJoule;
  }

  /** Returns the largest change of force between two frames, N/ms. */
  double steepestNewtonPerMs() {
    return steepestNewtonPerMs;
  }

  /** Returns the handle's excursion in the last part of the stay, mm. */
  double excursionMm() {
    return last.excursionMm();
  }

  /** Returns the excursion in the window that ended {@link #WINDOW_DISTANCE_SECONDS} before, mm. */
  double earlierExcursionMm() {
    return before.excursionMm();
  }
}
