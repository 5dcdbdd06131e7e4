package org.palpate.imagej.annotation;

import ij.Prefs;
import java.util.ArrayDeque;
import java.util.Deque;
import org.palpate.geometry.Vec3;
import org.palpate.imagej.stack.SegmentRange;
import org.palpate.imagej.stack.StackVolume;
import org.palpate.imagej.stack.TouchRefusedException;

/** The brush strokes of a session, to be undone and done again. Any thread. */
public final class StrokeHistory {
  private static final int KEPT_STROKES = 100;
  private static final String RADIUS_PREFERENCE = "palpate.brush";
  private static final double DEFAULT_RADIUS_MM = 2;

  private final StackVolume volume;
  private final Vec3 spacingMm;
  private final Deque<BrushStroke> done = new ArrayDeque<>();
  private final Deque<BrushStroke> undone = new ArrayDeque<>();

  public StrokeHistory(StackVolume volume, Vec3 spacingMm) {
    this.volume = volume;
    this.spacingMm = spacingMm;
  }

  /** Returns the brush radius that the user chose last, mm. */
  public static double lastRadiusMm() {
    return Prefs.get(RADIUS_PREFERENCE, DEFAULT_RADIUS_MM);
  }

  /** Keeps the brush radius in ImageJ's preferences, mm. */
  public static void keepRadiusMm(double radiusMm) {
    Prefs.set(RADIUS_PREFERENCE, radiusMm);
  }

  /**
   * Adds a ball to a segment, or takes it away.
   *
   * @param centreGrid grid coordinates
   * @return the voxels that changed
   * @throws TouchRefusedException where there is no value to take voxels away with
   */
  public synchronized int paint(Vec3 centreGrid, double radiusMm, SegmentRange rule, boolean add)
      throws TouchRefusedException {
    float value = (float) (add ? rule.lower() : outside(rule));
    BrushStroke stroke = BrushStroke.paint(volume, centreGrid, spacingMm, radiusMm, value, rule);
    done.push(stroke);
    undone.clear();
    if (done.size() > KEPT_STROKES) {
      done.removeLast();
    }
    return stroke.size();
  }

  /** A value that does not belong to the segment: background where that does not. */
  private static double outside(SegmentRange rule) throws TouchRefusedException {
    if (!rule.holds(0)) {
      return 0;
    }
    if (rule.upper() < 255) {
      return rule.upper() + 1;
    }
    throw new TouchRefusedException(
        "The segment holds the value 0 too: there is no value to remove voxels with.");
  }

  /**
   * Undoes the last stroke; the voxels that changed.
   *
   * @throws TouchRefusedException where there is none
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
   * Does again what was undone last; the voxels that changed.
   *
   * @throws TouchRefusedException where there is nothing
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
