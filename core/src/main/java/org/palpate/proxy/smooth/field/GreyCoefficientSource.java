package org.palpate.proxy.smooth.field;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.IntBox;

/**
 * Makes coefficients from grey values where the bits are what a threshold made of them, and from
 * the bits where an edit changed them.
 *
 * <p>Occupancies are whole numbers from 0 to {@link GreyOccupancyCache#WHOLE}. Four of them are
 * weighed at once, in the four 16-bit lanes of a word (SIMD within a register, SWAR).
 */
final class GreyCoefficientSource implements CoefficientSource {
  /** The edge of the window that is weighed, in voxels. */
  private static final int EDGE = GreyOccupancyCache.EDGE;

  /** The distance from the low voxel of the window of bits to that of the weighed window. */
  private static final int INSET = (BinaryWindow.EDGE - EDGE) / 2;

  /** The distance from the low voxel of the weighed window to the middle corner. */
  private static final int TO_MIDDLE = EDGE / 2;

  /** The first of six taps; those before and after are 0 for grey values. */
  private static final int FIRST_TAP = (SmoothingKernel.TAPS - 6) / 2;

  /**
   * Every other byte: four lanes of 16 bits. No lane overflows, because the taps of two axes add up
   * to 257 at most.
   */
  private static final long EVEN_BYTES = 0x00FF_00FF_00FF_00FFL;

  private static final int LANE = 0xFFFF;

  private final SmoothingKernel kernel;
  private final GreyOccupancyCache cache;
  private final BrickSource cells;
  private final BinaryWindow window;

  /** The voxels that changed: scratch. */
  private final IntBox changedVoxels = new IntBox();

  private final double scale;

  /** The occupancies of the window, a row in a word, y fastest. */
  private final long[] rows = new long[EDGE * EDGE];

  /** The sums along z of the even voxels of each row, for each of three coefficients, y fastest. */
  private final long[] even = new long[3 * EDGE];

  /** The same for the odd voxels. */
  private final long[] odd = new long[3 * EDGE];

  /**
   * Creates a source over the cells of a grid.
   *
   * @param kernel the smoothing of these cells
   * @param cells the bits of these cells
   * @param window a window of them
   */
  GreyCoefficientSource(
      SmoothingKernel kernel,
      ThinGrid grid,
      BrickSource cells,
      BinaryWindow window,
      GreyIsosurfaceSource grey) {
    this.kernel = kernel;
    this.cells = cells;
    this.window = window;
    cache = cache(grid, grey);
    scale = kernel.scale() / GreyOccupancyCache.WHOLE;
  }

  private static GreyOccupancyCache cache(ThinGrid grid, GreyIsosurfaceSource grey) {
    GreyOccupancyCache.Source source = new GreyVoxels(grey);
    for (AxisCut cut : grid.cuts()) {
      source = new ThinOccupancies(cut, source);
    }
    return new GreyOccupancyCache(source);
  }

  @Override
  public boolean load(
      CollisionScene scene, int x, int y, int z, SeedCell seed, double[] coefficients) {
    window.loadAround(scene, x, y, z);
    if (!window.anySolid()) {
      return false;
    }
    window.floodFrom(seed);
    cache.read(scene, x - TO_MIDDLE, y - TO_MIDDLE, z - TO_MIDDLE, rows);
    if (window.anyUnreached()) {
      fillUnreached();
    }
    weighAlongZ();
    for (int n = 0; n < 9; n++) {
      int from = n / 3 * EDGE + n % 3;
      weighAlongX(weighAlongY(even, from), weighAlongY(odd, from), 3 * n, coefficients);
    }
    return true;
  }

  /** Gives full occupancy to the empty voxels that the seed does not reach. */
  private void fillUnreached() {
    for (int k = 0; k < EDGE; k++) {
      for (int j = 0; j < EDGE; j++) {
        rows[EDGE * k + j] |=
            GreyOccupancyCache.bytesOf(
                window.unreachedOfRow(j + INSET, k + INSET) >>> INSET & 0xFF);
      }
    }
  }

  private void weighAlongZ() {
    for (int n = 0; n < 3; n++) {
      for (int j = 0; j < EDGE; j++) {
        even[EDGE * n + j] = weighEvenAlongZ(EDGE * n + j);
        odd[EDGE * n + j] = weighOddAlongZ(EDGE * n + j);
      }
    }
  }

  /** Returns the weighed sums of the even voxels of six rows, the first one at {@code from}. */
  private long weighEvenAlongZ(int from) {
    return kernel.tap(2, FIRST_TAP)
            * ((rows[from] & EVEN_BYTES) + (rows[from + 5 * EDGE] & EVEN_BYTES))
        + kernel.tap(2, FIRST_TAP + 1)
            * ((rows[from + EDGE] & EVEN_BYTES) + (rows[from + 4 * EDGE] & EVEN_BYTES))
        + kernel.tap(2, FIRST_TAP + 2)
            * ((rows[from + 2 * EDGE] & EVEN_BYTES) + (rows[from + 3 * EDGE] & EVEN_BYTES));
  }

  private long weighOddAlongZ(int from) {
    return kernel.tap(2, FIRST_TAP)
            * ((rows[from] >>> 8 & EVEN_BYTES) + (rows[from + 5 * EDGE] >>> 8 & EVEN_BYTES))
        + kernel.tap(2, FIRST_TAP + 1)
            * ((rows[from + EDGE] >>> 8 & EVEN_BYTES) + (rows[from + 4 * EDGE] >>> 8 & EVEN_BYTES))
        + kernel.tap(2, FIRST_TAP + 2)
            * ((rows[from + 2 * EDGE] >>> 8 & EVEN_BYTES)
                + (rows[from + 3 * EDGE] >>> 8 & EVEN_BYTES));
  }

  /** Returns the weighed sums of six words, the first one at {@code from}, lane by lane. */
  private long weighAlongY(long[] lanes, int from) {
    return kernel.tap(1, FIRST_TAP) * (lanes[from] + lanes[from + 5])
        + kernel.tap(1, FIRST_TAP + 1) * (lanes[from + 1] + lanes[from + 4])
        + kernel.tap(1, FIRST_TAP + 2) * (lanes[from + 2] + lanes[from + 3]);
  }

  /** Writes the three coefficients of a row whose even and odd voxels are lanes of two words. */
  private void weighAlongX(long evenLanes, long oddLanes, int at, double[] coefficients) {
    int v0 = (int) evenLanes & LANE;
    int v1 = (int) oddLanes & LANE;
    int v2 = (int) (evenLanes >>> 16) & LANE;
    int v3 = (int) (oddLanes >>> 16) & LANE;
    int v4 = (int) (evenLanes >>> 32) & LANE;
    int v5 = (int) (oddLanes >>> 32) & LANE;
    int v6 = (int) (evenLanes >>> 48);
    int v7 = (int) (oddLanes >>> 48);
    int outer = kernel.tap(0, FIRST_TAP);
    int middle = kernel.tap(0, FIRST_TAP + 1);
    int inner = kernel.tap(0, FIRST_TAP + 2);
    coefficients[at] = scale * (outer * (v0 + v5) + middle * (v1 + v4) + inner * (v2 + v3));
    coefficients[at + 1] = scale * (outer * (v1 + v6) + middle * (v2 + v5) + inner * (v3 + v4));
    coefficients[at + 2] = scale * (outer * (v2 + v7) + middle * (v3 + v6) + inner * (v4 + v5));
  }

  @Override
  public boolean holdsFor(SeedCell seed) {
    return window.holdsFor(seed);
  }

  @Override
  public boolean holdsForEverySeed() {
    return window.holdsForEverySeed();
  }

  @Override
  public long columns() {
    return cells.columns();
  }

  @Override
  public void forget() {
    window.forget();
    cache.forget();
  }

  @Override
  public void forget(IntBox changed) {
    changedVoxels.set(changed);
    window.forget(changed); // makes other cells of the voxels
    cache.forget(changedVoxels);
  }

  @Override
  public double sigmaEdges(int axis) {
    return kernel.sigmaEdges(axis);
  }
}
