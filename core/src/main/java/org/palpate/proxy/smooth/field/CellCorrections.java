package org.palpate.proxy.smooth.field;

import java.util.Arrays;
import org.palpate.collision.CollisionScene;

/**
 * Corrections of a window of bits: the occupancy of each cell less its bit, summed up over each row
 * along x. A column of a thin slice may end within a cell, which is then only partly solid.
 *
 * <p>A correction counts only if the seed reaches the cell or one beside it along the last cut.
 * Otherwise its empty part counts as solid, like empty cells that the seed does not reach.
 */
final class CellCorrections {
  private static final int EDGE = BinaryWindow.EDGE;

  /** The masks of a brick that begins up to three cells before a window, or in it. */
  private static final int MASKS = EDGE + 3;

  private static final long[] MASK_X = masks(1);
  private static final long[] MASK_Y = masks(4);
  private static final long[] MASK_Z = masks(16);

  private final ThinSlices thin;
  private final BinaryWindow window;

  /** For each cell along x, the packed taps with which it adds to the three sums of its row. */
  private final long[] weights;

  /** The packed sums of each row, y fastest. */
  private final long[] rows = new long[EDGE * EDGE];

  /** The layers that hold a correction, a bit each. */
  private int layers;

  /**
   * Creates the corrections of thin slices.
   *
   * @param weights for each cell along x its packed taps
   */
  CellCorrections(ThinSlices thin, BinaryWindow window, long[] weights) {
    this.thin = thin;
    this.window = window;
    this.weights = weights;
  }

  /**
   * Returns for each offset of a brick the cells that lie in a window along an axis, a bit each.
   *
   * @param stride the distance of neighbouring cells along the axis in a brick's word, bits
   */
  private static long[] masks(int stride) {
    long[] masks = new long[MASKS];
    for (int n = 0; n < MASKS; n++) {
      for (int bit = 0; bit < Long.SIZE; bit++) {
        int at = n - 3 + (bit / stride & 3);
        masks[n] |= at >= 0 && at < EDGE ? 1L << bit : 0;
      }
    }
    return masks;
  }

  /** Reads the corrections of the cells of the window as it was loaded last. */
  void read(CollisionScene scene) {
    if (layers != 0) {
      Arrays.fill(rows, 0);
      layers = 0;
    }
    int lowX = window.lowX();
    int lowY = window.lowY();
    int lowZ = window.lowZ();
    for (int z = lowZ & ~3; z < lowZ + EDGE; z += 4) {
      for (int y = lowY & ~3; y < lowY + EDGE; y += 4) {
        long inside = MASK_Y[y - lowY + 3] & MASK_Z[z - lowZ + 3];
        for (int x = lowX & ~3; x < lowX + EDGE; x += 4) {
          int slot = thin.slotOf(scene, x >> 2, y >> 2, z >> 2);
          long cells = thin.corrected(slot) & inside & MASK_X[x - lowX + 3];
          if (cells != 0) {
            add(slot, cells, x - lowX, y - lowY, z - lowZ);
          }
        }
      }
    }
  }

  /** Adds the corrections of some cells of a brick that begins at a cell of the window. */
  private void add(int slot, long cells, int brickX, int brickY, int brickZ) {
    boolean all = !window.anyUnreached();
    for (long left = cells; left != 0; left &= left - 1) {
      int bit = Long.numberOfTrailingZeros(left);
      int x = brickX + (bit & 3);
      int y = brickY + (bit >> 2 & 3);
      int z = brickZ + (bit >> 4);
      if (all || window.isBesideReached(x, y, z, thin.axis())) {
        rows[EDGE * z + y] += thin.correction(slot, bit) * weights[x];
        layers |= 1 << z;
      }
    }
  }

  /** Whether any cell of a layer is corrected. */
  boolean anyInLayer(int z) {
    return (layers >>> z & 1) != 0;
  }

  /** Returns what the cells of a row add to its three packed sums. */
  long ofRow(int y, int z) {
    return rows[EDGE * z + y];
  }
}
