package org.palpate.elastic;

import org.palpate.elastic.lattice.LatticeLayout;
import org.palpate.geometry.Vec3;

/**
 * Forecasts where a sliding contact is when the field that is computed for it is replaced by the
 * next one: two periods of the updates later. So the contact stays between the places of the last
 * two fields, which are blended.
 *
 * <p>Haptic thread; allocates nothing after construction.
 */
final class SlideForecast {
  /** The frames of a millisecond by which the forecast is ahead. */
  private static final int AHEAD_FRAMES = 2 * SynchronousUpdates.FRAMES;

  /** The frames of a millisecond over which the motion is averaged. */
  private static final int MEAN_FRAMES = 16;

  /** The longest distance ahead, shortest cells. */
  private static final double MOST_CELLS = 1;

  private final LatticeLayout layout;
  private final Vec3 last = new Vec3();
  private final Vec3 difference = new Vec3();

  /** The mean motion in a frame, grid coordinates. */
  private final Vec3 motion = new Vec3();

  private double aheadFrames = AHEAD_FRAMES;
  private double newPart = 1.0 / MEAN_FRAMES;
  private boolean pressed;

  SlideForecast(LatticeLayout layout) {
    this.layout = layout;
  }

  /** Sets the length of a frame, ms; more than a millisecond counts as one. */
  void paced(double frameMs) {
    aheadFrames = ElasticContact.frames(AHEAD_FRAMES, frameMs);
    newPart = 1.0 / ElasticContact.frames(MEAN_FRAMES, frameMs);
  }

  /** Forgets the motion, because the point was placed anew. */
  void restart() {
    pressed = false;
  }

  /**
   * Takes the point after a frame and writes the forecast, which is the point itself if nothing is
   * pressed.
   *
   * @param position material coordinates, as {@code dest}
   */
  void follow(Vec3 position, boolean isPressed, Vec3 dest) {
    if (pressed && isPressed) {
      position.sub(last, difference);
      difference.sub(motion, difference);
      difference.mul(newPart, difference);
      motion.add(difference, motion);
    } else {
      motion.set(0, 0, 0);
    }
    pressed = isPressed;
    last.set(position);
    motion.mul(aheadFrames, dest);
    double cells = cells(dest);
    dest.mul(cells > MOST_CELLS ? MOST_CELLS / cells : 1, dest);
    dest.add(position, dest);
  }

  private double cells(Vec3 grid) {
    double squared = 0;
    for (int axis = 0; axis < 3; axis++) {
      double cells = grid.get(axis) / layout.voxelsPerCell(axis);
      squared += cells * cells;
    }
    return Math.sqrt(squared);
  }
}
