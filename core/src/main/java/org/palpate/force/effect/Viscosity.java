package org.palpate.force.effect;

import org.palpate.force.HandState;
import org.palpate.force.HapticEffect;
import org.palpate.geometry.Vec3;

/**
 * Resists every motion of the hand, as a thick liquid does: a force against its speed, and a torque
 * against its angular speed. Haptic thread; allocates nothing.
 */
final class Viscosity implements HapticEffect {
  private final double newtonSecondPerMm;
  private final double maxNewton;
  private final double leverMm;
  private final Vec3 drag = new Vec3();

  /**
   * Creates an effect.
   *
   * @param newtonSecondPerMm force per speed
   * @param maxNewton the longest force, N
   * @param leverMm the lever of the coupling, mm
   */
  Viscosity(double newtonSecondPerMm, double maxNewton, double leverMm) {
    this.newtonSecondPerMm = newtonSecondPerMm;
    this.maxNewton = maxNewton;
    this.leverMm = leverMm;
  }

  @Override
  public void add(HandState hand, Vec3 forceNewton, Vec3 torqueNewtonMm) {
    addDrag(hand.velocityMmPerSecond, newtonSecondPerMm, maxNewton, forceNewton);
    if (hand.isRigid) {
      double turning = newtonSecondPerMm * leverMm * leverMm;
      addDrag(hand.spinRadPerSecond, turning, maxNewton * leverMm, torqueNewtonMm);
    }
  }

  private void addDrag(Vec3 speed, double factor, double most, Vec3 dest) {
    speed.mul(-factor, drag);
    double length = drag.length();
    drag.mul(length > most ? most / length : 1, drag).add(dest, dest);
  }
}
