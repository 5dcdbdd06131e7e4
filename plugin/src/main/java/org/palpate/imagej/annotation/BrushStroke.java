package org.palpate.imagej.annotation;

import ij.process.ImageProcessor;
import java.util.ArrayList;
import java.util.List;
import org.palpate.geometry.Vec3;
import org.palpate.imagej.stack.SegmentRange;
import org.palpate.imagej.stack.StackVolume;

/**
 * The voxels of a stack that a spherical brush changed, with their values before and after. A
 * stroke can be undone and redone.
 */
final class BrushStroke {
  /** Receives what a stroke writes. */
  @FunctionalInterface
  interface Sink {
    /** Receives the value that a voxel of the stack gets. */
    void written(int i, int j, int k, float value);
  }

  private record Change(int i, int j, int k, float before, float after) {}

  private final StackVolume volume;
  private final List<Change> changes = new ArrayList<>();

  private BrushStroke(StackVolume volume) {
    this.volume = volume;
  }

  /**
   * Finds the voxels of a ball that are to change. {@link #redo} paints them.
   *
   * @param centreGrid centre of the ball, grid coordinates
   * @param spacingMm edge lengths of a voxel
   * @param value new value of the voxels
   * @param range the segment's values; only voxels change whose membership differs from that of
   *     {@code value}
   */
  static BrushStroke ofBall(
      StackVolume volume,
      Vec3 centreGrid,
      Vec3 spacingMm,
      double radiusMm,
      float value,
      SegmentRange range) {
    BrushStroke stroke = new BrushStroke(volume);
    int lowK = low(centreGrid.z, radiusMm / spacingMm.z);
    int highK = high(centreGrid.z, radiusMm / spacingMm.z, volume.slices());
    for (int k = lowK; k <= highK; k++) {
      stroke.findInSlice(k, centreGrid, spacingMm, radiusMm, value, range);
    }
    return stroke;
  }

  private void findInSlice(
      int k, Vec3 centre, Vec3 spacing, double radiusMm, float value, SegmentRange range) {
    ImageProcessor slice = volume.slice(k);
    int highJ = high(centre.y, radiusMm / spacing.y, volume.height());
    int highI = high(centre.x, radiusMm / spacing.x, volume.width());
    for (int j = low(centre.y, radiusMm / spacing.y); j <= highJ; j++) {
      for (int i = low(centre.x, radiusMm / spacing.x); i <= highI; i++) {
        float before = slice.getf(i, j);
        boolean inside = isInside(i, j, k, centre, spacing, radiusMm);
        if (inside && range.contains(before) != range.contains(value)) {
          changes.add(new Change(i, j, k, before, value));
        }
      }
    }
  }

  private static boolean isInside(int i, int j, int k, Vec3 centre, Vec3 spacing, double radiusMm) {
    double x = (i + 0.5 - centre.x) * spacing.x;
    double y = (j + 0.5 - centre.y) * spacing.y;
    double z = (k + 0.5 - centre.z) * spacing.z;
    return x * x + y * y + z * z <= radiusMm * radiusMm;
  }

  private static int low(double centre, double radius) {
    return (int) Math.max(0, Math.floor(centre - radius));
  }

  private static int high(double centre, double radius, int size) {
    return (int) Math.min(size - 1.0, Math.floor(centre + radius));
  }

  /** Returns the number of changed voxels. */
  int size() {
    return changes.size();
  }

  /** Restores the values from before the stroke. */
  void undo(Sink out) {
    changes.forEach(change -> write(change, change.before, out));
    volume.image().updateAndDraw();
  }

  /** Applies the new values. */
  void redo(Sink out) {
    changes.forEach(change -> write(change, change.after, out));
    volume.image().updateAndDraw();
  }

  private void write(Change change, float value, Sink out) {
    out.written(change.i, change.j, change.k, value);
    volume.slice(change.k).setf(change.i, change.j, value);
  }
}
