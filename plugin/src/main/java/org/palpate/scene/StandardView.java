package org.palpate.scene;

import java.util.Locale;
import org.palpate.geometry.Vec3;

/**
 * Directions of view. In the scene's frame x points to the patient's left, y to the back and z to
 * the head.
 */
public enum StandardView {
  FRONT(0, -1, 0),
  BACK(0, 1, 0),
  LEFT(1, 0, 0),
  RIGHT(-1, 0, 0),
  HEAD(0, 0, 1),
  FOOT(0, 0, -1),
  /** From the front, the left and a little above. */
  OBLIQUE(0.55, -0.78, 0.3);

  private final double x;
  private final double y;
  private final double z;

  StandardView(double x, double y, double z) {
    this.x = x;
    this.y = y;
    this.z = z;
  }

  /** Returns the unit vector from the middle towards the eye. */
  public Vec3 towardsEye() {
    Vec3 direction = new Vec3(x, y, z);
    return direction.mul(1 / direction.length(), direction);
  }

  /**
   * Returns the direction that is up in the picture: the head, or the front if seen from head or
   * foot.
   */
  Vec3 up() {
    return Math.abs(z) > 0.9 ? new Vec3(0, -1, 0) : new Vec3(0, 0, 1);
  }

  /** Returns the name on the command line. */
  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }
}
