package org.palpate.testing;

import org.palpate.device.DeviceDecorator;
import org.palpate.device.DeviceState;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

/**
 * A device in a hand that yields to force and torque: it goes where the hand behind it wants, plus
 * the force over a stiffness, plus the same for rotations. It yields as a spring and a damper do.
 *
 * <p>One read is a millisecond. Thread of the reader.
 */
public final class YieldingHand extends DeviceDecorator {
  /** The time in which the hand yields to a constant force but for 1/e. */
  private static final double SETTLING_MS = 100;

  private final double newtonPerMm;
  private final double newtonMmPerRad;
  private final Vec3 force = new Vec3();
  private final Vec3 torque = new Vec3();
  private final Vec3 shift = new Vec3();
  private final Vec3 turn = new Vec3();
  private final Vec3 change = new Vec3();
  private final Quaternion rotation = new Quaternion();

  /** Creates a hand with a stiffness for displacements and one for rotations, both positive. */
  public YieldingHand(HapticDevice intended, double newtonPerMm, double newtonMmPerRad) {
    super(intended);
    this.newtonPerMm = newtonPerMm;
    this.newtonMmPerRad = newtonMmPerRad;
  }

  @Override
  public ReadStatus read(DeviceState state) {
    ReadStatus status = device.read(state);
    yieldTo(force, newtonPerMm, shift);
    yieldTo(torque, newtonMmPerRad, turn);
    state.positionMm.add(shift, state.positionMm);
    rotation.setRotationVector(turn).multiply(state.orientation, state.orientation);
    state.orientation.normalize();
    return status;
  }

  private void yieldTo(Vec3 push, double stiffness, Vec3 dest) {
    push.mul(1 / stiffness, change).sub(dest, change).mul(1 / SETTLING_MS, change);
    dest.add(change, dest);
  }

  @Override
  public boolean write(Vec3 forceNewton, Vec3 torqueNewtonMm) {
    force.set(forceNewton);
    torque.set(torqueNewtonMm);
    return super.write(forceNewton, torqueNewtonMm);
  }
}
