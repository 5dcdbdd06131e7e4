package org.palpate.imagej;

import java.util.ArrayDeque;
import java.util.Deque;
import org.palpate.geometry.Vec3;

/** The brush strokes of a session, to be undone and done again. Any thread. */
final class StrokeHistory {
  private static final int KEPT_STROKES = 100;

  private final StackVolume volume;
  private final Vec3 spacingMm;
  private final Deque<BrushStroke> done = new ArrayDeque<>();
  private final Deque<BrushStroke> undone = new ArrayDeque<>();

  StrokeHistory(StackVolume volume, Vec3 spacingMm) {
    this.volume = volume;
    this.spacingMm = spacingMm;
  }

  /**
   * Adds a ball to a segment, or takes it away.
   *
   * @param centreGrid grid coordinates
   * @return the voxels that changed
   * @throws StackRefused where there is no value to take voxels away with
   */
  synchronized int paint(Vec3 centreGrid, double radiusMm, VoxelRule rule, boolean add)
      throws StackRefused {
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
  private static double outside(VoxelRule rule) throws StackRefused {
    if (!rule.holds(0)) {
      return 0;
    }
    if (rule.upper() < 255) {
      return rule.upper() + 1;
    }
    throw new StackRefused(
        "The segment holds the value 0 too: there is no value to remove voxels with.");
  }

  /**
   * Undoes the last stroke; the voxels that changed.
   *
   * @throws StackRefused where there is none
   */
  synchronized int undo() throws StackRefused {
    if (done.isEmpty()) {
      throw new StackRefused("There is nothing to undo.");
    }
    BrushStroke stroke = done.pop();
    stroke.undo();
    undone.push(stroke);
    return stroke.size();
  }

  /**
   * Does again what was undone last; the voxels that changed.
   *
   * @throws StackRefused where there is nothing
   */
  synchronized int redo() throws StackRefused {
    if (undone.isEmpty()) {
      throw new StackRefused("There is nothing to redo.");
    }
    BrushStroke stroke = undone.pop();
    stroke.redo();
    done.push(stroke);
    return stroke.size();
  }
}
