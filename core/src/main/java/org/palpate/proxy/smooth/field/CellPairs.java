package org.palpate.proxy.smooth.field;

import java.util.Arrays;

/**
 * The pairs of slices between which cells lie, see {@link AxisCut}, for the four layers of cells of
 * a brick. Cached, because the divisions and roundings that find a pair would be a tenth of a
 * window's cost.
 */
final class CellPairs {
  private static final int SLOTS = 32;
  private static final int NONE = Integer.MIN_VALUE;

  private final AxisCut cut;

  /** The brick coordinate along the long axis that each slot holds. */
  private final int[] brick = new int[SLOTS];

  /** For each slot and layer the pair. */
  private final int[] pair = new int[4 * SLOTS];

  /** For each slot and layer the number of the cell within its pair. */
  private final byte[] inPair = new byte[4 * SLOTS];

  CellPairs(AxisCut cut) {
    this.cut = cut;
    Arrays.fill(brick, NONE);
  }

  /** Returns the slot that holds the layers of a brick from now on. */
  int slotOf(int w) {
    int slot = w & (SLOTS - 1);
    if (brick[slot] != w) {
      brick[slot] = w;
      for (int n = 0; n < 4; n++) {
        int of = cut.pairOf(4 * w + n);
        pair[4 * slot + n] = of;
        inPair[4 * slot + n] = (byte) (4 * w + n - cut.firstOfPair(of));
      }
    }
    return slot;
  }

  /** Returns the pair of a layer of cells, 0 to 3. */
  int pair(int slot, int layer) {
    return pair[4 * slot + layer];
  }

  /** Returns the number of a layer's cells within their pair. */
  int inPair(int slot, int layer) {
    return inPair[4 * slot + layer];
  }
}
