package org.palpate.imagej.annotation;

import ij.Prefs;
import java.util.ArrayDeque;
import java.util.Deque;
import org.palpate.geometry.Vec3;
import org.palpate.imagej.stack.SegmentRange;
import org.palpate.imagej.stack.StackVolume;
import org.palpate.imagej.stack.TouchRefusedException;

/** The brush strokes of a session, which can be undone and redone. Any thread. */
public final class StrokeHistory {
  private static final int MAX_STROKES = 100;
  private static final String RADIUS_PREFERENCE = "palpate.brush";
  private static final double DEFAULT_RADIUS_MM = 2;

  private final StackVolume volume;
  private final Vec3 spacingMm;
  private final Deque<BrushStroke> done = new ArrayDeque<>();
  private final Deque<BrushStroke> undone = new ArrayDeque<>();

  /**
   * Creates an empty history for a stack.
   *
   * @param spacingMm edge lengths of a voxel
   */
  public StrokeHistory(StackVolume volume, Vec3 spacingMm) {
    this.volume = volume;
    this.spacingMm = spacingMm;
  }

  /** Returns the brush radius that the user chose last, mm. */
  public static double lastRadiusMm() {
    return Prefs.get(RADIUS_PREFERENCE, DEFAULT_RADIUS_MM);
  }

  /** Stores the brush radius in ImageJ's preferences, mm. */
  public static void keepRadiusMm(double radiusMm) {
    Prefs.set(RADIUS_PREFERENCE, radiusMm);
  }

  /**
   * Adds a ball to a segment, or removes it.
   *
   * @param centreGrid centre of the ball, grid coordinates
   * @param range values of the segment
   * @return the number of changed voxels
   * @throws TouchRefusedException if there is no value outside the segment to remove voxels with
   */
  public synchronized int paint(Vec3 centreGrid, double radiusMm, SegmentRange range, boolean add)
      throws TouchRefusedException {
    float value = (float) (add ? range.lower() : outside(range));
    BrushStroke stroke = BrushStroke.paint(volume, centreGrid, spacingMm, radiusMm, value, range);
    done.push(stroke);
    undone.clear();
    if (done.size() > MAX_STROKES) {
      done.removeLast();
    }
    return stroke.size();
  }

  /** Returns a value outside the segment: the background 0 if possible. */
  private static double outside(SegmentRange range) throws TouchRefusedException {
    if (!range.contains(0)) {
      return 0;
    }
    if (range.upper() < 255) {
      return range.upper() + 1;
    }
    throw new TouchRefusedException(
        "The segment contains every value from 0 to 255: no value is left to remove voxels with.");
  }

  /**
   * Undoes the last stroke.
   *
   * @return the number of changed voxels
   * @throws TouchRefusedException if there is none
   */
  public synchronized int undo() throws TouchRefusedException {
    if (done.isEmpty()) {
      throw new TouchRefusedException("There is nothing to undo.");
    }
    BrushStroke stroke = done.pop();
    stroke.undo();
    undone.push(stroke);
    return stroke.size();
  }

  /**
   * Redoes the stroke that was undone last.
   *
   * @return the number of changed voxels
   * @throws TouchRefusedException if there is none
   */
  public synchronized int redo() throws TouchRefusedException {
    if (undone.isEmpty()) {
      throw new TouchRefusedException("There is nothing to redo.");
    }
    BrushStroke stroke = undone.pop();
    stroke.redo();
    done.push(stroke);
    return stroke.size();
  }
}
