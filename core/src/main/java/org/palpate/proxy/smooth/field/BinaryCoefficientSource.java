package org.palpate.proxy.smooth.field;

import org.palpate.collision.CollisionScene;

/** Corner values from the bits alone. */
public final class BinaryCoefficientSource implements CoefficientSource {
  /** Bits for one of three sums in a word; no sum of taps is above 30 * 30 * 30. */
  private static final int SUM_BITS = 21;

  private static final long SUM_MASK = (1L << SUM_BITS) - 1;

  /** From the window's low voxel to its middle corner. */
  private static final int TO_MIDDLE = BinaryWindow.EDGE / 2;

  /** Sums of sums of none to all twelve, and one before them, which is 0 as well. */
  private static final int SUMS = BinaryWindow.EDGE + 2;

  private static final int ROW_MASK = (1 << BinaryWindow.EDGE) - 1;

  private final SmoothingKernel kernel;
  private final BinaryWindow window = new BinaryWindow();
  private final long[] sumsOfRow = new long[1 << BinaryWindow.EDGE];
  private final long[] rowsTwice = new long[SUMS];

  /** What a layer of solid voxels alone adds, to each node alike. */
  private final long wholeLayer;

  private final long[][] layersTwice = new long[3][SUMS];
  private final AxisTaps alongY;
  private final AxisTaps alongZ;
  private int lowX;
  private int lowY;
  private int lowZ;
  private boolean empty;

  public BinaryCoefficientSource(SmoothingKernel kernel) {
    this.kernel = kernel;
    alongY = new AxisTaps(kernel, 1);
    alongZ = new AxisTaps(kernel, 2);
    for (int row = 0; row <= ROW_MASK; row++) {
      sumsOfRow[row] = sumsOf(row);
    }
    sumLayer(BinaryWindow.ROW_MASK, BinaryWindow.ROW_MASK, BinaryWindow.ROW_MASK);
    wholeLayer = alongY.weigh(rowsTwice, 0);
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
      CollisionScene obstacles,
      int x,
      int y,
      int z,
      int seedX,
      int seedY,
      int seedZ,
      double[] nodes) {
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

  /**
   * Weighs by sums of sums: a box of w taps on one of m is the second difference, m and w taps
   * apart, of what has been summed up twice. So each row is added twice, and no tap multiplies.
   */
  private void sum(double[] nodes) {
    long[] reached = window.reachedWords();
    long once0 = 0;
    long once1 = 0;
    long once2 = 0;
    for (int z = 0; z < BinaryWindow.EDGE; z++) {
      long a = reached[BinaryWindow.WORDS * z];
      long b = reached[BinaryWindow.WORDS * z + 1];
      long c = reached[BinaryWindow.WORDS * z + 2];
      if ((a | b | c) == 0) {
        once0 += wholeLayer;
        once1 += wholeLayer;
        once2 += wholeLayer;
      } else if ((a & b & c) != BinaryWindow.ROW_MASK) {
        sumLayer(~a, ~b, ~c);
        once0 += alongY.weigh(rowsTwice, 0);
        once1 += alongY.weigh(rowsTwice, 1);
        once2 += alongY.weigh(rowsTwice, 2);
      }
      layersTwice[0][z + 2] = layersTwice[0][z + 1] + once0;
      layersTwice[1][z + 2] = layersTwice[1][z + 1] + once1;
      layersTwice[2][z + 2] = layersTwice[2][z + 1] + once2;
    }
    for (int z = 0; z < 3; z++) {
      for (int y = 0; y < 3; y++) {
        unpack(alongZ.weigh(layersTwice[y], z), 9 * z + 3 * y, nodes);
      }
    }
  }

  /** Sums up the rows of a layer twice, of three words with its solid voxels. */
  private void sumLayer(long a, long b, long c) {
    long[] twice = rowsTwice;
    long once = sumsOfRow[(int) a & ROW_MASK];
    long all = once;
    twice[2] = all;
    twice[3] = all += once += sumsOfRow[(int) (a >>> 16) & ROW_MASK];
    twice[4] = all += once += sumsOfRow[(int) (a >>> 32) & ROW_MASK];
    twice[5] = all += once += sumsOfRow[(int) (a >>> 48) & ROW_MASK];
    twice[6] = all += once += sumsOfRow[(int) b & ROW_MASK];
    twice[7] = all += once += sumsOfRow[(int) (b >>> 16) & ROW_MASK];
    twice[8] = all += once += sumsOfRow[(int) (b >>> 32) & ROW_MASK];
    twice[9] = all += once += sumsOfRow[(int) (b >>> 48) & ROW_MASK];
    twice[10] = all += once += sumsOfRow[(int) c & ROW_MASK];
    twice[11] = all += once += sumsOfRow[(int) (c >>> 16) & ROW_MASK];
    twice[12] = all += once += sumsOfRow[(int) (c >>> 32) & ROW_MASK];
    twice[13] = all + once + sumsOfRow[(int) (c >>> 48) & ROW_MASK];
  }

  private void unpack(long sums, int at, double[] nodes) {
    double scale = kernel.scale();
    nodes[at] = (sums & SUM_MASK) * scale;
    nodes[at + 1] = (sums >>> SUM_BITS & SUM_MASK) * scale;
    nodes[at + 2] = (sums >>> (2 * SUM_BITS)) * scale;
  }

  /** Weighs twelve values, of which sums of sums are given, by the taps of an axis. */
  private static final class AxisTaps {
    private final int low;
    private final int first;
    private final int second;
    private final int high;

    AxisTaps(SmoothingKernel kernel, int axis) {
      low = kernel.firstTap(axis);
      first = low + kernel.narrowBox(axis);
      second = low + kernel.wideBox(axis);
      high = first + kernel.wideBox(axis);
    }

    /** The sum for one of three nodes; {@code twice[k+1]} is k v0 + (k-1) v1 + ... + v(k-1). */
    long weigh(long[] twice, int node) {
      return twice[node + high] - twice[node + second] - twice[node + first] + twice[node + low];
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
