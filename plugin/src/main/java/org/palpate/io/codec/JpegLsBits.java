package org.palpate.io.codec;

import java.io.EOFException;
import java.io.IOException;

/**
 * Reads the bits of a scan of JPEG-LS, highest first. A byte after 0xFF has seven of them.
 *
 * <p>Source: ITU-T T.87, A.1.
 */
final class JpegLsBits {
  private static final int MARKER = 0xFF;
  private static final int FIRST_RESTART = 0xD0;
  private static final int RESTARTS = 8;
  private static final int MAX_FILL = 56;

  private final byte[] bytes;
  private int at;
  private long buffer; // the next bit is the highest
  private int available;

  /** Creates a reader that begins at an offset. */
  JpegLsBits(byte[] bytes, int from) {
    this.bytes = bytes;
    at = from;
  }

  /** Returns the next bit. */
  int bit() throws IOException {
    return bits(1);
  }

  /** Returns the next 0 to 16 bits as a number. */
  int bits(int count) throws IOException {
    if (count == 0) {
      return 0;
    }
    if (available < count) {
      fill();
    }
    if (available < count) {
      throw new EOFException("the JPEG-LS stream ends inside its pixels");
    }
    int value = (int) (buffer >>> (64 - count));
    buffer <<= count;
    available -= count;
    return value;
  }

  /**
   * Counts zeros up to the next bit of 1, and skips both.
   *
   * @throws IOException if there are more zeros than {@code most}
   */
  int zeros(int most) throws IOException {
    int zeros = 0;
    while (true) {
      if (available == 0) {
        fill();
      }
      if (available == 0) {
        throw new EOFException("the JPEG-LS stream ends inside its pixels");
      }
      int run = Math.min(available, Long.numberOfLeadingZeros(buffer));
      zeros += run;
      if (zeros > most) {
        throw new IOException("the JPEG-LS stream has a damaged pixel");
      }
      if (run < available) {
        // shifting twice, because a shift by 64 would do nothing
        buffer = buffer << run << 1;
        available -= run + 1;
        return zeros;
      }
      buffer = 0;
      available = 0;
    }
  }

  /**
   * Skips the rest of a byte and a restart marker.
   *
   * @param number from 0; the marker holds its last three bits
   */
  void restart(long number) throws IOException {
    fill(); // stands at the marker if the data before it are used up
    boolean marker =
        at + 1 < bytes.length
            && (bytes[at] & 0xff) == MARKER
            && (bytes[at + 1] & 0xff) == FIRST_RESTART + number % RESTARTS;
    if (!marker || available > 8) {
      throw new IOException("the JPEG-LS stream is missing a restart marker");
    }
    at += 2;
    buffer = 0;
    available = 0;
  }

  private void fill() {
    while (available <= MAX_FILL && at < bytes.length) {
      int next = bytes[at] & 0xff;
      if (next == MARKER && (at + 1 >= bytes.length || bytes[at + 1] < 0)) {
        return; // a marker ends the data
      }
      boolean stuffed = at > 0 && (bytes[at - 1] & 0xff) == MARKER;
      int count = stuffed ? 7 : 8;
      buffer |= (long) next << (64 - count - available);
      available += count;
      at++;
    }
  }
}
