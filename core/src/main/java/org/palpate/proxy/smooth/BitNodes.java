package org.palpate.proxy.smooth;

import org.palpate.proxy.Obstacles;

/** Corner values from the bits alone. */
final class BitNodes implements NodeSource {
  /** Bits for one of three sums in a word; no sum of taps is above 20 * 20 * 20. */
  private static final int SUM_BITS = 21;

  private static final long SUM_MASK = (1L << SUM_BITS) - 1;

  /** From the window's low voxel to its middle corner. */
  private static final int TO_MIDDLE = BitWindow.EDGE / 2;

  private final SmoothingKernel kernel;
  private final BitWindow window = new BitWindow();
  private final long[] sumsOfRow = new long[1 << BitWindow.EDGE];
  private final long[] rows = new long[BitWindow.EDGE];
  private final long[][] columns = new long[3][BitWindow.EDGE];
  private final long[] sums = new long[3];
  private int lowX;
  private int lowY;
  private int lowZ;
  private boolean empty;

  BitNodes(SmoothingKernel kernel) {
    this.kernel = kernel;
    for (int row = 0; row < sumsOfRow.length; row++) {
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
    if (isInWindow(seedX, seedY, seedZ)
        && window.isFree(seedX - lowX, seedY - lowY, seedZ - lowZ)) {
      window.flood(seedX - lowX, seedY - lowY, seedZ - lowZ);
    }
    sum(nodes);
    return true;
  }

  @Override
  public boolean holdsFor(int seedX, int seedY, int seedZ) {
    return empty
        || !isInWindow(seedX, seedY, seedZ)
        || window.isReached(seedX - lowX, seedY - lowY, seedZ - lowZ);
  }

  private boolean isInWindow(int i, int j, int k) {
    return i >= lowX
        && i < lowX + BitWindow.EDGE
        && j >= lowY
        && j < lowY + BitWindow.EDGE
        && k >= lowZ
        && k < lowZ + BitWindow.EDGE;
  }

  private void sum(double[] nodes) {
    for (int z = 0; z < BitWindow.EDGE; z++) {
      for (int y = 0; y < BitWindow.EDGE; y++) {
        rows[y] = sumsOfRow[window.unreachedRow(y, z)];
      }
      weigh(1, rows);
      columns[0][z] = sums[0];
      columns[1][z] = sums[1];
      columns[2][z] = sums[2];
    }
    double scale = kernel.scale();
    for (int y = 0; y < 3; y++) {
      weigh(2, columns[y]);
      for (int z = 0; z < 3; z++) {
        int at = 9 * z + 3 * y;
        nodes[at] = (sums[z] & SUM_MASK) * scale;
        nodes[at + 1] = (sums[z] >>> SUM_BITS & SUM_MASK) * scale;
        nodes[at + 2] = (sums[z] >>> (2 * SUM_BITS)) * scale;
      }
    }
  }

  /** Weighs ten values by the taps of an axis, for three nodes at once. */
  private void weigh(int axis, long[] values) {
    long tap0 = kernel.tap(axis, 0);
    long tap1 = kernel.tap(axis, 1);
    long tap2 = kernel.tap(axis, 2);
    long tap3 = kernel.tap(axis, 3);
    for (int node = 0; node < 3; node++) {
      sums[node] =
          tap0 * (values[node] + values[node + 7])
              + tap1 * (values[node + 1] + values[node + 6])
              + tap2 * (values[node + 2] + values[node + 5])
              + tap3 * (values[node + 3] + values[node + 4]);
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
