package org.palpate.sync;

import org.palpate.geometry.Vec3;

/**
 * The result of a haptic frame as one value: device, interaction point, force, contact and number.
 * They are therefore always of the same frame. Starts as zeros.
 *
 * <p>It is one value instead of five, because these mostly change together. Comparing, writing and
 * counting them once takes the haptic thread two thirds of the time.
 */
public final class TouchProperty extends Property {
  private static final int DEVICE = 0;
  private static final int POINT = 3;
  private static final int FORCE = 6;
  private static final int CONTACT = 9;
  private static final int FRAME = 10;
  private static final int WORDS = 11;

  TouchProperty(Accumulator accumulator, String name, int index, int offset) {
    super(accumulator, name, index, offset, WORDS);
  }

  /**
   * Sets the result of a frame. Writer.
   *
   * @param device the device position, grid coordinates; copied
   * @param point the interaction point, grid coordinates; copied
   * @param force the written force along the grid's axes, N; copied
   * @param contact whether the frame ended in contact
   * @param frameNumber ignored if nothing else changed, so that a hand at rest causes no redraw
   */
  public void set(Vec3 device, Vec3 point, Vec3 force, boolean contact, long frameNumber) {
    putTouch(device, point, force, contact ? 1 : 0, frameNumber);
  }

  /**
   * Writes the device position that was last taken. Reader.
   *
   * @param dest receives the position, grid coordinates
   * @return {@code dest}
   */
  public Vec3 device(Vec3 dest) {
    return read(DEVICE, dest);
  }

  /**
   * Writes the interaction point that was last taken. Reader.
   *
   * @param dest receives the position, grid coordinates
   * @return {@code dest}
   */
  public Vec3 interactionPoint(Vec3 dest) {
    return read(POINT, dest);
  }

  /**
   * Writes the force that was last taken. Reader.
   *
   * @param dest receives the force along the grid's axes, N
   * @return {@code dest}
   */
  public Vec3 force(Vec3 dest) {
    return read(FORCE, dest);
  }

  /** {@return whether there was contact, as last taken} Reader. */
  public boolean contact() {
    return taken(CONTACT) != 0;
  }

  /** {@return the number of the last frame in which any of the others changed} Reader. */
  public long frame() {
    return taken(FRAME);
  }

  private Vec3 read(int word, Vec3 dest) {
    return dest.set(takenDouble(word), takenDouble(word + 1), takenDouble(word + 2));
  }
}
