package org.palpate.elastic.lattice;

import java.util.Arrays;

/**
 * Carries vectors between a lattice and the one with cells of twice the edge: trilinear
 * interpolation, and its transpose. Immutable.
 */
final class NodeTransfer {
  private final ActiveCells fine;
  private final ActiveCells coarse;

  NodeTransfer(ActiveCells fine, ActiveCells coarse) {
    this.fine = fine;
    this.coarse = coarse;
  }

  /** Copies the entries of the nodes that both lattices have. */
  void inject(float[] from, float[] dest) {
    LatticeLayout layout = coarse.layout();
    int fineNodes = fine.layout().nodeCount();
    int coarseNodes = layout.nodeCount();
    for (int node = 0; node < coarseNodes; node++) {
      int same = fine.fineNode(layout, node);
      for (int axis = 0; axis < 3; axis++) {
        dest[axis * coarseNodes + node] = from[axis * fineNodes + same];
      }
    }
  }

  /** Sums a residual of the fine lattice on the coarse one. */
  void restrict(float[] from, float[] dest) {
    Arrays.fill(dest, 0);
    forEachFreeNode(from, dest, true);
  }

  /** Adds a coarse correction to a vector of the fine lattice. */
  void prolong(float[] from, float[] dest) {
    forEachFreeNode(dest, from, false);
  }

  private void forEachFreeNode(float[] ofFine, float[] ofCoarse, boolean down) {
    LatticeLayout layout = fine.layout();
    for (int z = 0; z <= layout.cells(2); z++) {
      for (int y = 0; y <= layout.cells(1); y++) {
        for (int x = 0; x <= layout.cells(0); x++) {
          int node = layout.node(x, y, z);
          if (!fine.isFixed(node)) {
            transfer(x, y, z, node, ofFine, ofCoarse, down);
          }
        }
      }
    }
  }

  /** Moves the entry of one fine node to, or from, the coarse nodes around it. */
  private void transfer(
      int x, int y, int z, int node, float[] ofFine, float[] ofCoarse, boolean down) {
    int between = (x & 1) | (y & 1) << 1 | (z & 1) << 2;
    float weight = 1f / (1 << Integer.bitCount(between));
    int fineNodes = fine.layout().nodeCount();
    int coarseNodes = coarse.layout().nodeCount();
    int first = coarse.layout().node(x >> 1, y >> 1, z >> 1);
    for (int corner = 0; corner < LatticeLayout.CORNERS; corner++) {
      if ((corner & ~between) != 0) {
        continue;
      }
      int near = first + coarse.layout().cornerOffset(corner);
      if (coarse.isFixed(near)) {
        continue;
      }
      for (int axis = 0; axis < 3; axis++) {
        int f = axis * fineNodes + node;
        int c = axis * coarseNodes + near;
        if (down) {
          ofCoarse[c] += weight * ofFine[f];
        } else {
          ofFine[f] += weight * ofCoarse[c];
        }
      }
    }
  }
}
