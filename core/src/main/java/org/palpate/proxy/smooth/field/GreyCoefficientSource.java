package org.palpate.proxy.smooth.field;

import org.palpate.collision.CollisionScene;

/**
 * Corner values from grey values where the bits are what a threshold made of them, and from the
 * bits where an edit changed them: a voxel that is solid against its grey value is wholly solid,
 * one that is empty against it wholly empty.
 *
 * <p>Shares are whole numbers to {@link GreyOccupancyCache#WHOLE}; four are weighed at a time, side
 * by side in a word.
 */
public final class GreyCoefficientSource implements CoefficientSource {
  /** Voxels along an edge of the window that is weighed. */
  private static final int EDGE = GreyOccupancyCache.EDGE;

  /** From the low voxel of the window of bits to that of the window that is weighed. */
  private static final int INSET = (BinaryWindow.EDGE - EDGE) / 2;

  private static final int TO_MIDDLE = BinaryWindow.EDGE / 2;

  private static final int FIRST_TAP = (SmoothingKernel.TAPS - 6) / 2;

  /**
   * Every other byte: four lanes of 16 bits. Relies on taps of two axes adding up to 257 at most.
   */
  private static final long EVEN_BYTES = 0x00FF_00FF_00FF_00FFL;

  private static final int LANE = 0xFFFF;

  private final SmoothingKernel kernel;
  private final GreyOccupancyCache shares;
  private final BinaryWindow window = new BinaryWindow();
  private final double scale;

  /** The shares of the window, a row a word, y fastest. */
  private final long[] rows = new long[EDGE * EDGE];

  /** Weighed along z, for each of three nodes: a row of even voxels, one of odd ones, y fastest. */
  private final long[] even = new long[3 * EDGE];

  private final long[] odd = new long[3 * EDGE];
  private int lowX;
  private int lowY;
  private int lowZ;
  private boolean empty;

  public GreyCoefficientSource(SmoothingKernel kernel, GreyIsosurfaceSource grey) {
    this.kernel = kernel;
    shares = new GreyOccupancyCache(grey);
    scale = kernel.scale() / GreyOccupancyCache.WHOLE;
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
    shares.read(obstacles, lowX + INSET, lowY + INSET, lowZ + INSET, rows);
    if (window.anyUnreached()) {
      fillUnreached();
    }
    weighAlongZ();
    for (int node = 0; node < 9; node++) {
      int at = node / 3 * EDGE;
      weighAlongX(weigh(1, even, at, 1, node % 3), weigh(1, odd, at, 1, node % 3), 3 * node, nodes);
    }
    return true;
  }

  /** What cannot be reached counts as wholly solid. */
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
    for (int node = 0; node < 3; node++) {
      for (int j = 0; j < EDGE; j++) {
        even[EDGE * node + j] = weighEven(j, node);
        odd[EDGE * node + j] = weighOdd(j, node);
      }
    }
  }

  private long weighEven(int j, int node) {
    int at = EDGE * node + j;
    return kernel.tap(2, FIRST_TAP) * ((rows[at] & EVEN_BYTES) + (rows[at + 5 * EDGE] & EVEN_BYTES))
        + kernel.tap(2, FIRST_TAP + 1)
            * ((rows[at + EDGE] & EVEN_BYTES) + (rows[at + 4 * EDGE] & EVEN_BYTES))
        + kernel.tap(2, FIRST_TAP + 2)
            * ((rows[at + 2 * EDGE] & EVEN_BYTES) + (rows[at + 3 * EDGE] & EVEN_BYTES));
  }

  private long weighOdd(int j, int node) {
    int at = EDGE * node + j;
    return kernel.tap(2, FIRST_TAP)
            * ((rows[at] >>> 8 & EVEN_BYTES) + (rows[at + 5 * EDGE] >>> 8 & EVEN_BYTES))
        + kernel.tap(2, FIRST_TAP + 1)
            * ((rows[at + EDGE] >>> 8 & EVEN_BYTES) + (rows[at + 4 * EDGE] >>> 8 & EVEN_BYTES))
        + kernel.tap(2, FIRST_TAP + 2)
            * ((rows[at + 2 * EDGE] >>> 8 & EVEN_BYTES) + (rows[at + 3 * EDGE] >>> 8 & EVEN_BYTES));
  }

  /** The weighed sum of six values, lane by lane. */
  private long weigh(int axis, long[] values, int at, int stride, int node) {
    int from = at + stride * node;
    return kernel.tap(axis, FIRST_TAP) * (values[from] + values[from + 5 * stride])
        + kernel.tap(axis, FIRST_TAP + 1) * (values[from + stride] + values[from + 4 * stride])
        + kernel.tap(axis, FIRST_TAP + 2) * (values[from + 2 * stride] + values[from + 3 * stride]);
  }

  /** Three nodes of a row whose even and odd voxels are lanes. */
  private void weighAlongX(long evenLanes, long oddLanes, int at, double[] nodes) {
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
    nodes[at] = scale * (outer * (v0 + v5) + middle * (v1 + v4) + inner * (v2 + v3));
    nodes[at + 1] = scale * (outer * (v1 + v6) + middle * (v2 + v5) + inner * (v3 + v4));
    nodes[at + 2] = scale * (outer * (v2 + v7) + middle * (v3 + v6) + inner * (v4 + v5));
  }

  @Override
  public boolean holdsFor(int seedX, int seedY, int seedZ) {
    return empty || window.holdsFor(seedX - lowX, seedY - lowY, seedZ - lowZ);
  }

  @Override
  public void forget() {
    window.forget();
    shares.forget();
  }

  @Override
  public double sigmaEdges(int axis) {
    return kernel.sigmaEdges(axis);
  }
}
