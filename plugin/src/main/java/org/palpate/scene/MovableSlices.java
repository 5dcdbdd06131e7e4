package org.palpate.scene;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import org.palpate.geometry.Vec3;

/**
 * The slices of a live view, which keys switch and move: none, at a place of their own, or through
 * the interaction point. Any thread.
 */
public final class MovableSlices {
  /** Where the slices are. */
  public enum Mode {
    OFF,
    /** Through a voxel that {@link #move} changes. */
    FIXED,
    /** Through the voxel of the interaction point. */
    AT_POINT;

    /** As a person reads it. */
    @Override
    public String toString() {
      return name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }
  }

  /**
   * What is shown at first.
   *
   * @param i the plane across x where they are fixed, a voxel number; -1 for none; likewise j, k
   */
  public record Start(GreySlices grey, Mode mode, int i, int j, int k) {}

  /** One in so many ticks of the 30 Hz follows the point: each makes the surfaces be drawn anew. */
  private static final int TICKS_PER_MOVE = 3;

  /** A press of a key moves a plane by one in so many of the voxels along it. */
  private static final int KEY_STEPS_PER_AXIS = 128;

  private final SceneModel model;
  private final GreySlices grey;
  private final int[] fixed = new int[3];
  private final int[] shown = new int[3];
  private Mode mode;
  private int axis;
  private int ticks;

  /** Slices of a model, shown at once where they are fixed. */
  public MovableSlices(SceneModel model, Start start) {
    this.model = model;
    grey = start.grey;
    mode = start.mode;
    fixed[0] = start.i;
    fixed[1] = start.j;
    fixed[2] = start.k;
    if (mode == Mode.FIXED) {
      show(fixed);
    }
  }

  /** The next of: none, fixed, at the point. */
  public synchronized void nextMode() {
    mode =
        switch (mode) {
          case OFF -> Mode.FIXED;
          case FIXED -> Mode.AT_POINT;
          case AT_POINT -> Mode.OFF;
        };
    ticks = 0;
    if (mode == Mode.FIXED) {
      show(fixed);
    } else if (mode == Mode.OFF) {
      model.changeLook(look -> look.with(Optional.<SlicePlanes>empty()));
    }
  }

  /** Chooses the next axis for {@link #move}. */
  public synchronized void nextAxis() {
    axis = (axis + 1) % fixed.length;
  }

  /**
   * Moves the chosen plane along its axis; slices that were elsewhere come to stand still.
   *
   * @param steps 1 towards the high end, -1 towards the low one
   */
  public synchronized void move(int steps) {
    if (mode == Mode.AT_POINT) {
      System.arraycopy(shown, 0, fixed, 0, fixed.length);
    }
    mode = Mode.FIXED;
    int step = steps * Math.max(1, grey.size(axis) / KEY_STEPS_PER_AXIS);
    fixed[axis] = within(axis, (double) fixed[axis] + step);
    show(fixed);
  }

  /** Lets the slices follow the point where they do; once a tick. */
  public synchronized void follow(Vec3 pointGrid) {
    if (mode == Mode.AT_POINT && ticks++ % TICKS_PER_MOVE == 0) {
      int[] voxel = new int[3];
      for (int along = 0; along < voxel.length; along++) {
        voxel[along] = within(along, Math.floor(pointGrid.get(along)));
      }
      if (!Arrays.equals(voxel, shown) || model.state().look().slices().isEmpty()) {
        show(voxel);
      }
    }
  }

  private int within(int along, double place) {
    return (int) Math.max(0, Math.min(grey.size(along) - 1.0, place));
  }

  private void show(int[] voxel) {
    System.arraycopy(voxel, 0, shown, 0, shown.length);
    SlicePlanes planes = grey.through(voxel[0], voxel[1], voxel[2], model);
    model.changeLook(look -> look.with(Optional.of(planes)));
  }

  /** Where they are and which plane the keys move, for the overlay; empty where there are none. */
  public synchronized String line() {
    return mode == Mode.OFF
        ? ""
        : String.format(
            Locale.ROOT,
            "slices %s %d, %d, %d   keys move %s",
            mode,
            shown[0],
            shown[1],
            shown[2],
            "xyz".charAt(axis));
  }
}
