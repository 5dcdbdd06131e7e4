package org.palpate.io.dicom;

import java.io.ByteArrayOutputStream;

/**
 * Encodes 16-bit images as lossless JPEG with the left predictor and a fixed Huffman table, so that
 * the coded data end at any bit and directly before the end marker.
 *
 * <p>Source: ITU-T T.81, annex H.
 */
final class LosslessJpegEncoder {
  private static final int CODE_BITS = 5; // 17 categories of differences, each with a 5-bit code
  private static final int CATEGORIES = 17;

  private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
  private int pending;
  private int pendingBits;

  private LosslessJpegEncoder() {}

  /** Returns the JPEG stream of an image, x fastest. */
  static byte[] encode(int[] pixels, int columns, int rows) {
    LosslessJpegEncoder encoder = new LosslessJpegEncoder();
    encoder.writeHeader(columns, rows);
    for (int n = 0; n < pixels.length; n++) {
      int above = n < columns ? 1 << 15 : pixels[n - columns];
      int predicted = n % columns == 0 ? above : pixels[n - 1];
      encoder.writeDifference((short) (pixels[n] - predicted));
    }
    encoder.fillLastByte();
    encoder.writeWord(0xFFD9);
    return encoder.bytes.toByteArray();
  }

  private void writeHeader(int columns, int rows) {
    writeWord(0xFFD8);
    writeWords(0xFFC3, 11);
    bytes.write(16);
    writeWords(rows, columns);
    write(1, 1, 0x11, 0);
    writeWords(0xFFC4, 2 + 17 + CATEGORIES);
    bytes.write(0);
    for (int length = 1; length <= 16; length++) {
      bytes.write(length == CODE_BITS ? CATEGORIES : 0);
    }
    for (int category = 0; category < CATEGORIES; category++) {
      bytes.write(category);
    }
    writeWords(0xFFDA, 8);
    write(1, 1, 0, 1, 0, 0);
  }

  private void writeDifference(int difference) {
    int category = 32 - Integer.numberOfLeadingZeros(Math.abs(difference));
    writeBits(category, CODE_BITS);
    if (category < 16) {
      writeBits(difference < 0 ? difference - 1 : difference, category);
    }
  }

  private void writeBits(int value, int count) {
    for (int bit = count - 1; bit >= 0; bit--) {
      pending = pending << 1 | (value >> bit & 1);
      if (++pendingBits == 8) {
        bytes.write(pending);
        if ((pending & 0xff) == 0xff) {
          bytes.write(0);
        }
        pending = 0;
        pendingBits = 0;
      }
    }
  }

  private void fillLastByte() {
    while (pendingBits > 0) {
      writeBits(1, 1);
    }
  }

  private void writeWords(int first, int second) {
    writeWord(first);
    writeWord(second);
  }

  private void writeWord(int word) {
    bytes.write(word >> 8);
    bytes.write(word);
  }

  private void write(int... values) {
    for (int value : values) {
      bytes.write(value);
    }
  }
}
