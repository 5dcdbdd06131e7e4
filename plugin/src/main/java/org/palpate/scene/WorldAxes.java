package org.palpate.scene;

import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/**
 * Orientation of the world's axes in the patient, and the transform to the scene's frame. There x
 * points to the patient's left, y to the back and z to the head.
 */
public enum WorldAxes {
  /** Left, posterior, superior; as DICOM. */
  LPS(1, 1),
  /** Right, anterior, superior; as NIfTI. */
  RAS(-1, -1),
  /** Left, anterior, superior. */
  LAS(1, -1),
  /** Unknown; drawn like LPS, without letters. */
  UNKNOWN(1, 1);

  private static final String[] LETTERS = {"L", "R", "P", "A", "H", "F"};

  private final int signX;
  private final int signY;

  WorldAxes(int signX, int signY) {
    this.signX = signX;
    this.signY = signY;
  }

  /** Whether the letters of the patient's directions are drawn. */
  public boolean hasLetters() {
    return this != UNKNOWN;
  }

  /**
   * Returns the letter of a direction of the scene's frame: left, right, posterior, anterior, head,
   * foot.
   *
   * @param axis 0 is x, 1 is y, 2 is z
   */
  public static String letter(int axis, boolean positive) {
    return LETTERS[2 * axis + (positive ? 0 : 1)];
  }

  /**
   * Converts a point or direction from the world to the scene's frame, or back, into {@code dest}.
   * The conversion is its own inverse.
   */
  public Vec3 toSceneOrBack(Vec3 world, Vec3 dest) {
    return dest.set(signX * world.x, signY * world.y, world.z);
  }

  /** Returns a pose in the scene's frame. It mirrors if the world is left-handed. */
  RigidTransform toScene(RigidTransform toWorld) {
    return new RigidTransform(
        toSceneOrBack(toWorld.axisX(), new Vec3()),
        toSceneOrBack(toWorld.axisY(), new Vec3()),
        toSceneOrBack(toWorld.axisZ(), new Vec3()),
        toSceneOrBack(toWorld.origin(), new Vec3()));
  }
}
