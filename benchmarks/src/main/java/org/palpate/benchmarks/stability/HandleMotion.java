package org.palpate.benchmarks.stability;

import org.hipparchus.ode.OrdinaryDifferentialEquation;
import org.palpate.geometry.Vec3;

/**
 * The equation of motion of handle and hand: masses on springs and dampers, the same for all three
 * axes. The state is handle position and velocity, hand position and velocity, each three doubles,
 * m and m/s.
 */
final class HandleMotion implements OrdinaryDifferentialEquation {
  static final int HANDLE = 0;
  static final int HANDLE_VELOCITY = 3;
  static final int HAND = 6;
  static final int HAND_VELOCITY = 9;
  private static final int STATES = 12;
  private static final double M_PER_MM = 1e-3;

  private final DeviceModel device;
  private final Grip grip;
  private final Reach reach;
  private final double[] away = new double[3];
  private final double[] travel = new double[3];
  private final double[] press = new double[3];
  private final double[] force = new double[3];

  HandleMotion(DeviceModel device, Grip grip, Reach reach) {
    this.device = device;
    this.grip = grip;
    this.reach = reach;
    Vec3 along = reach.pressedMm().sub(reach.awayMm(), new Vec3());
    for (int axis = 0; axis < 3; axis++) {
      away[axis] = reach.awayMm().get(axis) * M_PER_MM;
      travel[axis] = along.get(axis) * M_PER_MM;
      press[axis] = grip.pressNewton() * along.get(axis) / along.length();
    }
  }

  /** Returns the state at rest, away from the surface. */
  double[] start() {
    double[] state = new double[STATES];
    System.arraycopy(away, 0, state, HANDLE, 3);
    System.arraycopy(away, 0, state, HAND, 3);
    return state;
  }

  /** Sets the device's force on the handle, N. */
  void setForce(Vec3 newton) {
    force[0] = newton.x;
    force[1] = newton.y;
    force[2] = newton.z;
  }

  @Override
  public int getDimension() {
    return STATES;
  }

  @Override
  public double[] computeDerivatives(double seconds, double[] state) {
    double[] rates = new double[STATES];
    double fraction = reach.fraction(seconds);
    double fractionRate = reach.fractionRate(seconds);
    for (int axis = 0; axis < 3; axis++) {
      double handleVelocity = state[HANDLE_VELOCITY + axis];
      double handVelocity = state[HAND_VELOCITY + axis];
      double gripForce =
          grip.gripNewtonPerM() * (state[HAND + axis] - state[HANDLE + axis])
              + grip.gripNewtonSecondPerM() * (handVelocity - handleVelocity);
      double armForce =
          grip.armNewtonPerM() * (away[axis] + fraction * travel[axis] - state[HAND + axis])
              + grip.armNewtonSecondPerM() * (fractionRate * travel[axis] - handVelocity);
      rates[HANDLE + axis] = handleVelocity;
      rates[HAND + axis] = handVelocity;
      rates[HANDLE_VELOCITY + axis] =
          (force[axis]
                  + press[axis] * fraction
                  + gripForce
                  - device.dampingNewtonSecondPerM() * handleVelocity)
              / device.handleKg();
      rates[HAND_VELOCITY + axis] = (armForce - gripForce) / grip.handKg();
    }
    return rates;
  }
}
