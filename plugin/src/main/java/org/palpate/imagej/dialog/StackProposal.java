package org.palpate.imagej.dialog;

import ij.Prefs;
import ij.measure.Calibration;
import ij.process.ImageProcessor;
import java.util.Arrays;
import java.util.List;
import org.palpate.imagej.stack.StackVolume;
import org.palpate.io.label.SegmentProposal;
import org.palpate.io.label.ValueStatistics;

/**
 * The range of values that the dialog proposes for an image without a threshold, calibrated as
 * ImageJ shows it.
 *
 * @param lower the smallest value
 * @param upper the largest value
 * @param reason a sentence for the user; empty if the values of the last dialog are proposed
 */
record StackProposal(double lower, double upper, String reason) {
  private static final String PREFIX = "palpate.";
  private static final double DEFAULT_UPPER = 65535;

  /** Largest number of slices in the sample; the next one is that of pixels in a slice. */
  private static final int MAX_SLICES = 32;

  private static final int MAX_PIXELS = 16384;

  /**
   * Returns a proposal for a stack.
   *
   * @param fromMacro whether a macro gives the values, so that the image need not be sampled
   */
  static StackProposal of(StackVolume volume, boolean fromMacro) {
    StackProposal last =
        new StackProposal(
            Prefs.get(PREFIX + "lower", 1), Prefs.get(PREFIX + "upper", DEFAULT_UPPER), "");
    if (fromMacro) {
      return last;
    }
    ValueStatistics.Summary found = ValueStatistics.ofSample(sample(volume));
    List<SegmentProposal> proposals = SegmentProposal.of(found);
    if (proposals.isEmpty() || !found.labels().isEmpty()) {
      return last;
    }
    SegmentProposal bone = proposals.get(0);
    return new StackProposal(
        bone.atLeast(),
        Math.max(Math.max(found.high(), bone.atLeast()), largest(volume)),
        "Proposed: " + bone.name() + ", because " + SegmentProposal.reason(found) + ".");
  }

  /** Returns the largest calibrated value of the pixel type; 0 for float. */
  private static double largest(StackVolume volume) {
    Calibration calibration = volume.image().getCalibration();
    return switch (volume.image().getBitDepth()) {
      case 8 -> calibration.getCValue(255);
      case 16 -> calibration.getCValue(65535);
      default -> 0;
    };
  }

  private static double[] sample(StackVolume volume) {
    Calibration calibration = volume.image().getCalibration();
    double[] values = new double[MAX_SLICES * MAX_PIXELS];
    int count = 0;
    int slices = volume.slices();
    for (int n = 0; n < Math.min(slices, MAX_SLICES); n++) {
      ImageProcessor slice = volume.slice((int) ((long) n * slices / Math.min(slices, MAX_SLICES)));
      int pixels = slice.getPixelCount();
      int taken = Math.min(pixels, MAX_PIXELS);
      for (int p = 0; p < taken; p++) {
        float raw = slice.getf((int) ((long) p * pixels / taken));
        values[count++] = calibration.getCValue(raw);
      }
    }
    return Arrays.copyOf(values, count);
  }
}
