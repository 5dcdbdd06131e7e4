package org.palpate.proxy.smooth;

import org.palpate.proxy.Obstacles;

/** Corner values from the bits alone. */
final class BitNodes implements NodeSource {
  /** Bits for one of three sums in a word; no sum of taps is above 30 * 30 * 30. */
  private static final int SUM_BITS = 21;

  private static final long SUM_MASK = (1L << SUM_BITS) - 1;

  /** From the window's low voxel to its middle corner. */
  private static final int TO_MIDDLE = BitWindow.EDGE / 2;

  private static final int ROW_MASK = (1 << BitWindow.EDGE) - 1;

  private final SmoothingKernel kernel;
  private final BitWindow window = new BitWindow();
  private final long[] sumsOfRow = new long[1 << BitWindow.EDGE];
  private final long[] rows = new long[BitWindow.EDGE];
  private final long[][] columns = new long[3][BitWindow.EDGE];
  private final AxisTaps alongY;
  private final AxisTaps alongZ;
  private int lowX;
  private int lowY;
  private int lowZ;
  private boolean empty;

  BitNodes(SmoothingKernel kernel) {
    this.kernel = kernel;
    alongY = new AxisTaps(kernel, 1);
    alongZ = new AxisTaps(kernel, 2);
    for (int row = 0; row <= ROW_MASK; row++) {
      sumsOfRow[row] = sumsOf(row);
    }
  }

  private long sumsOf(int row) {
    long packed = 0;
    for (int node = 0; node < 3; node++) {
      long sum = 0;
      for (int tap = 0; tap < SmoothingKernel.TAPS; tap++) {
        sum += (row >> (node + tap) & 1L) * kernel.tap(0, tap);
      }
      packed |= sum << (SUM_BITS * node);
    }
    return packed;
  }

  @Override
  public boolean load(
      Obstacles obstacles, int x, int y, int z, int seedX, int seedY, int seedZ, double[] nodes) {
    lowX = x - TO_MIDDLE;
    lowY = y - TO_MIDDLE;
    lowZ = z - TO_MIDDLE;
    window.load(obstacles, lowX, lowY, lowZ);
    empty = !window.anySolid();
    if (empty) {
      return false;
    }
    window.floodFrom(seedX - lowX, seedY - lowY, seedZ - lowZ);
    sum(nodes);
    return true;
  }

  @Override
  public boolean holdsFor(int seedX, int seedY, int seedZ) {
    return empty || window.holdsFor(seedX - lowX, seedY - lowY, seedZ - lowZ);
  }

  private void sum(double[] nodes) {
    for (int z = 0; z < BitWindow.EDGE; z++) {
      long unreached = 0;
      for (int word = 0; word < BitWindow.WORDS; word++) {
        long fourRows = window.unreached(z, word);
        unreached |= fourRows;
        sumRows(fourRows, 4 * word);
      }
      columns[0][z] = unreached == 0 ? 0 : alongY.weigh(rows, 0);
      columns[1][z] = unreached == 0 ? 0 : alongY.weigh(rows, 1);
      columns[2][z] = unreached == 0 ? 0 : alongY.weigh(rows, 2);
    }
    for (int z = 0; z < 3; z++) {
      for (int y = 0; y < 3; y++) {
        unpack(alongZ.weigh(columns[y], z), 9 * z + 3 * y, nodes);
      }
    }
  }

  private void sumRows(long fourRows, int at) {
    rows[at] = sumsOfRow[(int) fourRows & ROW_MASK];
    rows[at + 1] = sumsOfRow[(int) (fourRows >>> 16) & ROW_MASK];
    rows[at + 2] = sumsOfRow[(int) (fourRows >>> 32) & ROW_MASK];
    rows[at + 3] = sumsOfRow[(int) (fourRows >>> 48) & ROW_MASK];
  }

  private void unpack(long sums, int at, double[] nodes) {
    double scale = kernel.scale();
    nodes[at] = (sums & SUM_MASK) * scale;
    nodes[at + 1] = (sums >>> SUM_BITS & SUM_MASK) * scale;
    nodes[at + 2] = (sums >>> (2 * SUM_BITS)) * scale;
  }

  /** Weighs twelve values by the taps of an axis, for one of three nodes. */
  private static final class AxisTaps {
    private final long tap0;
    private final long tap1;
    private final long tap2;
    private final long tap3;
    private final long tap4;

    AxisTaps(SmoothingKernel kernel, int axis) {
      tap0 = kernel.tap(axis, 0);
      tap1 = kernel.tap(axis, 1);
      tap2 = kernel.tap(axis, 2);
      tap3 = kernel.tap(axis, 3);
      tap4 = kernel.tap(axis, 4);
    }

    long weigh(long[] values, int node) {
      return tap0 * (values[node] + values[node + 9])
          + tap1 * (values[node + 1] + values[node + 8])
          + tap2 * (values[node + 2] + values[node + 7])
          + tap3 * (values[node + 3] + values[node + 6])
          + tap4 * (values[node + 4] + values[node + 5]);
    }
  }

  @Override
  public void forget() {
    window.forget();
  }

  @Override
  public double sigmaEdges(int axis) {
    return kernel.sigmaEdges(axis);
  }
}
