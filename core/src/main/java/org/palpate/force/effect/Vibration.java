package org.palpate.force.effect;

import org.palpate.force.HandState;
import org.palpate.force.HapticEffect;
import org.palpate.geometry.Vec3;

/**
 * Shakes the hand in contact, as a drill does: a sine along the pressing force. It is never longer
 * than the pressing force, so it begins and ends with contact. Haptic thread; allocates nothing.
 *
 * <p>This effect is active: it gives energy to the hand.
 */
final class Vibration implements HapticEffect {
  private static final double FULL_TURN = 2 * Math.PI;

  private final double radPerSecond;
  private final double newton;
  private final Vec3 shake = new Vec3();
  private double phase;

  /**
   * Creates an effect.
   *
   * @param hertz its frequency
   * @param newton its amplitude, N
   */
  Vibration(double hertz, double newton) {
    radPerSecond = FULL_TURN * hertz;
    this.newton = newton;
  }

  @Override
  public void reset() {
    phase = 0;
  }

  @Override
  public void add(HandState hand, Vec3 forceNewton, Vec3 torqueNewtonMm) {
    phase = (phase + radPerSecond * hand.seconds) % FULL_TURN;
    double pressing = hand.contactNewton.length();
    if (pressing > 0) {
      double factor = Math.min(newton, pressing) * StrictMath.sin(phase) / pressing;
      forceNewton.add(hand.contactNewton.mul(factor, shake), forceNewton);
    }
  }
}
