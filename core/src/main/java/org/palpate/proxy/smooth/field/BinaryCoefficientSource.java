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

  /** The second sums of the values that are weighed. */
  private final long[] twice = new long[SUMS];

  /** The sum that a layer of solid voxels adds to each coefficient. */
  private final long wholeLayer;

  /** For each of three coefficients along y, the packed sums of each layer. */
  private final long[] layers = new long[3 * BinaryWindow.EDGE];

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
    weighByAnyBoxes(0, BinaryWindow.ROW_MASK, BinaryWindow.ROW_MASK, BinaryWindow.ROW_MASK, false);
    wholeLayer = layers[0];
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

  /** Weighs the window along y, layer by layer, and then along z. */
  private void weigh(double[] coefficients) {
    long[] reached = window.reachedWords();
    for (int z = 0; z < BinaryWindow.EDGE; z++) {
      long a = reached[BinaryWindow.WORDS * z];
      long b = reached[BinaryWindow.WORDS * z + 1];
      long c = reached[BinaryWindow.WORDS * z + 2];
      boolean corrected = corrections.anyInLayer(z);
      if (!corrected && (a | b | c) == 0) {
        setLayer(z, wholeLayer);
      } else if (!corrected && (a & b & c) == BinaryWindow.ROW_MASK) {
        setLayer(z, 0);
      } else if (alongY.areWidest()) {
        weighByWidestBoxes(z, ~a, ~b, ~c, corrected);
      } else {
        weighByAnyBoxes(z, ~a, ~b, ~c, corrected);
      }
    }
    for (int y = 0; y < 3; y++) {
      int from = BinaryWindow.EDGE * y;
      long once = 0;
      long all = 0;
      for (int z = 0; z < BinaryWindow.EDGE; z++) {
        once += layers[from + z];
        all += once;
        twice[z + 2] = all;
      }
      for (int z = 0; z < 3; z++) {
        unpack(alongZ.weigh(twice, z), 9 * z + 3 * y, coefficients);
      }
    }
  }

  private void setLayer(int z, long sum) {
    layers[z] = sum;
    layers[z + BinaryWindow.EDGE] = sum;
    layers[z + 2 * BinaryWindow.EDGE] = sum;
  }

  /** Weighs the rows of a layer along y; the three words hold its solid voxels. */
  private void weighByAnyBoxes(int z, long a, long b, long c, boolean corrected) {
    long once = 0;
    long all = 0;
    for (int y = 0; y < BinaryWindow.EDGE; y++) {
      long word = y < 4 ? a : y < 8 ? b : c;
      once += sumsOfRow[(int) (word >>> ((y & 3) << 4)) & ROW_MASK];
      if (corrected) {
        once += corrections.ofRows()[BinaryWindow.EDGE * z + y];
      }
      all += once;
      twice[y + 2] = all;
    }
    for (int y = 0; y < 3; y++) {
      layers[BinaryWindow.EDGE * y + z] = alongY.weigh(twice, y);
    }
  }

  /**
   * Does the same for boxes of six and five voxels, whose taps are 1, 2, 3, 4, 5, 5, 4, 3, 2 and 1.
   * All rows are in local variables, which takes half the time. From one coefficient to the next
   * every tap changes by one at most, so the sums of five rows on either side are the difference.
   */
  private void weighByWidestBoxes(int z, long a, long b, long c, boolean corrected) {
    long[] sums = sumsOfRow;
    int mask = sums.length - 1; // as the array's length gives it, so that no index is checked
    long row0 = sums[(int) a & mask];
    long row1 = sums[(int) (a >>> 16) & mask];
    long row2 = sums[(int) (a >>> 32) & mask];
    long row3 = sums[(int) (a >>> 48) & mask];
    long row4 = sums[(int) b & mask];
    long row5 = sums[(int) (b >>> 16) & mask];
    long row6 = sums[(int) (b >>> 32) & mask];
    long row7 = sums[(int) (b >>> 48) & mask];
    long row8 = sums[(int) c & mask];
    long row9 = sums[(int) (c >>> 16) & mask];
    long row10 = sums[(int) (c >>> 32) & mask];
    long row11 = sums[(int) (c >>> 48) & mask];
    if (corrected) {
      long[] more = corrections.ofRows();
      int at = BinaryWindow.EDGE * z;
      row0 += more[at];
      row1 += more[at + 1];
      row2 += more[at + 2];
      row3 += more[at + 3];
      row4 += more[at + 4];
      row5 += more[at + 5];
      row6 += more[at + 6];
      row7 += more[at + 7];
      row8 += more[at + 8];
      row9 += more[at + 9];
      row10 += more[at + 10];
      row11 += more[at + 11];
    }
    long once = row4 + row5;
    long sum = once;
    sum += once += row3 + row6;
    sum += once += row2 + row7;
    sum += once += row1 + row8;
    sum += once + row0 + row9;
    long low = row1 + row2 + row3 + row4;
    long high = row7 + row8 + row9 + row10;
    layers[z] = sum;
    sum += row6 + high - (row0 + low);
    layers[BinaryWindow.EDGE + z] = sum;
    sum += high + row11 - (low + row5);
    layers[2 * BinaryWindow.EDGE + z] = sum;
  }

  private void unpack(long sums, int at, double[] coefficients) {
    long biased = sums + BIASES;
    coefficients[at] = ((biased & SUM_MASK) - SUM_BIAS) * scale;
    coefficients[at + 1] = ((biased >>> SUM_BITS & SUM_MASK) - SUM_BIAS) * scale;
    coefficients[at + 2] = ((biased >>> (2 * SUM_BITS)) - SUM_BIAS) * scale;
  }

  /**
   * Weighs twelve values by the taps of an axis, given their second sums. The convolution of boxes
   * of w and m voxels is the second difference, w and m voxels apart, of what was summed up twice.
   * So no tap multiplies.
   */
  private static final class AxisTaps {
    /** The width of the narrower one of the widest two boxes. */
    private static final int WIDEST = 5;

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

    /** Whether the boxes are six and five voxels wide. */
    boolean areWidest() {
      return first - low == WIDEST;
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
