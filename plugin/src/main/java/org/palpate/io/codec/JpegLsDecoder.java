package org.palpate.io.codec;

import java.io.EOFException;
import java.io.IOException;

/**
 * Decodes grey images of JPEG-LS, lossless or near-lossless, of 2 to 16 bits.
 *
 * <p>Source: ITU-T T.87 (ISO/IEC 14495-1), annexes A and C.
 */
public final class JpegLsDecoder {
  private static final int START = 0xFFD8;
  private static final int END = 0xFFD9;
  private static final int SCAN = 0xFFDA;
  private static final int RESTART_INTERVAL = 0xFFDD;
  private static final int LINES = 0xFFDC;
  private static final int APPLICATION = 0xFFE0;
  private static final int FRAME = 0xFFF7;
  private static final int PRESET = 0xFFF8;
  private static final int THRESHOLDS = 1;
  private static final int OVERSIZE = 4;

  private final byte[] bytes;
  private final int columns;
  private final int rows;
  private int bits;
  private long restartLines;
  private int[] preset = new int[5];

  private JpegLsDecoder(byte[] bytes, int columns, int rows) {
    this.bytes = bytes;
    this.columns = columns;
    this.rows = rows;
  }

  /**
   * Decodes an image into the first {@code columns * rows} numbers of {@code dest}, row by row.
   *
   * @throws IOException if the stream is damaged, is no grey image, or has another size
   */
  public static void decode(byte[] bytes, int columns, int rows, int[] dest) throws IOException {
    new JpegLsDecoder(bytes, columns, rows).decode(dest);
  }

  private void decode(int[] dest) throws IOException {
    require(word(0) == START, "does not begin with its start marker");
    int at = 2;
    while (word(at) != SCAN) {
      // a marker may be preceded by any number of bytes 0xFF
      if (word(at) == 0xFFFF) {
        at++;
        continue;
      }
      require(word(at) != END, "ends before its pixels");
      require(word(at) >= 0xFFC0 && word(at + 2) >= 2, "has a damaged marker");
      parseSegment(word(at), at + 4, word(at + 2) - 2);
      at += 2 + word(at + 2);
    }
    int near = parseScan(at + 4, word(at + 2) - 2);
    JpegLsParameters parameters = parameters(near);
    JpegLsBits in = new JpegLsBits(bytes, at + 2 + word(at + 2));
    new JpegLsScan(in, parameters, columns, rows).decode(restartLines, dest);
  }

  private void parseSegment(int marker, int at, int length) throws IOException {
    switch (marker) {
      case FRAME -> parseFrame(at, length);
      case PRESET -> parsePreset(at, length);
      case RESTART_INTERVAL -> {
        require(length >= 2 && length <= 4, "has a damaged restart interval");
        restartLines = 0;
        for (int n = 0; n < length; n++) {
          restartLines = restartLines << 8 | unsignedByte(at + n);
        }
      }
      default ->
          require(
              (marker >= APPLICATION && marker != 0xFFFF) || marker == LINES,
              "is of another kind of JPEG");
    }
  }

  private void parseFrame(int at, int length) throws IOException {
    require(length >= 9 && unsignedByte(at + 5) == 1, "has several components");
    bits = unsignedByte(at);
    require(bits >= 2 && bits <= 16, "has " + bits + " bits a pixel");
    require(
        word(at + 1) == rows && word(at + 3) == columns, "has another size than the DICOM header");
  }

  private void parsePreset(int at, int length) throws IOException {
    int kind = length < 1 ? 0 : unsignedByte(at);
    require(kind != OVERSIZE, "has an oversize image");
    if (kind != THRESHOLDS) {
      return; // a table for colours, which a scan must ask for
    }
    require(length >= 11, "has damaged parameters");
    for (int n = 0; n < preset.length; n++) {
      preset[n] = word(at + 1 + 2 * n);
    }
  }

  /** Checks the header of a scan and returns the largest error of a pixel. */
  private int parseScan(int at, int length) throws IOException {
    require(bits > 0, "has no frame before its pixels");
    require(length >= 6 && unsignedByte(at) == 1, "has several components");
    require(unsignedByte(at + 2) == 0, "uses a mapping table");
    require(unsignedByte(at + 5) == 0, "uses a point transform");
    return unsignedByte(at + 3);
  }

  private JpegLsParameters parameters(int near) throws IOException {
    int most = preset[0] == 0 ? (1 << bits) - 1 : preset[0];
    require(most < 1 << bits && near <= Math.min(255, most / 2), "has invalid parameters");
    JpegLsParameters defaults = JpegLsParameters.defaults(most, near);
    JpegLsParameters found =
        new JpegLsParameters(
            most,
            near,
            preset[1] == 0 ? defaults.threshold1() : preset[1],
            preset[2] == 0 ? defaults.threshold2() : preset[2],
            preset[3] == 0 ? defaults.threshold3() : preset[3],
            preset[4] == 0 ? defaults.reset() : preset[4]);
    require(
        found.threshold1() > near
            && found.threshold2() >= found.threshold1()
            && found.threshold3() >= found.threshold2()
            && found.threshold3() <= most
            && found.reset() >= 3,
        "has invalid parameters");
    return found;
  }

  private int unsignedByte(int at) throws IOException {
    if (at >= bytes.length) {
      throw new EOFException("the JPEG-LS stream is incomplete");
    }
    return bytes[at] & 0xff;
  }

  private int word(int at) throws IOException {
    return unsignedByte(at) << 8 | unsignedByte(at + 1);
  }

  private static void require(boolean holds, String otherwise) throws IOException {
    if (!holds) {
      throw new IOException("the JPEG-LS stream " + otherwise);
    }
  }
}
