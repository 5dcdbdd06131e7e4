package org.palpate.scene;

import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/**
 * Which way the axes of the world point in the patient, and how the scene gets from there to its
 * own frame, in which x goes to the patient's left, y to the back and z to the head.
 */
public enum WorldAxes {
  LPS(1, 1),
  RAS(-1, -1),
  LAS(1, -1),
  /** Not known: shown as if it were LPS, without letters. */
  UNKNOWN(1, 1);

  private static final String[] LETTERS = {"L", "R", "P", "A", "H", "F"};

  private final int signX;
  private final int signY;

  WorldAxes(int signX, int signY) {
    this.signX = signX;
    this.signY = signY;
  }

  public boolean hasLetters() {
    return this != UNKNOWN;
  }

  /**
   * The letter of a direction of the scene's frame: left, right, posterior, anterior, head, foot.
   *
   * @param axis 0 is x, 1 is y, 2 is z
   */
  public static String letter(int axis, boolean positive) {
    return LETTERS[2 * axis + (positive ? 0 : 1)];
  }

  /** Writes a world point or direction in the scene's frame, or back, into {@code dest}. */
  public Vec3 swap(Vec3 world, Vec3 dest) {
    return dest.set(signX * world.x, signY * world.y, world.z);
  }

  /**
   * A pose in the world as a pose in the scene's frame; it mirrors where the world is left-handed.
   */
  public RigidTransform toScene(RigidTransform toWorld) {
    return new RigidTransform(
        swap(toWorld.axisX(), new Vec3()),
        swap(toWorld.axisY(), new Vec3()),
        swap(toWorld.axisZ(), new Vec3()),
        swap(toWorld.origin(), new Vec3()));
  }
}
