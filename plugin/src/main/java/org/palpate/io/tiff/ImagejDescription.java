package org.palpate.io.tiff;

import java.util.HashMap;
import java.util.Map;
import org.palpate.io.file.NumberParser;
import org.palpate.io.format.Scaling;

/** The description that ImageJ writes into a TIFF, as {@code key=value} lines. */
final class ImagejDescription {
  private final Map<String, String> values = new HashMap<>();
  private final boolean isImagej;

  private ImagejDescription(String text) {
    isImagej = text.startsWith("ImageJ=");
    if (isImagej) {
      text.lines()
          .filter(line -> line.indexOf('=') > 0)
          .forEach(
              line ->
                  values.put(
                      line.substring(0, line.indexOf('=')),
                      line.substring(line.indexOf('=') + 1).strip()));
    }
  }

  /** Parses a description; one that is not from ImageJ has no values. */
  static ImagejDescription of(String text) {
    return new ImagejDescription(text);
  }

  /** Whether ImageJ wrote the description. */
  boolean isImagej() {
    return isImagej;
  }

  /** Returns the number of images, at least 1. */
  int images() {
    return Math.max(1, NumberParser.positiveInt(values.getOrDefault("images", "1")));
  }

  /** Returns the number of channels, at least 1. */
  int channels() {
    return Math.max(
        1, Math.min(1 << 15, NumberParser.positiveInt(values.getOrDefault("channels", "1"))));
  }

  /** Returns the number of time frames, at least 1. */
  int frames() {
    return Math.max(
        1, Math.min(1 << 15, NumberParser.positiveInt(values.getOrDefault("frames", "1"))));
  }

  /** Returns the distance between slices in its own unit, or NaN if it is absent. */
  double spacing() {
    return NumberParser.number(values.getOrDefault("spacing", ""));
  }

  /** Returns the number of slices that it states; 0 if it states none. */
  int slices() {
    return Math.max(0, NumberParser.positiveInt(values.getOrDefault("slices", "0")));
  }

  /** Returns the pixel at which its calibrated coordinate along an axis, 0 to 2, is 0. */
  double origin(int axis) {
    double origin = NumberParser.number(values.getOrDefault("xyz".charAt(axis) + "origin", "0"));
    return Double.isFinite(origin) ? origin : 0;
  }

  /** Returns its unit of length as it is written; empty if it has none. */
  String unit() {
    return values.getOrDefault("unit", "");
  }

  /** Returns the millimetres in its unit of length, or NaN if it has none. */
  double mmPerUnit() {
    return ImagejUnit.mm(unit());
  }

  /**
   * Returns the linear calibration, which ImageJ also uses for signed 16 bit stored with an offset
   * of 32768.
   */
  Scaling scaling() {
    double slope = NumberParser.number(values.getOrDefault("c1", ""));
    double intercept = NumberParser.number(values.getOrDefault("c0", ""));
    boolean linear = "0".equals(values.getOrDefault("cf", ""));
    boolean usable = linear && Double.isFinite(slope) && slope != 0 && Double.isFinite(intercept);
    return usable ? new Scaling(slope, intercept) : Scaling.NONE;
  }
}
