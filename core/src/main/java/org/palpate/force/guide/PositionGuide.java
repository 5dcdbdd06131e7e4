package org.palpate.force.guide;

import org.palpate.force.FramePart;
import org.palpate.force.HandState;
import org.palpate.force.HapticEffect;
import org.palpate.geometry.Vec3;

/**
 * Pulls the hand to the nearest position of a shape. Of a rigid tool it pulls the reference point
 * and leaves the orientation free.
 *
 * <p>The nearest position may jump, for example from one limb of a bent path to the other. The
 * anchor to which the guide pulls then approaches it: in a frame by twice the motion of the hand,
 * or by {@link #LEAST_STEP_MM} in a millisecond.
 *
 * <p>Reference: Rosenberg, Virtual fixtures, 1993. Haptic thread; allocates nothing.
 */
public final class PositionGuide implements HapticEffect {
  /** The motion of the anchor that is always allowed in a frame of a millisecond, mm. */
  static final double LEAST_STEP_MM = 0.02;

  private final GuideShape shape;
  private final GuideSpring spring;
  private final Vec3 nearest = new Vec3();
  private final Vec3 anchor = new Vec3();
  private final Vec3 lastHand = new Vec3();
  private final Vec3 offset = new Vec3();
  private boolean known;

  /**
   * Creates a guide.
   *
   * @param shape the positions that the guide allows; the guide keeps it
   * @param spring the spring that pulls to them
   */
  public PositionGuide(GuideShape shape, GuideSpring spring) {
    this.shape = shape;
    this.spring = spring;
  }

  /** Returns the motion that is always allowed in a frame, mm. */
  static double leastStepMm(HandState hand) {
    return LEAST_STEP_MM * FramePart.ofSeconds(hand.seconds);
  }

  @Override
  public void reset() {
    known = false;
  }

  @Override
  public void add(HandState hand, Vec3 forceNewton, Vec3 torqueNewtonMm) {
    Vec3 at = hand.device.translation;
    shape.nearest(at, nearest);
    if (known) {
      double mostMm = Math.max(leastStepMm(hand), 2 * at.sub(lastHand, offset).length());
      double stepMm = nearest.sub(anchor, offset).length();
      offset.mul(stepMm > mostMm ? mostMm / stepMm : 1, offset).add(anchor, anchor);
    } else {
      anchor.set(nearest);
    }
    lastHand.set(at);
    known = true;
    spring.pull(anchor.sub(at, offset), forceNewton);
  }
}
