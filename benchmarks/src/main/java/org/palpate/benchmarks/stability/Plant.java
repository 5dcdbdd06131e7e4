package org.palpate.benchmarks.stability;

import org.hipparchus.ode.nonstiff.ClassicalRungeKuttaIntegrator;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.DeviceState;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.geometry.Vec3;

/**
 * A person with a device in hand, seen by a frame as a device: a read lets one period pass under
 * the force that was held, and gives the encoder's position in grid coordinates. The force of a
 * write takes hold after the delay and stays until the next.
 *
 * <p>Watches what the contact does: the energy it puts into the handle, the force's rise, the
 * handle's play while the hand wants to rest.
 */
final class Plant implements HapticDevice {
  /** Integration is at least this much finer than a frame. */
  private static final int LEAST_STEPS = 4;

  /** And its steps are no longer than this; the fastest mode of the models is some 400 rad/s. */
  private static final double LONGEST_STEP_SECONDS = 1e-4;

  private static final double MM_PER_M = 1e3;

  /** The last part of the stay, in which the handle should rest, is as long as this. */
  private static final double WATCHED_SECONDS = 0.25;

  /** Another part of that length is watched before it, so that play which shrinks is seen to. */
  static final double APART_SECONDS = 1;

  private final DeviceModel device;
  private final Sampling sampling;
  private final Reach reach;
  private final double voxelMm;
  private final HandleMotion motion;
  private final ClassicalRungeKuttaIntegrator integrator;
  private final int steps;
  private final double stepSeconds;
  private final Vec3[] underWay;
  private double[] state;
  private double seconds;
  private long samples;

  private final Vec3 lastForce = new Vec3();
  private double energyJoule;
  private double mostEnergyJoule;
  private double steepestNewtonPerMs;
  private final HandleExcursion before;
  private final HandleExcursion last;

  Plant(DeviceModel device, Grip grip, Sampling sampling, Reach reach, double voxelMm) {
    this.device = device;
    this.sampling = sampling;
    this.reach = reach;
    this.voxelMm = voxelMm;
    double leave = reach.leaveSeconds();
    before = new HandleExcursion(leave - APART_SECONDS - WATCHED_SECONDS, leave - APART_SECONDS);
    last = new HandleExcursion(leave - WATCHED_SECONDS, leave);
    motion = new HandleMotion(device, grip, reach);
    state = motion.start();
    double period = 1 / sampling.rateHz();
    steps = (int) Math.max(LEAST_STEPS, Math.ceil(period / LONGEST_STEP_SECONDS));
    stepSeconds = period / steps;
    integrator = new ClassicalRungeKuttaIntegrator(stepSeconds);
    underWay = new Vec3[sampling.delaySamples() + 1];
    for (int i = 0; i < underWay.length; i++) {
      underWay[i] = new Vec3();
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
      pass();
    }
    for (int axis = 0; axis < 3; axis++) {
      double mm = state[HandleMotion.HANDLE + axis] * MM_PER_M;
      double seen = Math.rint(mm / device.encoderStepMm()) * device.encoderStepMm();
      sample.positionMm.set(axis, seen / voxelMm);
    }
    sample.timeNanos = samples++ * sampling.periodNanos();
    return seconds < reach.endSeconds() ? ReadStatus.FRESH : ReadStatus.DISCONNECTED;
  }

  /** One period under the force that has arrived. */
  private void pass() {
    Vec3 held = underWay[(int) (samples % underWay.length)];
    motion.hold(held);
    double x = state[HandleMotion.HANDLE];
    double y = state[HandleMotion.HANDLE + 1];
    double z = state[HandleMotion.HANDLE + 2];
    for (int step = 0; step < steps; step++) {
      state = integrator.singleStep(motion, seconds, state, seconds + stepSeconds);
      seconds += stepSeconds;
    }
    energyJoule +=
        held.x * (state[HandleMotion.HANDLE] - x)
            + held.y * (state[HandleMotion.HANDLE + 1] - y)
            + held.z * (state[HandleMotion.HANDLE + 2] - z);
    mostEnergyJoule = Math.max(mostEnergyJoule, energyJoule);
    before.watch(seconds, state);
    last.watch(seconds, state);
  }

  @Override
  public boolean write(Vec3 forceNewton) {
    // What is written after sample n arrives at slot n + delay; pass() reads the slot of its
    // sample.
    underWay[(int) ((samples + sampling.delaySamples()) % underWay.length)].set(forceNewton);
    double change = forceNewton.sub(lastForce, new Vec3()).length();
    steepestNewtonPerMs = Math.max(steepestNewtonPerMs, change * sampling.rateHz() / MM_PER_M);
    lastForce.set(forceNewton);
    return true;
  }

  @Override
  public void close() {}

  /** The most energy that the contact had put into the handle at any time, J. */
  double mostEnergyJoule() {
    return mostEnergyJoule;
  }

  /** The fastest change of force between two frames, N/ms. */
  double steepestNewtonPerMs() {
    return steepestNewtonPerMs;
  }

  /** How far the handle moved in the last part of its stay, mm. */
  double playMm() {
    return last.playMm();
  }

  /** How far it moved in a part of the same length that ended {@link #APART_SECONDS} before, mm. */
  double earlierPlayMm() {
    return before.playMm();
  }
}
