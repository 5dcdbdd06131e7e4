package org.palpate.imagej.stack;

import ij.ImagePlus;
import ij.process.ByteProcessor;
import ij.process.ImageProcessor;
import java.util.Locale;
import org.palpate.io.volume.LabelTable;

/**
 * Which values of a stack belong to a segment. Values are raw, as ImageJ keeps them.
 *
 * @param name of the segment
 * @param lower the least value that belongs to it
 * @param upper the largest
 * @param rgb colour for drawing, 0xRRGGBB
 */
public record SegmentRange(String name, double lower, double upper, int rgb) {
  private static final int LUT_SIZE = 256;

  public static SegmentRange threshold(
      String name, double lower, double upper, SegmentColour colour) {
    return new SegmentRange(name, lower, upper, colour.rgb());
  }

  /**
   * The segment of one value of a label image: in the colour in which a colour image shows it, else
   * in that of the table.
   *
   * @param table names and colours, as a file beside the image has them
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

  /** The same with the thresholds that an image shows; itself where it shows none. */
  SegmentRange withThresholdOf(ImagePlus image) {
    ImageProcessor shown = image.getProcessor();
    return shown == null || shown.getMinThreshold() == ImageProcessor.NO_THRESHOLD
        ? this
        : new SegmentRange(name, shown.getMinThreshold(), shown.getMaxThreshold(), rgb);
  }

  public boolean holds(float value) {
    return value >= lower && value <= upper;
  }
}
