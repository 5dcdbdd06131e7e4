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
  private record Change(int i, int j, int k, float before, float after) {}

  private final StackVolume volume;
  private final List<Change> changes = new ArrayList<>();

  private BrushStroke(StackVolume volume) {
    this.volume = volume;
  }

  /**
   * Paints a ball into the stack.
   *
   * @param centreGrid centre of the ball, grid coordinates
   * @param spacingMm edge lengths of a voxel
   * @param value new value of the voxels
   * @param range the segment's values; only voxels change whose membership differs from that of
   *     {@code value}
   */
  static BrushStroke paint(
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
      stroke.paintSlice(k, centreGrid, spacingMm, radiusMm, value, range);
    }
    stroke.redo();
    return stroke;
  }

  private void paintSlice(
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
  void undo() {
    changes.forEach(change -> volume.slice(change.k).setf(change.i, change.j, change.before));
    volume.image().updateAndDraw();
  }

  /** Applies the new values. */
  void redo() {
    changes.forEach(change -> volume.slice(change.k).setf(change.i, change.j, change.after));
    volume.image().updateAndDraw();
  }
}
