package org.palpate.benchmarks.stability;

import org.hipparchus.ode.nonstiff.ClassicalRungeKuttaIntegrator;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.DeviceState;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

/**
 * The plant of the closed loop: a person with a device, seen by a frame as a device. A read
 * advances the plant by one period under the present force and returns what the encoders show. A
 * written force acts after the delay and lasts until the next one.
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
  private final double unitMm;
  private final Quaternion upright;
  private final HandleMotion motion;
  private final ClassicalRungeKuttaIntegrator integrator;
  private final int steps;
  private final double stepSeconds;
  private final Vec3[] pending;
  private final Vec3[] pendingTorque;
  private final Vec3 turned = new Vec3();
  private double[] state;
  private double seconds;
  private long samples;

  private final Vec3 lastForce = new Vec3();
  private double energyJoule;
  private double maxEnergyJoule;
  private double steepestNewtonPerMs;
  private final HandleExcursion before;
  private final HandleExcursion last;
  private final HandleRebound rebound;

  /**
   * Creates a plant whose handle is at rest, away from the surface.
   *
   * @param unitMm the unit of the positions that it delivers
   * @param motion of handle and hand, with this device
   * @param upright the intended orientation
   */
  Plant(
      DeviceModel device,
      Sampling sampling,
      Reach reach,
      double unitMm,
      HandleMotion motion,
      Quaternion upright) {
    this.device = device;
    this.sampling = sampling;
    this.reach = reach;
    this.unitMm = unitMm;
    this.motion = motion;
    this.upright = upright;
    double leave = reach.leaveSeconds();
    before =
        new HandleExcursion(
            leave - WINDOW_DISTANCE_SECONDS - WINDOW_SECONDS,
            leave - WINDOW_DISTANCE_SECONDS,
            motion.axes());
    last = new HandleExcursion(leave - WINDOW_SECONDS, leave, motion.axes());
    rebound = new HandleRebound(leave - WINDOW_SECONDS, leave, reach.inward());
    state = motion.start();
    double period = 1 / sampling.rateHz();
    steps = (int) Math.max(MIN_STEPS, Math.ceil(period / MAX_STEP_SECONDS));
    stepSeconds = period / steps;
    integrator = new ClassicalRungeKuttaIntegrator(stepSeconds);
    pending = new Vec3[sampling.delaySamples() + 1];
    pendingTorque = new Vec3[pending.length];
    for (int i = 0; i < pending.length; i++) {
      pending[i] = new Vec3();
      pendingTorque[i] = new Vec3();
    }
  }

  @Override
  public DeviceSpecification specification() {
    return new DeviceSpecification(
        device.name(),
        "model",
        device.maxForceNewton(),
        device.maxStiffnessNewtonPerMm(),
        100,
        0,
        turns(),
        turns() ? device.maxForceNewton() * Grip.RADIUS_MM : 0);
  }

  private boolean turns() {
    return motion.axes() > HandleMotion.TRANSLATIONS;
  }

  @Override
  public ReadStatus read(DeviceState sample) {
    if (samples > 0) {
      advance();
    }
    for (int axis = 0; axis < 3; axis++) {
      double seen = seen(state[axis] * MM_PER_M, device.encoderStepMm());
      sample.positionMm.set(axis, seen / unitMm);
    }
    if (turns()) {
      seeOrientation(sample.orientation);
    }
    sample.timeNanos = samples++ * sampling.periodNanos();
    return seconds < reach.endSeconds() ? ReadStatus.FRESH : ReadStatus.DISCONNECTED;
  }

  private static double seen(double value, double step) {
    return Math.rint(value / step) * step;
  }

  private void seeOrientation(Quaternion dest) {
    double step = device.encoderStepMm() / Grip.RADIUS_MM;
    for (int axis = 0; axis < 3; axis++) {
      turned.set(axis, seen(state[HandleMotion.TRANSLATIONS + axis], step));
    }
    dest.setRotationVector(turned).multiply(upright, dest);
  }

  /** Advances by one period under the force that has arrived. */
  private void advance() {
    int arrived = (int) (samples % pending.length);
    Vec3 force = pending[arrived];
    Vec3 torque = pendingTorque[arrived].mul(1 / MM_PER_M, new Vec3());
    motion.setForce(force, torque);
    double[] earlier = state;
    for (int step = 0; step < steps; step++) {
      state = integrator.singleStep(motion, seconds, state, seconds + stepSeconds);
      seconds += stepSeconds;
    }
    for (int axis = 0; axis < motion.axes(); axis++) {
      Vec3 along = axis < HandleMotion.TRANSLATIONS ? force : torque;
      energyJoule += along.get(axis % 3) * (state[axis] - earlier[axis]);
    }
    maxEnergyJoule = Math.max(maxEnergyJoule, energyJoule);
    before.record(seconds, state);
    last.record(seconds, state);
    rebound.record(seconds, state);
  }

  @Override
  public boolean write(Vec3 forceNewton, Vec3 torqueNewtonMm) {
    // The force written after sample n arrives in slot n + delay; advance() reads its sample's
    // slot.
    int slot = (int) ((samples + sampling.delaySamples()) % pending.length);
    pending[slot].set(forceNewton);
    pendingTorque[slot].set(torqueNewtonMm);
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

  /** Returns the longest way back of the handle in the last part of the stay, mm. */
  double reboundMm() {
    return rebound.longestMm();
  }

  /** Returns the excursion in the window that ended {@link #WINDOW_DISTANCE_SECONDS} before, mm. */
  double earlierExcursionMm() {
    return before.excursionMm();
  }
}
