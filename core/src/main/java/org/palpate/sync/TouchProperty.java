package org.palpate.sync;

import org.palpate.geometry.Vec3;

/**
 * What a haptic frame has to show, as one value: device, interaction point, force, contact and the
 * frame's number, so that they are always of the same frame. Starts as zeros.
 *
 * <p>One value instead of five, since what changes in a frame mostly changes together: compared,
 * written and counted once, that takes the haptic thread two thirds of the time.
 */
public final class TouchProperty extends Property {
  private static final int POINT = 3;
  private static final int FORCE = 6;
  private static final int CONTACT = 9;
  private static final int FRAME = 10;
  private static final int WORDS = 11;

  TouchProperty(Accumulator accumulator, String name, int index, int offset) {
    super(accumulator, name, index, offset, WORDS);
  }

  /**
   * Sets all. Writer.
   *
   * @param frameNumber kept as it was where nothing else changed, so that a resting hand causes no
   *     redraw
   */
  public void set(Vec3 device, Vec3 point, Vec3 force, boolean contact, long frameNumber) {
    putTouch(device, point, force, contact ? 1 : 0, frameNumber);
  }

  /** Where the device was, as last taken. Reader, as all that follow. */
  public Vec3 device(Vec3 dest) {
    return read(0, dest);
  }

  /** Where the interaction point was. */
  public Vec3 interactionPoint(Vec3 dest) {
    return read(POINT, dest);
  }

  /** The force on the hand. */
  public Vec3 force(Vec3 dest) {
    return read(FORCE, dest);
  }

  /** Whether there was contact. */
  public boolean contact() {
    return taken(CONTACT) != 0;
  }

  /** The number of the last frame in which any of the others changed. */
  public long frame() {
    return taken(FRAME);
  }

  private Vec3 read(int word, Vec3 dest) {
    return dest.set(takenDouble(word), takenDouble(word + 1), takenDouble(word + 2));
  }
}
