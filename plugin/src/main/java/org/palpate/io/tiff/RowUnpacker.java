package org.palpate.io.tiff;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** Unpacks rows of a TIFF whose numbers do not fill whole bytes, or are half floats. */
final class RowUnpacker {
  private RowUnpacker() {}

  /** Reverses the order of the bits in each byte. */
  static void reverseBits(byte[] bytes) {
    for (int n = 0; n < bytes.length; n++) {
      bytes[n] = (byte) (Integer.reverse(bytes[n]) >>> 24);
    }
  }

  /**
   * Unpacks {@code count} numbers of a row: bits to bytes, 9 to 15 bits to 16, half floats to
   * floats.
   *
   * @param packed the stored rows
   * @param from where the row begins
   * @param order the byte order of the file and of {@code dest}
   * @param dest receives the numbers from byte {@code at} on
   */
  static void unpack(
      TiffPixels pixels, byte[] packed, int from, int count, ByteOrder order, byte[] dest, int at) {
    ByteBuffer out = ByteBuffer.wrap(dest).order(order);
    if (pixels.isHalf()) {
      ByteBuffer in = ByteBuffer.wrap(packed).order(order);
      for (int n = 0; n < count; n++) {
        out.putFloat(at + 4 * n, halfToFloat(in.getShort(from + 2 * n)));
      }
      return;
    }
    for (int n = 0; n < count; n++) {
      int value = bits(packed, 8L * from + (long) n * pixels.bits(), pixels.bits());
      if (pixels.bits() <= 8) {
        dest[at + n] = (byte) value;
      } else {
        out.putShort(at + 2 * n, (short) value);
      }
    }
  }

  /** Returns up to 16 bits from a position, counted from the highest bit of the first byte. */
  private static int bits(byte[] packed, long position, int count) {
    int value = 0;
    for (long bit = position; bit < position + count; bit++) {
      value = value << 1 | ((packed[(int) (bit >> 3)] >> (7 - (int) (bit & 7))) & 1);
    }
    return value;
  }

  /** Returns the value of a floating-point number of 16 bits (IEEE 754 binary16). */
  static float halfToFloat(short half) {
    int sign = (half & 0x8000) << 16;
    int exponent = half >> 10 & 0x1f;
    int mantissa = half & 0x3ff;
    if (exponent == 0) {
      float magnitude = mantissa * 0x1p-24f;
      return sign == 0 ? magnitude : -magnitude;
    }
    int wide = exponent == 0x1f ? 0xff : exponent - 15 + 127;
    return Float.intBitsToFloat(sign | wide << 23 | mantissa << 13);
  }
}
