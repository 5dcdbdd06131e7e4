package org.palpate.benchmarks.stability;

import java.util.Arrays;
import org.hipparchus.ode.OrdinaryDifferentialEquation;
import org.palpate.geometry.Vec3;

/**
 * The equation of motion of handle and hand: masses on springs and dampers, the same for all axes.
 * The axes are x, y and z and, of a handle that also turns, the rotations about them.
 *
 * <p>A rotation has the mass, damping and grip of a translation times the squared grip radius. The
 * angles are small, so the rotations about the three axes are independent.
 *
 * <p>The state is handle position and velocity, hand position and velocity, each one double an
 * axis: m and m/s, rad and rad/s.
 */
final class HandleMotion implements OrdinaryDifferentialEquation {
  /** The number of translations, which are the first axes. */
  static final int TRANSLATIONS = 3;

  private static final double M_PER_MM = 1e-3;

  private final DeviceModel device;
  private final Grip grip;
  private final Reach reach;
  private final int axes;
  private final double[] away;
  private final double[] travel;
  private final double[] press;
  private final double[] force;

  /** The force that moves an axis like a newton moves a translation; 1 or the radius squared. */
  private final double[] scale;

  /** Creates the motion of a handle that does not turn. */
  HandleMotion(DeviceModel device, Grip grip, Reach reach) {
    this(device, grip, reach, TRANSLATIONS);
  }

  /** Creates the motion of a handle that also turns, with the same intended orientation always. */
  static HandleMotion turning(DeviceModel device, Grip grip, Reach reach) {
    return new HandleMotion(device, grip, reach, 2 * TRANSLATIONS);
  }

  private HandleMotion(DeviceModel device, Grip grip, Reach reach, int axes) {
    this.device = device;
    this.grip = grip;
    this.reach = reach;
    this.axes = axes;
    away = new double[axes];
    travel = new double[axes];
    press = new double[axes];
    force = new double[axes];
    scale = new double[axes];
    double radius = Grip.RADIUS_MM * M_PER_MM;
    Arrays.fill(scale, radius * radius);
    Vec3 along = reach.pressedMm().sub(reach.awayMm(), new Vec3());
    for (int axis = 0; axis < TRANSLATIONS; axis++) {
      scale[axis] = 1;
      away[axis] = reach.awayMm().get(axis) * M_PER_MM;
      travel[axis] = along.get(axis) * M_PER_MM;
      press[axis] = grip.pressNewton() * along.get(axis) / along.length();
    }
  }

  /** Returns the number of axes: 3, or 6 of a handle that turns. */
  int axes() {
    return axes;
  }

  private int hand() {
    return 2 * axes;
  }

  /** Returns the state at rest, away from the surface. */
  double[] start() {
    double[] state = new double[4 * axes];
    System.arraycopy(away, 0, state, 0, axes);
    System.arraycopy(away, 0, state, hand(), axes);
    return state;
  }

  /** Sets the device's force on the handle, N, and the torque, N m, if it turns. */
  void setForce(Vec3 newton, Vec3 newtonM) {
    for (int axis = 0; axis < axes; axis++) {
      Vec3 along = axis < TRANSLATIONS ? newton : newtonM;
      force[axis] = along.get(axis % TRANSLATIONS) / scale[axis];
    }
  }

  @Override
  public int getDimension() {
    return 4 * axes;
  }

  @Override
  public double[] computeDerivatives(double seconds, double[] state) {
    double[] rates = new double[4 * axes];
    double fraction = reach.fraction(seconds);
    double fractionRate = reach.fractionRate(seconds);
    for (int axis = 0; axis < axes; axis++) {
      double handleVelocity = state[axes + axis];
      double handVelocity = state[hand() + axes + axis];
      double gripForce =
          grip.gripNewtonPerM() * (state[hand() + axis] - state[axis])
              + grip.gripNewtonSecondPerM() * (handVelocity - handleVelocity);
      double armForce =
          grip.armNewtonPerM() * (away[axis] + fraction * travel[axis] - state[hand() + axis])
              + grip.armNewtonSecondPerM() * (fractionRate * travel[axis] - handVelocity);
      rates[axis] = handleVelocity;
      rates[hand() + axis] = handVelocity;
      rates[axes + axis] =
          (force[axis]
                  + press[axis] * fraction
                  + gripForce
                  - device.dampingNewtonSecondPerM() * handleVelocity)
              / device.handleKg();
      rates[hand() + axes + axis] = (armForce - gripForce) / grip.handKg();
    }
    return rates;
  }
}
