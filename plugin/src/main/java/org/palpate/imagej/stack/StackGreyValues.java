package org.palpate.imagej.stack;

import java.util.List;
import java.util.Optional;
import org.palpate.host.ContactScene;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;

/**
 * The grey values that the solver smooth goes by, kept as the stack has them. One thread, that
 * which carries over.
 */
public final class StackGreyValues {
  /** Where more of the voxels than this changed the contrast is measured anew. */
  private static final double CONTRAST_UPDATE_FRACTION = 0.01;

  private final ContactScene scene;
  private final PixelSnapshot pixels;
  private boolean waits;

  /** Over a scene that was made of {@link #surface}. */
  StackGreyValues(ContactScene scene, PixelSnapshot pixels) {
    this.scene = scene;
    this.pixels = pixels;
  }

  /**
   * The surface of the one segment, where a threshold made it of grey values: no value lies above
   * the upper end, some lie below the lower one, and there are more than two of them, so that it is
   * no mask. Two passes over the pixels.
   */
  public static Optional<GreyIsosurface> surface(
      PixelSnapshot pixels, int slices, VoxelGrid grid, List<SegmentRange> rules) {
    if (rules.size() != 1 || !isThreshold(pixels, slices, rules.get(0))) {
      return Optional.empty();
    }
    return Optional.of(GreyIsosurface.ofThreshold(pixels.values(grid), rules.get(0).lower()));
  }

  private static boolean isThreshold(PixelSnapshot pixels, int slices, SegmentRange rule) {
    Values values = new Values();
    for (int k = 0; k < slices; k++) {
      values.add(pixels.slice(k));
    }
    return values.several && values.least < rule.lower() && values.largest <= rule.upper();
  }

  /** What values there are. */
  private static final class Values {
    private float least = Float.POSITIVE_INFINITY;
    private float largest = Float.NEGATIVE_INFINITY;
    private boolean several;

    private void add(Object slice) {
      float last = Float.NaN;
      for (int n = 0; n < StackVolume.pixelCount(slice); n++) {
        float value = StackVolume.value(slice, n);
        if (value != last) {
          last = value;
          several |= (least < value && value < largest) || widens(value);
          least = Math.min(least, value);
          largest = Math.max(largest, value);
        }
      }
    }

    /** Whether there were two values, and this is a third beyond them. */
    private boolean widens(float value) {
      return least < largest && (value < least || value > largest);
    }
  }

  /**
   * Hands the values over as they are in the copy by now.
   *
   * @param rule what makes the segment by now
   * @param changed how many of all voxels have other values
   * @param all voxels
   */
  void carryOver(SegmentRange rule, long changed, long all) {
    Optional<GreyIsosurface> before = scene.grey();
    if (before.isEmpty()) {
      return;
    }
    boolean moved = rule.lower() != before.get().threshold();
    if (changed > 0 || moved || waits) {
      boolean measure = moved || changed > CONTRAST_UPDATE_FRACTION * all;
      waits = !scene.offerGrey(fresh(before.get(), rule.lower(), measure));
    }
  }

  /** Whether the queue of edits was full, so that the values go the next time. */
  boolean waits() {
    return waits;
  }

  private GreyIsosurface fresh(GreyIsosurface before, double threshold, boolean measure) {
    ScalarVolume values = pixels.values(before.volume().grid());
    return measure
        ? GreyIsosurface.ofThreshold(values, threshold)
        : new GreyIsosurface(values, threshold, before.contrast());
  }
}
