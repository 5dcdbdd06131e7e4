package org.palpate.io.codec;

import java.io.IOException;
import java.util.Arrays;

/**
 * Decodes the pixels of one component of JPEG-LS: prediction from four neighbours, errors in Golomb
 * codes of 365 contexts, and runs in flat regions.
 *
 * <p>Source: ITU-T T.87, annex A. The names of its variables stand in the comments.
 */
final class JpegLsScan {
  private static final int CONTEXTS = 365;
  private static final int MAX_CORRECTION = 127;
  private static final int MIN_CORRECTION = -128;

  /** J: the logarithm of the run length that a bit of 1 stands for. */
  private static final int[] RUN_LOG = {
    0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7, 8, 9, 10, 11, 12, 13,
    14, 15
  };

  private final JpegLsBits in;
  private final JpegLsParameters parameters;
  private final int columns;
  private final int rows;
  private final int most;
  private final int near;
  private final int step;
  private final int range;
  private final int errorBits;
  private final int limit;
  private final int reset;

  private final int[] magnitude = new int[CONTEXTS + 2]; // A; the last two are for runs
  private final int[] count = new int[CONTEXTS + 2]; // N
  private final int[] bias = new int[CONTEXTS]; // B
  private final int[] correction = new int[CONTEXTS]; // C
  private final int[] negative = new int[2]; // Nn
  private int runIndex;
  private int[] above;
  private int[] line;

  /** Creates a decoder. Its buffers of a line hold one more pixel at either end. */
  JpegLsScan(JpegLsBits in, JpegLsParameters parameters, int columns, int rows) {
    this.in = in;
    this.parameters = parameters;
    this.columns = columns;
    this.rows = rows;
    most = parameters.most();
    near = parameters.near();
    step = parameters.step();
    range = parameters.range();
    errorBits = parameters.errorBits();
    limit = parameters.limit();
    reset = parameters.reset();
    above = new int[columns + 2];
    line = new int[columns + 2];
  }

  /**
   * Decodes all rows.
   *
   * @param restartLines rows between restart markers, 0 if there are none
   */
  void decode(long restartLines, int[] dest) throws IOException {
    restart();
    for (int row = 0; row < rows; row++) {
      if (restartLines > 0 && row > 0 && row % restartLines == 0) {
        in.restart(row / restartLines - 1);
        restart();
      }
      above[columns + 1] = above[columns];
      line[0] = above[1];
      decodeRow();
      System.arraycopy(line, 1, dest, row * columns, columns);
      int[] next = above;
      above = line;
      line = next;
    }
  }

  private void restart() {
    Arrays.fill(magnitude, Math.max(2, (range + 32) / 64));
    Arrays.fill(count, 1);
    Arrays.fill(bias, 0);
    Arrays.fill(correction, 0);
    Arrays.fill(negative, 0);
    Arrays.fill(above, 0);
    Arrays.fill(line, 0);
    runIndex = 0;
  }

  private void decodeRow() throws IOException {
    int column = 1;
    while (column <= columns) {
      int left = line[column - 1];
      int up = above[column];
      int upLeft = above[column - 1];
      int context =
          81 * quantized(above[column + 1] - up)
              + 9 * quantized(up - upLeft)
              + quantized(upLeft - left);
      if (context == 0) {
        column = decodeRun(column);
      } else {
        line[column] = regular(context, predicted(left, up, upLeft));
        column++;
      }
    }
  }

  private int quantized(int difference) {
    int size = Math.abs(difference);
    int level;
    if (size <= near) {
      return 0;
    } else if (size < parameters.threshold1()) {
      level = 1;
    } else if (size < parameters.threshold2()) {
      level = 2;
    } else {
      level = size < parameters.threshold3() ? 3 : 4;
    }
    return difference < 0 ? -level : level;
  }

  /** Returns the neighbour beyond an edge, or the plane through the three neighbours. */
  private static int predicted(int left, int up, int upLeft) {
    int low = Math.min(left, up);
    int high = Math.max(left, up);
    return upLeft >= high ? low : upLeft <= low ? high : left + up - upLeft;
  }

  private int regular(int signedContext, int prediction) throws IOException {
    int sign = signedContext < 0 ? -1 : 1;
    int context = Math.abs(signedContext);
    int corrected = clamped(prediction + sign * correction[context]);
    int log = golombLog(count[context], magnitude[context]);
    int mapped = golomb(log, limit);
    boolean mirrored = near == 0 && log == 0 && 2 * bias[context] <= -count[context];
    int error = (mapped & 1) == 0 ? mapped >> 1 : -((mapped + 1) >> 1);
    error = mirrored ? -error - 1 : error;
    updateContext(context, error);
    return reconstructed(corrected, sign * error);
  }

  private void updateContext(int context, int error) {
    bias[context] += error * step;
    magnitude[context] += Math.abs(error);
    if (count[context] == reset) {
      magnitude[context] >>= 1;
      bias[context] = bias[context] >= 0 ? bias[context] >> 1 : -((1 - bias[context]) >> 1);
      count[context] >>= 1;
    }
    count[context]++;
    int samples = count[context];
    if (bias[context] <= -samples) {
      bias[context] = Math.max(bias[context] + samples, 1 - samples);
      correction[context] = Math.max(correction[context] - 1, MIN_CORRECTION);
    } else if (bias[context] > 0) {
      bias[context] = Math.min(bias[context] - samples, 0);
      correction[context] = Math.min(correction[context] + 1, MAX_CORRECTION);
    }
  }

  private int reconstructed(int prediction, int error) {
    int value = prediction + error * step;
    if (value < -near) {
      value += range * step;
    } else if (value > most + near) {
      value -= range * step;
    }
    return clamped(value);
  }

  private int clamped(int value) {
    return Math.max(0, Math.min(value, most));
  }

  /** Decodes a run and the pixel that ends it, and returns the column after them. */
  private int decodeRun(int from) throws IOException {
    int end = columns + 1;
    int column = from;
    int value = line[from - 1];
    while (column < end && in.bit() == 1) {
      int length = 1 << RUN_LOG[runIndex];
      int filled = Math.min(length, end - column);
      Arrays.fill(line, column, column + filled, value);
      column += filled;
      if (filled == length && runIndex < RUN_LOG.length - 1) {
        runIndex++;
      }
    }
    if (column == end) {
      return column;
    }
    int rest = in.bits(RUN_LOG[runIndex]);
    if (rest >= end - column) {
      throw new IOException("the JPEG-LS stream has a run beyond its row");
    }
    Arrays.fill(line, column, column + rest, value);
    column += rest;
    line[column] = interrupted(value, above[column]);
    runIndex = Math.max(0, runIndex - 1);
    return column + 1;
  }

  /** Decodes the pixel that ends a run. */
  private int interrupted(int left, int up) throws IOException {
    int kind = Math.abs(left - up) <= near ? 1 : 0; // RItype
    int context = CONTEXTS + kind;
    int log = golombLog(count[context], magnitude[context] + kind * (count[context] >> 1));
    int mapped = golomb(log, limit - RUN_LOG[runIndex] - 1);
    int twice = mapped + kind;
    int size = (twice + 1) >> 1;
    boolean odd = (twice & 1) != 0;
    boolean minus = (log != 0 || 2 * negative[kind] >= count[context]) == odd;
    int error = minus ? -size : size;
    updateRunContext(kind, error, mapped);
    return kind == 1 ? reconstructed(left, error) : reconstructed(up, up > left ? error : -error);
  }

  private void updateRunContext(int kind, int error, int mapped) {
    int context = CONTEXTS + kind;
    negative[kind] += error < 0 ? 1 : 0;
    magnitude[context] += (mapped + 1 - kind) >> 1;
    if (count[context] == reset) {
      magnitude[context] >>= 1;
      count[context] >>= 1;
      negative[kind] >>= 1;
    }
    count[context]++;
  }

  /** Returns the parameter of the Golomb code, at most 16. */
  private static int golombLog(int samples, int sum) {
    int log = 0;
    while (log < 16 && samples << log < sum) {
      log++;
    }
    return log;
  }

  private int golomb(int log, int most) throws IOException {
    int escape = most - errorBits - 1;
    int zeros = in.zeros(escape);
    return zeros < escape ? (zeros << log) + in.bits(log) : in.bits(errorBits) + 1;
  }
}
