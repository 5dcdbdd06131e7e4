package org.palpate.proxy.smooth;

import org.palpate.proxy.Obstacles;
import org.palpate.volume.VoxelGrid;

/**
 * Corner values from grey values where the bits are what a threshold made of them, and from the
 * bits where an edit changed them: a voxel that is solid against its grey value is wholly solid,
 * one that is empty against it wholly empty.
 */
final class GreyNodes implements NodeSource {
  /** Voxels along an edge of the window that is weighed. */
  private static final int EDGE = 8;

  /** From the low voxel of the window of bits to that of the window that is weighed. */
  private static final int INSET = (BitWindow.EDGE - EDGE) / 2;

  private static final int TO_MIDDLE = BitWindow.EDGE / 2;

  /** The share at the threshold. */
  private static final double HALF = 0.5;

  private static final int TAPS = 6;
  private static final int FIRST_TAP = (SmoothingKernel.TAPS - TAPS) / 2;

  private final SmoothingKernel kernel;
  private final ShareCache shares;
  private final VoxelGrid grid;
  private final BitWindow window = new BitWindow();
  private final double[] row = new double[EDGE];
  private final double[] alongX = new double[3 * EDGE];
  private final double[] alongXy = new double[9 * EDGE];
  private int lowX;
  private int lowY;
  private int lowZ;
  private boolean empty;

  GreyNodes(SmoothingKernel kernel, LiveGrey grey) {
    this.kernel = kernel;
    shares = new ShareCache(grey);
    grid = grey.grid();
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
    for (int k = 0; k < EDGE; k++) {
      sumLayer(k);
    }
    for (int n = 0; n < 9; n++) {
      for (int z3 = 0; z3 < 3; z3++) {
        nodes[9 * z3 + n] = weigh(2, alongXy, EDGE * n + z3) * kernel.scale();
      }
    }
    return true;
  }

  private void sumLayer(int k) {
    for (int j = 0; j < EDGE; j++) {
      readRow(j, k);
      for (int x = 0; x < 3; x++) {
        alongX[EDGE * x + j] = weigh(0, row, x);
      }
    }
    for (int x = 0; x < 3; x++) {
      for (int y = 0; y < 3; y++) {
        alongXy[EDGE * (3 * y + x) + k] = weigh(1, alongX, EDGE * x + y);
      }
    }
  }

  private double weigh(int axis, double[] values, int from) {
    return kernel.tap(axis, FIRST_TAP) * (values[from] + values[from + 5])
        + kernel.tap(axis, FIRST_TAP + 1) * (values[from + 1] + values[from + 4])
        + kernel.tap(axis, FIRST_TAP + 2) * (values[from + 2] + values[from + 3]);
  }

  private void readRow(int j, int k) {
    int y = j + INSET;
    int z = k + INSET;
    for (int i = 0; i < EDGE; i++) {
      int x = i + INSET;
      if (window.isFree(x, y, z)) {
        row[i] = window.isReached(x, y, z) ? shareOfEmpty(x, y, z) : 1;
      } else {
        row[i] = shareOfSolid(x, y, z);
      }
    }
  }

  private double shareOfEmpty(int x, int y, int z) {
    if (!grid.contains(lowX + x, lowY + y, lowZ + z)) {
      return 0;
    }
    double share = shares.share(lowX + x, lowY + y, lowZ + z);
    return share <= HALF ? share : 0;
  }

  private double shareOfSolid(int x, int y, int z) {
    double share = shares.share(lowX + x, lowY + y, lowZ + z);
    return share >= HALF ? share : 1;
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
