package org.palpate.imagej;

import ij.ImagePlus;
import ij.process.ByteProcessor;
import ij.process.ImageProcessor;
import java.util.Locale;

/**
 * Which values of a stack belong to a segment. Values are raw, as ImageJ keeps them.
 *
 * @param name of the segment
 * @param lower the least value that belongs to it
 * @param upper the largest
 * @param rgb colour for drawing, 0xRRGGBB
 */
record VoxelRule(String name, double lower, double upper, int rgb) {
  /**
   * Colours that colour-blind people can tell apart. Source: M. Okabe and K. Ito, Color universal
   * design, 2008.
   */
  private static final int[] PALETTE = {
    0xE6C99F, 0x56B4E9, 0xE69F00, 0x009E73, 0xCC79A7, 0xF0E442, 0x0072B2, 0xD55E00
  };

  private static final int LUT_SIZE = 256;

  static VoxelRule threshold(String name, double lower, double upper) {
    return new VoxelRule(name, lower, upper, PALETTE[0]);
  }

  /** The segment of one value of a label image, in the colour in which a colour image shows it. */
  static VoxelRule label(int value, ImagePlus image) {
    ImageProcessor shown = image.getProcessor();
    boolean coloured = shown instanceof ByteProcessor && shown.isColorLut() && value < LUT_SIZE;
    int rgb =
        coloured ? shown.getColorModel().getRGB(value) & 0xFFFFFF : PALETTE[value % PALETTE.length];
    return new VoxelRule(String.format(Locale.ROOT, "label %d", value), value, value, rgb);
  }

  /** The same with the thresholds that an image shows; itself where it shows none. */
  VoxelRule withThresholdOf(ImagePlus image) {
    ImageProcessor shown = image.getProcessor();
    return shown == null || shown.getMinThreshold() == ImageProcessor.NO_THRESHOLD
        ? this
        : new VoxelRule(name, shown.getMinThreshold(), shown.getMaxThreshold(), rgb);
  }

  boolean holds(float value) {
    return value >= lower && value <= upper;
  }
}
