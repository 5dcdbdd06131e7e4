package org.palpate.io.tiff;

import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.apache.commons.compress.compressors.zstandard.ZstdUtils;
import org.palpate.io.file.NumberText;
import org.palpate.io.format.BinaryData;
import org.palpate.io.format.InputFiles;
import org.palpate.io.volume.VolumeFormatException;

/** One page of a TIFF, with the meaning of its tags. */
final class TiffPage {
  /** The code of the compression ZSTD. */
  static final int ZSTD = 50000;

  static final Set<Integer> KNOWN_TAGS =
      Set.of(
          254, 256, 257, 258, 259, 262, 266, 270, 273, 274, 277, 278, 279, 282, 283, 284, 296, 317,
          320, 322, 323, 324, 325, 339, 32997, 33629);

  private final TiffFile tiff;
  private final Map<Integer, double[]> tags;
  private final TiffPixels pixels;

  TiffPage(TiffFile tiff, Map<Integer, double[]> tags) {
    this.tiff = tiff;
    this.tags = tags;
    pixels =
        new TiffPixels(
            (int) value(277, 1),
            (int) value(258, 1),
            (int) value(339, 1),
            (int) value(262, TiffPixels.BLACK_IS_ZERO),
            value(284, 1) == 2 && value(277, 1) > 1,
            value(266, 1) == 2);
  }

  /** Returns the file that holds the page. */
  TiffFile tiff() {
    return tiff;
  }

  /** Returns the layout of the pixels. */
  TiffPixels pixels() {
    return pixels;
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

  /** Returns the number of strips or tiles side by side. */
  int tilesAcross() throws VolumeFormatException {
    return (width() - 1) / tileWidth() + 1;
  }

  /** Returns the number of strips or tiles below one another. */
  int tilesDown() throws VolumeFormatException {
    return (height() - 1) / tileHeight() + 1;
  }

  /** Returns the file offset of each strip or tile. */
  double[] offsets() throws VolumeFormatException {
    return required(isTiled() ? 324 : 273, "offsets");
  }

  /** Returns the compressed bytes of each strip or tile. */
  double[] byteCounts() throws VolumeFormatException {
    int tag = isTiled() ? 325 : 279;
    if (!tags.containsKey(tag) && compression() == 1 && offsets().length == 1) {
      return new double[] {(double) pixels.rowBytes(width()) * height()};
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

  /** Returns the corner and direction of the first row: 1 if it runs to the right at the top. */
  int orientation() {
    return (int) value(274, 1);
  }

  /** Returns the number of planes in the page, by ImageDepth or by MetaMorph's table of planes. */
  private int planes() {
    int listed = tags.getOrDefault(33629, new double[0]).length;
    return Math.max((int) value(32997, 1), listed);
  }

  /** Returns the unit of resolution: 1 none, 2 inch, 3 centimetre. */
  int resolutionUnit() {
    return (int) value(296, 2);
  }

  /**
   * Returns the grey values of a palette without colours, by its index; empty if there is none.
   *
   * <p>A palette with colours gives no values: its indices are the values.
   */
  Optional<int[]> greyPalette() {
    double[] map = tags.getOrDefault(320, new double[0]);
    int count = 1 << Math.min(16, Math.max(0, pixels.bits()));
    if (pixels.photometric() != TiffPixels.PALETTE || map.length != 3 * count) {
      return Optional.empty();
    }
    int[] greys = new int[count];
    for (int n = 0; n < count; n++) {
      if (map[n] != map[n + count] || map[n] != map[n + 2 * count]) {
        return Optional.empty();
      }
      greys[n] = (int) map[n] >> 8 & 0xff;
    }
    return Optional.of(greys);
  }

  /**
   * Checks that the page can be decoded and that the file is long enough for its offsets and size.
   *
   * @throws VolumeFormatException if not
   */
  void check() throws VolumeFormatException {
    int compression = compression();
    if (compressionName(compression).isEmpty()) {
      throw conversion("the compression is " + otherCompression(compression));
    }
    if (!pixels.fault().isEmpty()) {
      throw refusal(pixels.fault());
    }
    if (planes() > 1) {
      throw refusal("the page holds " + planes() + " planes, of which only the first can be read");
    }
    checkPredictor();
    double pieces = (double) tilesAcross() * tilesDown() * pixels.planes();
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
    double bytes = (double) pixels.rowBytes(width()) * height() * pixels.planes();
    double tileBytes = (double) pixels.rowBytes(tileWidth()) * tileHeight();
    double most = (double) tiff.length() * maxExpansion(compression);
    if (bytes > most || tileBytes > most + 4096 || tileBytes > Integer.MAX_VALUE - 8) {
      throw InputFiles.truncatedFile(
          tiff.file(), bytes, (double) tiff.length(), compression == 1 ? "" : "compressed");
    }
  }

  private void checkPredictor() throws VolumeFormatException {
    boolean usable =
        switch (predictor()) {
          case TiffPredictor.NONE -> true;
          case TiffPredictor.HORIZONTAL -> pixels.bits() % 8 == 0;
          case TiffPredictor.FLOATING_POINT -> pixels.isFloat();
          default -> false;
        };
    if (!usable) {
      throw conversion(
          "the predictor " + predictor() + " does not fit pixels of " + pixels.bits() + " bits");
    }
  }

  /** Returns the name of a compression that can be read; empty for any other. */
  static String compressionName(int compression) {
    return switch (compression) {
      case 1 -> "uncompressed";
      case 5 -> "LZW";
      case 8, 32946 -> "deflate";
      case 32773 -> "PackBits";
      case ZSTD -> ZstdUtils.isZstdCompressionAvailable() ? "ZSTD" : "";
      default -> "";
    };
  }

  private static String otherCompression(int compression) {
    return switch (compression) {
          case 2, 3, 4 -> "CCITT fax";
          case 6, 7 -> "JPEG";
          case 33003, 33005, 34712 -> "JPEG 2000";
          case 34887 -> "LERC";
          case 34925 -> "LZMA";
          case ZSTD -> "ZSTD without the library zstd-jni";
          case 50001 -> "WebP";
          case 50002 -> "JPEG XL";
          default -> "of the unknown kind " + compression;
        }
        + ", which cannot be read";
  }

  private VolumeFormatException conversion(String what) {
    return new VolumeFormatException(
        what, tiff.file(), "convert it with: tiffcp -c lzw IN OUT (free, from libtiff)");
  }

  /** Returns the most bytes that one compressed byte can become. */
  private static int maxExpansion(int compression) {
    return switch (compression) {
      case 1 -> 1;
      case 5 -> 2800; // 4096 bytes of 12 bits
      case 32773 -> 64; // 128 bytes of 2
      case ZSTD -> 32768; // a block of 128 KiB of 4
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
