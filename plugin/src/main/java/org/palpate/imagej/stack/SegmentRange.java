package org.palpate.imagej.stack;

import ij.ImagePlus;
import ij.process.ByteProcessor;
import ij.process.ImageProcessor;
import java.util.Locale;
import org.palpate.io.volume.LabelTable;

/**
 * The range of values of a stack that belong to a segment. Values are raw, as ImageJ stores them.
 *
 * @param name name of the segment
 * @param lower the smallest value of the segment
 * @param upper the largest value of the segment
 * @param rgb colour for drawing, 0xRRGGBB
 */
public record SegmentRange(String name, double lower, double upper, int rgb) {
  private static final int LUT_SIZE = 256;

  /** Returns the range between two thresholds, which belong to it. */
  public static SegmentRange threshold(
      String name, double lower, double upper, SegmentColour colour) {
    return new SegmentRange(name, lower, upper, colour.rgb());
  }

  /**
   * Returns the segment of one value of a label image. Its colour is the one that a colour image
   * shows, otherwise that of the table.
   *
   * @param table names and colours from a file beside the image
   */
  public static SegmentRange label(int value, ImagePlus image, LabelTable table) {
    ImageProcessor shown = image.getProcessor();
    LabelTable.Label known = table.labels().get((long) value);
    boolean coloured = shown instanceof ByteProcessor && shown.isColorLut() && value < LUT_SIZE;
    int other = known == null ? SegmentColour.byNumber(value).rgb() : known.rgb();
    int rgb = coloured ? shown.getColorModel().getRGB(value) & 0xFFFFFF : other;
    boolean named = known != null && !known.name().isBlank();
    String name = named ? known.name() : String.format(Locale.ROOT, "label %d", value);
    return new SegmentRange(name, value, value, rgb);
  }

  /** Returns a copy with the thresholds that an image shows; this range if it shows none. */
  SegmentRange withThresholdOf(ImagePlus image) {
    ImageProcessor shown = image.getProcessor();
    return shown == null || shown.getMinThreshold() == ImageProcessor.NO_THRESHOLD
        ? this
        : new SegmentRange(name, shown.getMinThreshold(), shown.getMaxThreshold(), rgb);
  }

  /** Whether a value belongs to the segment. */
  public boolean contains(float value) {
    return value >= lower && value <= upper;
  }
}
