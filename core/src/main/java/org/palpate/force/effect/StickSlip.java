package org.palpate.force.effect;

import org.palpate.force.HandState;
import org.palpate.force.HapticEffect;
import org.palpate.geometry.Vec3;

/**
 * Sticks to a surface and slips. In contact a spring holds the hand to the position where it stuck,
 * along the surface. If it pulls more than a limit, the hand slips: the spring relaxes within some
 * milliseconds, and the hand sticks again.
 *
 * <p>A spring that relaxes gives no energy to the hand. It relaxes in the same way when contact
 * ends. Of a rigid tool the reference point sticks. Haptic thread; allocates nothing.
 */
final class StickSlip implements HapticEffect {
  /** The time in which a spring that relaxes falls to 1/e, s. */
  private static final double RELAXATION_SECONDS = 0.005;

  /** The fraction of the limit at which a slipping hand sticks again. */
  private static final double STICKS_AGAIN = 0.2;

  private final double maxNewton;
  private final double newtonPerMm;
  private final Vec3 last = new Vec3();
  private final Vec3 pull = new Vec3();
  private final Vec3 scratch = new Vec3();
  private boolean known;
  private boolean slips;

  /**
   * Creates an effect.
   *
   * @param maxNewton the pull at which the hand slips, N
   * @param newtonPerMm the stiffness of the spring, N/mm
   */
  StickSlip(double maxNewton, double newtonPerMm) {
    this.maxNewton = maxNewton;
    this.newtonPerMm = newtonPerMm;
  }

  @Override
  public void reset() {
    known = false;
    slips = false;
    pull.set(0, 0, 0);
  }

  @Override
  public void add(HandState hand, Vec3 forceNewton, Vec3 torqueNewtonMm) {
    Vec3 at = hand.device.translation;
    if (known && hand.contact) {
      pull.add(last.sub(at, scratch).mul(newtonPerMm, scratch), pull);
    }
    last.set(at);
    known = true;
    removeComponentAlong(hand.contactNewton);
    double newton = pull.length();
    slips = newton > maxNewton || (slips && newton > STICKS_AGAIN * maxNewton);
    if (slips || !hand.contact) {
      pull.mul(RELAXATION_SECONDS / (RELAXATION_SECONDS + hand.seconds), pull);
    }
    newton = pull.length();
    pull.mul(newton > maxNewton ? maxNewton / newton : 1, pull);
    forceNewton.add(pull, forceNewton);
  }

  /** Leaves the pull along the surface: removes the part along the pressing force. */
  private void removeComponentAlong(Vec3 pressing) {
    double square = pressing.dot(pressing);
    if (square > 0) {
      pull.sub(pressing.mul(pull.dot(pressing) / square, scratch), pull);
    }
  }
}
