package org.palpate.volume;

/**
 * The gradients of the levels of eight voxels side by side along x, see {@link
 * ScalarVolume#levels}: differences over two voxels, weighed 1, 2, 1 along both other axes.
 *
 * <p>Four voxels are weighed at once, in the four 16-bit lanes of a word. One thread; allocates
 * nothing after construction.
 */
public final class LevelGradients {
  /** The rows of three by three around the eight voxels, y fastest. */
  public static final int ROWS = 9;

  private static final int EDGE = ScalarVolume.LEVELS;
  private static final long EVEN_BYTES = 0x00FF_00FF_00FF_00FFL;
  private static final int LANE = 0xFFFF;
  private static final int LANE_BITS = 16;

  /** Keeps differences positive: at least 4 times a byte. */
  private static final int BIAS = 1024;

  private static final long BIASES = BIAS * 0x0001_0001_0001_0001L;

  private final long[] own = new long[ROWS];
  private final long[] before = new long[ROWS];
  private final long[] behind = new long[ROWS];

  /** The weighed sums over y and z, of the voxel before, the eight, and the one behind. */
  private final int[] sums = new int[EDGE + 2];

  /** The differences along y, weighed along z, with {@link #BIAS}. */
  private final int[] alongY = new int[EDGE + 2];

  /** The differences along z, weighed along y, with {@link #BIAS}. */
  private final int[] alongZ = new int[EDGE + 2];

  /**
   * Sets a row of levels, eight in a word.
   *
   * @param row the number of the row, y fastest; the eight voxels are in row 4
   * @param wordBefore the eight levels before, of use for the gradient of the first voxel alone
   * @param word the levels beside the eight voxels, or their own
   * @param wordBehind the eight levels behind, of use for the gradient of the last voxel alone
   */
  public void set(int row, long wordBefore, long word, long wordBehind) {
    before[row] = wordBefore;
    own[row] = word;
    behind[row] = wordBehind;
  }

  /** Finds the gradients after all rows were set. */
  public void find() {
    weigh(before, EDGE - 1, 0, 1);
    weigh(own, 0, 1, 4);
    weigh(own, 1, 2, 4);
    weigh(behind, 0, EDGE + 1, 1);
  }

  /**
   * Weighs every other byte of nine rows.
   *
   * @param first the first byte
   * @param to where its sums go; those of others go two places on each
   * @param count the number of bytes
   */
  private void weigh(long[] rows, int first, int to, int count) {
    int shift = Byte.SIZE * first;
    long lowY = lanes(rows, 0, shift) + 2 * lanes(rows, 3, shift) + lanes(rows, 6, shift);
    long midY = lanes(rows, 1, shift) + 2 * lanes(rows, 4, shift) + lanes(rows, 7, shift);
    long highY = lanes(rows, 2, shift) + 2 * lanes(rows, 5, shift) + lanes(rows, 8, shift);
    long lowZ = lanes(rows, 0, shift) + 2 * lanes(rows, 1, shift) + lanes(rows, 2, shift);
    long highZ = lanes(rows, 6, shift) + 2 * lanes(rows, 7, shift) + lanes(rows, 8, shift);
    long sum = lowY + 2 * midY + highY;
    long differenceY = highY + BIASES - lowY;
    long differenceZ = highZ + BIASES - lowZ;
    for (int n = 0; n < count; n++) {
      int lane = LANE_BITS * n;
      sums[to + 2 * n] = (int) (sum >>> lane) & LANE;
      alongY[to + 2 * n] = (int) (differenceY >>> lane) & LANE;
      alongZ[to + 2 * n] = (int) (differenceZ >>> lane) & LANE;
    }
  }

  private static long lanes(long[] rows, int row, int shift) {
    return rows[row] >>> shift & EVEN_BYTES;
  }

  /**
   * {@return the gradient along x, in a unit that all axes share}
   *
   * @param n the number of the voxel, 0 to 7
   */
  public int x(int n) {
    return sums[n + 2] - sums[n];
  }

  /**
   * {@return the gradient along y, in a unit that all axes share}
   *
   * @param n the number of the voxel, 0 to 7
   */
  public int y(int n) {
    return alongY[n] + 2 * alongY[n + 1] + alongY[n + 2] - 4 * BIAS;
  }

  /**
   * {@return the gradient along z, in a unit that all axes share}
   *
   * @param n the number of the voxel, 0 to 7
   */
  public int z(int n) {
    return alongZ[n] + 2 * alongZ[n + 1] + alongZ[n + 2] - 4 * BIAS;
  }
}
