package org.palpate.imagej.stack;

import java.util.List;
import java.util.Optional;
import org.palpate.host.ContactScene;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;

/**
 * Keeps the grey values of the smooth solver equal to the stack's. One thread: the one that applies
 * changes.
 */
public final class StackGreyValues {
  /** Fraction of changed voxels above which the contrast is measured again. */
  private static final double CONTRAST_UPDATE_FRACTION = 0.01;

  private final ContactScene scene;
  private final PixelSnapshot pixels;
  private boolean isPending;

  /** Creates a keeper for a scene that was built with {@link #surface}. */
  StackGreyValues(ContactScene scene, PixelSnapshot pixels) {
    this.scene = scene;
    this.pixels = pixels;
  }

  /**
   * Returns the isosurface of the one segment if a threshold of grey values makes it.
   *
   * <p>This holds if no value is above the upper end, some are below the lower end, and there are
   * more than two values, so that the stack is not a mask. Two passes over the pixels.
   */
  public static Optional<GreyIsosurface> surface(
      PixelSnapshot pixels, int slices, VoxelGrid grid, List<SegmentRange> ranges) {
    if (ranges.size() != 1 || !isThreshold(pixels, slices, ranges.get(0))) {
      return Optional.empty();
    }
    return Optional.of(GreyIsosurface.ofThreshold(pixels.values(grid), ranges.get(0).lower()));
  }

  private static boolean isThreshold(PixelSnapshot pixels, int slices, SegmentRange range) {
    Values values = new Values();
    for (int k = 0; k < slices; k++) {
      values.add(pixels.slice(k));
    }
    return values.moreThanTwo && values.smallest < range.lower() && values.largest <= range.upper();
  }

  /** The values that occur. */
  private static final class Values {
    private float smallest = Float.POSITIVE_INFINITY;
    private float largest = Float.NEGATIVE_INFINITY;
    private boolean moreThanTwo;

    private void add(Object slice) {
      float last = Float.NaN;
      for (int n = 0; n < StackVolume.pixelCount(slice); n++) {
        float value = StackVolume.value(slice, n);
        if (value != last) {
          last = value;
          moreThanTwo |= (smallest < value && value < largest) || widens(value);
          smallest = Math.min(smallest, value);
          largest = Math.max(largest, value);
        }
      }
    }

    /** Whether two values are known and this is a third outside them. */
    private boolean widens(float value) {
      return smallest < largest && (value < smallest || value > largest);
    }
  }

  /**
   * Queues the values of the copy if they or the threshold changed.
   *
   * @param range the present values of the segment
   * @param changed number of voxels whose value changed
   * @param all number of all voxels
   */
  void applyChanges(SegmentRange range, long changed, long all) {
    Optional<GreyIsosurface> before = scene.grey();
    if (before.isEmpty()) {
      return;
    }
    boolean moved = range.lower() != before.get().threshold();
    if (changed > 0 || moved || isPending) {
      boolean measure = moved || changed > CONTRAST_UPDATE_FRACTION * all;
      isPending = !scene.offerGrey(updated(before.get(), range.lower(), measure));
    }
  }

  /** Whether the queue of edits was full, so that the values must be queued again. */
  boolean isPending() {
    return isPending;
  }

  private GreyIsosurface updated(GreyIsosurface before, double threshold, boolean measure) {
    ScalarVolume values = pixels.values(before.volume().grid());
    return measure
        ? GreyIsosurface.ofThreshold(values, threshold)
        : new GreyIsosurface(values, threshold, before.contrast());
  }
}
