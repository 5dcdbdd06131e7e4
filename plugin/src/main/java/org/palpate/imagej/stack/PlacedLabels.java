package org.palpate.imagej.stack;

import ij.ImagePlus;
import ij.ImageStack;
import ij.process.ImageProcessor;
import java.util.List;
import org.palpate.volume.BitCube;
import org.palpate.volume.SegmentedVolume;

/** Makes a label stack of fragments where they were placed. */
public final class PlacedLabels {
  private PlacedLabels() {}

  /**
   * Returns a stack of the same type, calibration and colours as another one, with other voxels.
   *
   * @param stack the label stack from which the fragments come; not changed
   * @param ranges the label of each fragment
   * @param placed the voxels of each fragment, of the size of the stack
   */
  public static ImagePlus of(StackVolume stack, List<SegmentRange> ranges, SegmentedVolume placed) {
    ImagePlus image = stack.image();
    ImageStack slices = new ImageStack(stack.width(), stack.height());
    for (int k = 0; k < stack.slices(); k++) {
      ImageProcessor slice = stack.slice(k).createProcessor(stack.width(), stack.height());
      for (int n = 0; n < ranges.size(); n++) {
        fill(slice, placed.segments().get(n).bits(), k, (float) ranges.get(n).lower());
      }
      slices.addSlice(slice);
    }
    ImagePlus result = new ImagePlus("placed-" + image.getTitle(), slices);
    result.setDimensions(1, stack.slices(), 1);
    result.setCalibration(image.getCalibration());
    result.setLut(image.getProcessor().getLut());
    result.setDisplayRange(image.getDisplayRangeMin(), image.getDisplayRangeMax());
    result.setProperty(StackVolume.LABELS, stack.labelTable());
    return result;
  }

  private static void fill(ImageProcessor slice, BitCube bits, int k, float label) {
    for (int j = 0; j < bits.sizeY(); j++) {
      for (int i = 0; i < bits.sizeX(); i++) {
        if (bits.get(i, j, k)) {
          slice.setf(i, j, label);
        }
      }
    }
  }
}
