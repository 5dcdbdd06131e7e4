package org.palpate.io.tiff;

import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Set;
import org.palpate.io.file.NumberText;
import org.palpate.io.format.BinaryData;
import org.palpate.io.format.InputFiles;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VoxelType;

/** One page of a TIFF, with the meaning of its tags. */
final class TiffPage {
  static final Set<Integer> KNOWN_TAGS =
      Set.of(
          254, 256, 257, 258, 259, 262, 270, 273, 277, 278, 279, 282, 283, 284, 296, 317, 322, 323,
          324, 325, 339);

  private final TiffFile tiff;
  private final Map<Integer, double[]> tags;

  TiffPage(TiffFile tiff, Map<Integer, double[]> tags) {
    this.tiff = tiff;
    this.tags = tags;
  }

  /** Whether the page is a reduced copy of another page. */
  boolean isReduced() {
    return ((int) value(254, 0) & 1) != 0;
  }

  /** Returns the width in pixels. */
  int width() throws VolumeFormatException {
    return size(256, "width");
  }

  /** Returns the height in pixels. */
  int height() throws VolumeFormatException {
    return size(257, "height");
  }

  /** Returns the code of the compression, 1 for none. */
  int compression() {
    return (int) value(259, 1);
  }

  /** Returns the code of the predictor, 1 for none. */
  int predictor() {
    return (int) value(317, 1);
  }

  /** Whether the page has tiles rather than strips. */
  boolean isTiled() {
    return tags.containsKey(324);
  }

  /** Returns the width of a tile, or of the page if it has strips. */
  int tileWidth() throws VolumeFormatException {
    return isTiled() ? size(322, "tile width") : width();
  }

  /** Returns the height of a tile or a strip. */
  int tileHeight() throws VolumeFormatException {
    if (isTiled()) {
      return size(323, "tile height");
    }
    double rows = value(278, height());
    return rows >= 1 && rows < height() ? (int) rows : height();
  }

  /** Returns the file offset of each strip or tile. */
  double[] offsets() throws VolumeFormatException {
    return required(isTiled() ? 324 : 273, "offsets");
  }

  /** Returns the compressed bytes of each strip or tile. */
  double[] byteCounts() throws VolumeFormatException {
    int tag = isTiled() ? 325 : 279;
    if (!tags.containsKey(tag) && compression() == 1 && offsets().length == 1) {
      return new double[] {(double) width() * height() * type().bytes()};
    }
    return required(tag, "byte counts");
  }

  /** Returns the text of the description; empty if there is none. */
  String description() {
    double[] characters = tags.getOrDefault(270, new double[0]);
    byte[] bytes = new byte[characters.length];
    for (int n = 0; n < bytes.length; n++) {
      bytes[n] = (byte) characters[n];
    }
    return new String(bytes, StandardCharsets.UTF_8);
  }

  /**
   * Returns the pixels in a unit of length along x (tag 282) or y (tag 283), or NaN if it is
   * absent.
   */
  double resolution(int tag) {
    return value(tag, Double.NaN);
  }

  /** Returns the unit of resolution: 1 none, 2 inch, 3 centimetre. */
  int resolutionUnit() {
    return (int) value(296, 2);
  }

  /**
   * Returns the type of a pixel.
   *
   * @throws VolumeFormatException if it is colour or cannot be read
   */
  VoxelType type() throws VolumeFormatException {
    int bits = (int) value(258, 1);
    int format = (int) value(339, 1);
    if (value(277, 1) != 1) {
      throw refusal(
          "the pixels are colours, " + NumberText.display(value(277, 1)) + " samples a pixel");
    }
    String name = (format == 2 ? "int" : format == 3 ? "float" : "uint") + bits;
    return switch (name) {
      case "uint8" -> VoxelType.UINT8;
      case "int8" -> VoxelType.INT8;
      case "uint16" -> VoxelType.UINT16;
      case "int16" -> VoxelType.INT16;
      case "uint32" -> VoxelType.UINT32;
      case "int32" -> VoxelType.INT32;
      case "float32" -> VoxelType.FLOAT32;
      case "float64" -> VoxelType.FLOAT64;
      default -> throw refusal("the pixels are " + name + ", which cannot be read");
    };
  }

  /**
   * Checks that the page can be decoded and that the file is long enough for its offsets and size.
   *
   * @throws VolumeFormatException if not
   */
  void check() throws VolumeFormatException {
    int compression = compression();
    if (compression != 1
        && compression != 5
        && compression != 8
        && compression != 32946
        && compression != 32773) {
      throw refusal("the compression " + compression + " cannot be read");
    }
    if (predictor() < 1 || predictor() > 2) {
      throw refusal("the predictor " + predictor() + " cannot be read");
    }
    double pieces =
        Math.ceil((double) width() / tileWidth()) * Math.ceil((double) height() / tileHeight());
    if (offsets().length < pieces || byteCounts().length < pieces) {
      throw refusal(
          "the page has "
              + offsets().length
              + " strips or tiles instead of "
              + NumberText.display(pieces));
    }
    for (int n = 0; n < pieces; n++) {
      double end = offsets()[n] + byteCounts()[n];
      if (!(offsets()[n] >= 0 && byteCounts()[n] >= 0 && end <= tiff.length())) {
        throw InputFiles.truncatedFile(tiff.file(), end, (double) tiff.length(), "");
      }
    }
    double bytes = (double) width() * height() * type().bytes();
    double tileBytes = (double) tileWidth() * tileHeight() * type().bytes();
    double most = (double) tiff.length() * maxExpansion(compression);
    if (bytes > most || tileBytes > most + 4096 || tileBytes > Integer.MAX_VALUE - 8) {
      throw InputFiles.truncatedFile(
          tiff.file(), bytes, (double) tiff.length(), compression == 1 ? "" : "compressed");
    }
  }

  /** Returns the most bytes that one compressed byte can become. */
  private static int maxExpansion(int compression) {
    return switch (compression) {
      case 1 -> 1;
      case 5 -> 2800; // 4096 bytes of 12 bits
      case 32773 -> 64; // 128 bytes of 2
      default -> BinaryData.MAX_DEFLATE_RATIO;
    };
  }

  /** Returns an exception that names the file. */
  VolumeFormatException refusal(String what) {
    return new VolumeFormatException(
        what,
        tiff.file(),
        "save it in ImageJ as a grey TIFF stack of 8, 16 or 32 bit, uncompressed");
  }

  private int size(int tag, String name) throws VolumeFormatException {
    double size = value(tag, 0);
    if (!(size >= 1 && size <= Integer.MAX_VALUE)) {
      throw refusal("the " + name + " is " + NumberText.display(size));
    }
    return (int) size;
  }

  private double[] required(int tag, String name) throws VolumeFormatException {
    double[] values = tags.get(tag);
    if (values == null) {
      throw refusal("the page has no " + name);
    }
    return values;
  }

  private double value(int tag, double fallback) {
    double[] values = tags.get(tag);
    return values == null || values.length == 0 ? fallback : values[0];
  }
}
