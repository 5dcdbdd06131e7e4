package org.palpate.proxy.smooth.field;

import java.util.Arrays;
import java.util.List;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.IntBox;

/**
 * Computes the B-spline coefficients of an {@link OccupancyField} from voxels without grey values.
 * A coefficient is the sum of the voxels of a {@link BinaryWindow} that count as solid, each times
 * the filter taps of the {@link SmoothingKernel} along the three axes.
 *
 * <p>The sums of three neighbouring coefficients along x are packed into one word.
 */
final class BinaryCoefficientSource implements CoefficientSource {
  /** The bits for one of three sums in a word; no sum of taps is above 30 * 30 * 30. */
  private static final int SUM_BITS = 21;

  private static final long SUM_MASK = (1L << SUM_BITS) - 1;

  /** The second sums of 0 to 12 values, and one before them, which is 0 as well. */
  private static final int SUMS = BinaryWindow.EDGE + 2;

  private static final int ROW_MASK = (1 << BinaryWindow.EDGE) - 1;

  /** The term that is added to each sum, so that corrections leave none negative. */
  private static final long SUM_BIAS = 1L << (SUM_BITS - 3);

  private static final long BIASES = SUM_BIAS | SUM_BIAS << SUM_BITS | SUM_BIAS << (2 * SUM_BITS);

  private final SmoothingKernel kernel;
  private final BinaryWindow window;

  /** The occupancies of cells less their bits. */
  private final CellCorrections corrections;

  private final double scale;

  /** The three packed sums along x of every row of 12 voxels. */
  private final long[] sumsOfRow = new long[1 << BinaryWindow.EDGE];

  /** The second sums over the rows of a layer. */
  private final long[] rowsTwice = new long[SUMS];

  /** The sum that a layer of solid voxels adds to each coefficient. */
  private final long wholeLayer;

  /** The second sums over the layers, for each of three coefficients along y. */
  private final long[][] layersTwice = new long[3][SUMS];

  private final AxisTaps alongY;
  private final AxisTaps alongZ;

  /**
   * Creates a source over the cells of a window.
   *
   * @param kernel the smoothing of these cells
   * @param corrected the corrections of cells that are solid in part
   */
  BinaryCoefficientSource(
      SmoothingKernel kernel, BinaryWindow window, List<CellCorrections.Source> corrected) {
    this.kernel = kernel;
    this.window = window;
    corrections = new CellCorrections(corrected, window, weights());
    int unit = CellCorrections.FRACTIONS;
    scale = kernel.scale() / unit;
    alongY = new AxisTaps(kernel, 1);
    alongZ = new AxisTaps(kernel, 2);
    for (int row = 0; row <= ROW_MASK; row++) {
      sumsOfRow[row] = unit * sumsOf(row);
    }
    sumLayer(BinaryWindow.ROW_MASK, BinaryWindow.ROW_MASK, BinaryWindow.ROW_MASK);
    wholeLayer = alongY.weigh(rowsTwice, 0);
  }

  /** Returns for each cell of a row its taps for the three sums along x, packed. */
  private long[] weights() {
    long[] weights = new long[BinaryWindow.EDGE];
    Arrays.setAll(weights, x -> sumsOf(1 << x));
    return weights;
  }

  /** Returns the three sums along x of a row of solid cells, packed. */
  private long sumsOf(int row) {
    long packed = 0;
    for (int n = 0; n < 3; n++) {
      long sum = 0;
      for (int tap = 0; tap < SmoothingKernel.TAPS; tap++) {
        sum += (row >> (n + tap) & 1L) * kernel.tap(0, tap);
      }
      packed |= sum << (SUM_BITS * n);
    }
    return packed;
  }

  @Override
  public boolean load(
      CollisionScene scene, int x, int y, int z, SeedCell seed, double[] coefficients) {
    window.loadAround(scene, x, y, z);
    if (!window.anySolid()) {
      return false;
    }
    window.floodFrom(seed);
    corrections.read(scene);
    weigh(coefficients);
    return true;
  }

  @Override
  public boolean holdsFor(SeedCell seed) {
    return window.holdsFor(seed);
  }

  @Override
  public boolean holdsForEverySeed() {
    return window.holdsForEverySeed();
  }

  /**
   * Weighs the window by second sums. The convolution of boxes of w and m voxels is the second
   * difference, w and m voxels apart, of what was summed up twice. So each row is added twice, and
   * no tap multiplies.
   */
  private void weigh(double[] coefficients) {
    long[] reached = window.reachedWords();
    long once0 = 0;
    long once1 = 0;
    long once2 = 0;
    for (int z = 0; z < BinaryWindow.EDGE; z++) {
      long a = reached[BinaryWindow.WORDS * z];
      long b = reached[BinaryWindow.WORDS * z + 1];
      long c = reached[BinaryWindow.WORDS * z + 2];
      if (corrections.anyInLayer(z)) {
        sumCorrectedLayer(z, ~a, ~b, ~c);
        once0 += alongY.weigh(rowsTwice, 0);
        once1 += alongY.weigh(rowsTwice, 1);
        once2 += alongY.weigh(rowsTwice, 2);
      } else if ((a | b | c) == 0) {
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
        unpack(alongZ.weigh(layersTwice[y], z), 9 * z + 3 * y, coefficients);
      }
    }
  }

  /** Sums up the rows of a layer twice; the three words hold its solid voxels. */
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

  /** Sums up the rows of a layer of which some cells are corrected. */
  private void sumCorrectedLayer(int z, long a, long b, long c) {
    long[] twice = rowsTwice;
    long[] more = corrections.ofRows();
    int at = BinaryWindow.EDGE * z;
    long once = sumsOfRow[(int) a & ROW_MASK] + more[at];
    long all = once;
    twice[2] = all;
    twice[3] = all += once += sumsOfRow[(int) (a >>> 16) & ROW_MASK] + more[at + 1];
    twice[4] = all += once += sumsOfRow[(int) (a >>> 32) & ROW_MASK] + more[at + 2];
    twice[5] = all += once += sumsOfRow[(int) (a >>> 48) & ROW_MASK] + more[at + 3];
    twice[6] = all += once += sumsOfRow[(int) b & ROW_MASK] + more[at + 4];
    twice[7] = all += once += sumsOfRow[(int) (b >>> 16) & ROW_MASK] + more[at + 5];
    twice[8] = all += once += sumsOfRow[(int) (b >>> 32) & ROW_MASK] + more[at + 6];
    twice[9] = all += once += sumsOfRow[(int) (b >>> 48) & ROW_MASK] + more[at + 7];
    twice[10] = all += once += sumsOfRow[(int) c & ROW_MASK] + more[at + 8];
    twice[11] = all += once += sumsOfRow[(int) (c >>> 16) & ROW_MASK] + more[at + 9];
    twice[12] = all += once += sumsOfRow[(int) (c >>> 32) & ROW_MASK] + more[at + 10];
    twice[13] = all + once + sumsOfRow[(int) (c >>> 48) & ROW_MASK] + more[at + 11];
  }

  private void unpack(long sums, int at, double[] coefficients) {
    long biased = sums + BIASES;
    coefficients[at] = ((biased & SUM_MASK) - SUM_BIAS) * scale;
    coefficients[at + 1] = ((biased >>> SUM_BITS & SUM_MASK) - SUM_BIAS) * scale;
    coefficients[at + 2] = ((biased >>> (2 * SUM_BITS)) - SUM_BIAS) * scale;
  }

  /** Weighs twelve values by the taps of an axis, given their second sums. */
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

    /**
     * Returns the weighed sum for coefficient {@code n} of three.
     *
     * @param twice the second sums of the values v: element k + 1 is k v0 + (k - 1) v1 + ... + v(k
     *     - 1)
     */
    long weigh(long[] twice, int n) {
      return twice[n + high] - twice[n + second] - twice[n + first] + twice[n + low];
    }
  }

  @Override
  public long columns() {
    return corrections.columns();
  }

  @Override
  public void forget() {
    corrections.forget();
    window.forget();
  }

  @Override
  public void forget(IntBox changed) {
    window.forget(changed); // makes cells of the voxels
    corrections.forget(changed);
  }

  @Override
  public double sigmaEdges(int axis) {
    return kernel.sigmaEdges(axis);
  }
}
