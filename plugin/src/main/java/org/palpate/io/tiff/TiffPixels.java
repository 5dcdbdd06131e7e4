package org.palpate.io.tiff;

import org.palpate.io.format.Scaling;
import org.palpate.io.volume.VolumeHeader.ValueRange;
import org.palpate.io.volume.VoxelType;

/**
 * The layout of the pixels of a TIFF page, as its tags give it.
 *
 * @param samples numbers in a pixel
 * @param bits bits of each number
 * @param format 1 unsigned, 2 signed, 3 floating point, 4 undefined, 5 and 6 complex
 * @param photometric the code of what the numbers stand for
 * @param isPlanar whether each sample of a pixel stands in a plane of its own
 * @param isLowestBitFirst whether the lowest bit of a byte is the first pixel (FillOrder 2)
 */
record TiffPixels(
    int samples,
    int bits,
    int format,
    int photometric,
    boolean isPlanar,
    boolean isLowestBitFirst) {
  static final int WHITE_IS_ZERO = 0;
  static final int BLACK_IS_ZERO = 1;
  static final int RGB = 2;
  static final int PALETTE = 3;

  private static final int SIGNED = 2;
  private static final int FLOAT = 3;

  /** Whether the numbers are floating point. */
  boolean isFloat() {
    return format == FLOAT;
  }

  /** Whether red, green and blue become one value. */
  boolean isColour() {
    return photometric == RGB;
  }

  /** Whether 0 is white and values are inverted, so that white is the highest. */
  boolean isInverted() {
    return photometric == WHITE_IS_ZERO && format != SIGNED && !isFloat() && bits <= 16;
  }

  /** Returns the numbers that stand side by side for a pixel. */
  int interleaved() {
    return isPlanar ? 1 : samples;
  }

  /** Returns the number of planes of a page. */
  int planes() {
    return isPlanar ? samples : 1;
  }

  /** Returns the bytes of a row of stored pixels, padded to whole bytes. */
  long rowBytes(int width) {
    return ((long) width * interleaved() * bits + 7) / 8;
  }

  /** Whether a number takes whole bytes as it is stored, of a type that Java has. */
  boolean isPlain() {
    return bits % 8 == 0 && !isHalf();
  }

  /** Whether the numbers are floating point of 16 bits. */
  boolean isHalf() {
    return isFloat() && bits == 16;
  }

  /**
   * Returns the reason that the pixels cannot be read; empty if they can.
   *
   * <p>Readable are unsigned numbers of 1 to 16 bits, integers of 8, 16, 32 and 64 bits, floating
   * point of 16, 32 and 64 bits, and RGB of 8 or 16 bits.
   */
  String fault() {
    if (format == 5 || format == 6) {
      return "the pixels are complex numbers";
    }
    if (photometric > PALETTE) {
      return "the pixels are colours (" + photometricName() + ")";
    }
    if (isColour() && (samples < 3 || isFloat() || (bits != 8 && bits != 16))) {
      return "the pixels are colours of " + samples + " samples of " + bits + " bits";
    }
    if (!isColour() && samples > 2) {
      return "a pixel has " + samples + " samples that are no colours";
    }
    if (samples < 1) {
      return "a pixel has " + samples + " samples";
    }
    return isReadableNumber() ? "" : "the pixels are " + numberName() + ", which cannot be read";
  }

  private boolean isReadableNumber() {
    boolean whole = bits == 8 || bits == 16 || bits == 32 || bits == 64;
    return isFloat()
        ? whole && bits > 8
        : whole || (format != SIGNED && bits >= 1 && bits < 16 && (bits < 8 || samples == 1));
  }

  private String numberName() {
    return (format == SIGNED ? "signed" : isFloat() ? "floating-point" : "unsigned")
        + " numbers of "
        + bits
        + " bits";
  }

  private String photometricName() {
    return switch (photometric) {
      case 4 -> "transparency mask";
      case 5 -> "CMYK";
      case 6 -> "YCbCr";
      case 8, 9, 10 -> "CIE L*a*b*";
      case 32803 -> "colour filter array";
      default -> "photometric interpretation " + photometric;
    };
  }

  /** Returns the type of a number once its bits are unpacked. */
  VoxelType type() {
    if (isFloat()) {
      return bits == 64 ? VoxelType.FLOAT64 : VoxelType.FLOAT32;
    }
    boolean signed = format == SIGNED;
    if (bits <= 8) {
      return signed ? VoxelType.INT8 : VoxelType.UINT8;
    }
    if (bits <= 16) {
      return signed ? VoxelType.INT16 : VoxelType.UINT16;
    }
    return bits == 32
        ? signed ? VoxelType.INT32 : VoxelType.UINT32
        : signed ? VoxelType.INT64 : VoxelType.UINT64;
  }

  /** Returns the rescaling of stored numbers: an inversion if 0 is white, then a calibration. */
  Scaling scaling(Scaling calibration) {
    return isInverted()
        ? new Scaling(-calibration.slope(), calibration.apply(highest()))
        : calibration;
  }

  /** Returns the bounds on the values after {@link #scaling}. */
  ValueRange range(Scaling scaling) {
    ValueRange ofType = scaling.range(type());
    if (isFloat() || format == SIGNED || bits > 16) {
      return ofType;
    }
    double a = scaling.apply(0);
    double b = scaling.apply(highest());
    return new ValueRange(Math.min(a, b), Math.max(a, b), ofType.isInteger());
  }

  private double highest() {
    return (1 << bits) - 1;
  }
}
