package org.palpate.scene;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import org.palpate.geometry.Vec3;

/**
 * The slices of a live view, which keys switch and move: off, fixed, or through the interaction
 * point. Any thread.
 */
public final class MovableSlices {
  /** The positions of the slices. */
  public enum Mode {
    /** No slices. */
    OFF,
    /** Through a voxel that {@link #move} changes. */
    FIXED,
    /** Through the voxel of the interaction point. */
    AT_POINT;

    /** Returns the words of the overlay. */
    @Override
    public String toString() {
      return name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }
  }

  /**
   * The slices at the start.
   *
   * @param grey the grey values
   * @param mode position of the slices
   * @param i number of the fixed plane across x, -1 for none; j and k likewise
   */
  public record Start(GreySlices grey, Mode mode, int i, int j, int k) {}

  /** Ticks between two moves with the interaction point, because each move redraws the surfaces. */
  private static final int TICKS_PER_MOVE = 3;

  /** Number of key presses that move a plane across the whole volume. */
  private static final int KEY_STEPS_PER_AXIS = 128;

  private final SceneModel model;
  private final GreyWindow ownWindow;
  private GreySlices grey;
  private GreyWindow window;
  private final int[] fixed = new int[3];
  private final int[] shown = new int[3];
  private Mode mode;
  private int axis;
  private int ticks;

  /** Creates the slices of a model and shows them if they are fixed. */
  public MovableSlices(SceneModel model, Start start) {
    this.model = model;
    grey = start.grey;
    ownWindow = GreyWindow.of("own", grey);
    window = ownWindow;
    mode = start.mode;
    fixed[0] = start.i;
    fixed[1] = start.j;
    fixed[2] = start.k;
    if (mode == Mode.FIXED) {
      show(fixed);
    }
  }

  /** Switches to the next mode: off, fixed, at the point. */
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

  /** Shows the next window for Hounsfield units, or the volume's own contrast after the last. */
  public synchronized void nextWindow() {
    setWindow(GreyWindow.next(window, ownWindow));
  }

  /**
   * Changes window and level by a drag.
   *
   * @param right distance to the right in picture heights
   * @param up distance upwards in picture heights
   */
  public synchronized void dragWindow(double right, double up) {
    setWindow(window.dragged(right, up));
  }

  private void setWindow(GreyWindow next) {
    window = next;
    grey = grey.withContrast(next.black(), next.white());
    if (mode != Mode.OFF) {
      show(shown.clone());
    }
  }

  /** Selects the next axis for {@link #move}. */
  public synchronized void nextAxis() {
    axis = (axis + 1) % fixed.length;
  }

  /**
   * Moves the selected plane along its axis. Slices that followed the point become fixed.
   *
   * @param steps 1 towards the high end, -1 towards the low end
   */
  public synchronized void move(int steps) {
    if (mode == Mode.AT_POINT) {
      System.arraycopy(shown, 0, fixed, 0, fixed.length);
    }
    mode = Mode.FIXED;
    int step = steps * Math.max(1, grey.size(axis) / KEY_STEPS_PER_AXIS);
    fixed[axis] = clamp(axis, (double) fixed[axis] + step);
    show(fixed);
  }

  /** Moves the slices to the interaction point if they follow it. Call it once a tick. */
  public synchronized void follow(Vec3 pointGrid) {
    if (mode == Mode.AT_POINT && ticks++ % TICKS_PER_MOVE == 0) {
      int[] voxel = new int[3];
      for (int along = 0; along < voxel.length; along++) {
        voxel[along] = clamp(along, Math.floor(pointGrid.get(along)));
      }
      if (!Arrays.equals(voxel, shown) || model.state().look().slices().isEmpty()) {
        show(voxel);
      }
    }
  }

  private int clamp(int along, double position) {
    return (int) Math.max(0, Math.min(grey.size(along) - 1.0, position));
  }

  private void show(int[] voxel) {
    System.arraycopy(voxel, 0, shown, 0, shown.length);
    SlicePlanes planes = grey.through(voxel[0], voxel[1], voxel[2], model);
    model.changeLook(look -> look.with(Optional.of(planes)));
  }

  /**
   * Returns the overlay line: the position and the axis that the keys move; empty without slices.
   */
  public synchronized String line() {
    return mode == Mode.OFF
        ? ""
        : String.format(
            Locale.ROOT,
            "slices %s %d, %d, %d   keys move %s   %s",
            mode,
            shown[0],
            shown[1],
            shown[2],
            "xyz".charAt(axis),
            window);
  }
}
