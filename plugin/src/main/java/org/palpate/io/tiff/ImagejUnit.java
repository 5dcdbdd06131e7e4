package org.palpate.io.tiff;

import java.util.Locale;

/** Converts units of length, by the names that ImageJ and its users give them, to millimetres. */
public final class ImagejUnit {
  private ImagejUnit() {}

  /**
   * Returns the millimetres in a unit of length.
   *
   * @param name in upper or lower case
   * @return NaN if the name is not one of a unit of length
   */
  public static double mm(String name) {
    return switch (name.toLowerCase(Locale.ROOT)) {
      case "mm", "millimeter", "millimetre" -> 1;
      case "cm", "centimeter" -> 10;
      case "m", "meter" -> 1000;
      case "in", "inch", "inches" -> 25.4;
      case "um", "\u00b5m", "\u03bcm", "\\u00b5m", "micron", "microns", "micrometer" -> 1e-3;
      case "nm", "nanometer" -> 1e-6;
      default -> Double.NaN;
    };
  }
}
