package org.palpate.force.guide;

import org.palpate.force.HandState;
import org.palpate.force.HapticEffect;
import org.palpate.geometry.Vec3;

/**
 * Turns a rigid tool so that its axis z lies along a line, in the nearer of the two directions. The
 * pull grows with half the sine of twice the angle, so it is zero if both directions are equally
 * near. A point feels nothing.
 *
 * <p>Haptic thread; allocates nothing.
 */
public final class AlignGuide implements HapticEffect {
  private final Vec3 direction;
  private final GuideSpring turnSpring;
  private final Vec3 toolAxis = new Vec3();
  private final Vec3 rotation = new Vec3();

  /**
   * Creates a guide.
   *
   * @param direction the unit direction of the line
   * @param turnSpring the spring of rotations, with N mm and rad
   */
  public AlignGuide(Vec3 direction, GuideSpring turnSpring) {
    this.direction = direction;
    this.turnSpring = turnSpring;
  }

  @Override
  public void add(HandState hand, Vec3 forceNewton, Vec3 torqueNewtonMm) {
    if (!hand.isRigid) {
      return;
    }
    hand.device.rotation.rotate(toolAxis.set(0, 0, 1), toolAxis);
    double cosine = toolAxis.dot(direction);
    turnSpring.pull(toolAxis.cross(direction, rotation).mul(cosine, rotation), torqueNewtonMm);
  }
}
