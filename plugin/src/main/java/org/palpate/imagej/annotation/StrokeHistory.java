package org.palpate.imagej.annotation;

import ij.Prefs;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;
import org.palpate.geometry.Vec3;
import org.palpate.imagej.stack.SegmentRange;
import org.palpate.imagej.stack.StackVolume;
import org.palpate.imagej.stack.TouchRefusedException;

/**
 * The brush strokes of a session, which can be undone and redone. It also learns who changes the
 * stack besides strokes, so that ImageJ's own undo comes in its turn. Any thread.
 */
public final class StrokeHistory {
  private static final int MAX_STROKES = 100;
  private static final String RADIUS_PREFERENCE = "palpate.brush";
  private static final double DEFAULT_RADIUS_MM = 2;

  private final StackVolume volume;
  private final Vec3 spacingMm;
  private final Deque<BrushStroke> done = new ArrayDeque<>();
  private final Deque<BrushStroke> undone = new ArrayDeque<>();

  /** The values that strokes have written and nobody has seen in the stack yet. */
  private final Map<Voxel, Float> written = new HashMap<>();

  /** The number of strokes that were done when something else changed the stack last. */
  private int covered;

  private record Voxel(int i, int j, int k) {}

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
    BrushStroke stroke = BrushStroke.ofBall(volume, centreGrid, spacingMm, radiusMm, value, range);
    stroke.redo(this::note);
    done.push(stroke);
    undone.clear();
    if (done.size() > MAX_STROKES) {
      done.removeLast();
      covered = Math.max(0, covered - 1);
    }
    return stroke.size();
  }

  private void note(int i, int j, int k, float value) {
    written.put(new Voxel(i, j, k), value);
  }

  /** Learns that a voxel of the stack has another value than when it was seen last. */
  public synchronized void seen(int i, int j, int k, float value) {
    Float own = written.remove(new Voxel(i, j, k));
    if (own == null || own != value) {
      covered = done.size();
    }
  }

  /** Whether a stroke was done after everything else that changed the stack, as far as seen. */
  public synchronized boolean isStrokeLast() {
    return done.size() > covered;
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
    covered = Math.min(covered, done.size());
    stroke.undo(this::note);
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
    stroke.redo(this::note);
    done.push(stroke);
    return stroke.size();
  }
}
