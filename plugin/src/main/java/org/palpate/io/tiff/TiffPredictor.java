package org.palpate.io.tiff;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Reverses the predictors of TIFF in a row of numbers.
 *
 * <p>Source: TIFF Revision 6.0, section 14; Adobe Photoshop TIFF Technical Note 3.
 */
final class TiffPredictor {
  static final int NONE = 1;
  static final int HORIZONTAL = 2;
  static final int FLOATING_POINT = 3;

  private final int kind;
  private final ByteOrder order;
  private byte[] planes = new byte[0];

  TiffPredictor(int kind, ByteOrder order) {
    this.kind = kind;
    this.order = order;
  }

  /**
   * Reverses the predictor in a row.
   *
   * @param from where the row begins in {@code bytes}
   * @param count numbers in the row
   * @param size bytes of a number
   * @param stride numbers of a pixel
   */
  void undo(byte[] bytes, int from, int count, int size, int stride) {
    if (kind == HORIZONTAL) {
      addLeft(ByteBuffer.wrap(bytes).order(order), from, count, size, stride);
    } else if (kind == FLOATING_POINT) {
      addLeft(ByteBuffer.wrap(bytes), from, count * size, 1, stride);
      gather(bytes, from, count, size);
    }
  }

  /** Adds to each number the one of the pixel to its left. */
  private static void addLeft(ByteBuffer row, int from, int count, int size, int stride) {
    for (int n = stride; n < count; n++) {
      int at = from + n * size;
      int left = at - stride * size;
      switch (size) {
        case 1 -> row.put(at, (byte) (row.get(at) + row.get(left)));
        case 2 -> row.putShort(at, (short) (row.getShort(at) + row.getShort(left)));
        case 4 -> row.putInt(at, row.getInt(at) + row.getInt(left));
        default -> row.putLong(at, row.getLong(at) + row.getLong(left));
      }
    }
  }

  /** Gathers the bytes of each number, which stand in planes, the highest bytes first. */
  private void gather(byte[] bytes, int from, int count, int size) {
    int length = count * size;
    planes = planes.length >= length ? planes : new byte[length];
    System.arraycopy(bytes, from, planes, 0, length);
    for (int n = 0; n < count; n++) {
      for (int plane = 0; plane < size; plane++) {
        int place = order == ByteOrder.BIG_ENDIAN ? plane : size - 1 - plane;
        bytes[from + n * size + place] = planes[plane * count + n];
      }
    }
  }
}
