package org.palpate.elastic.lattice;

import java.util.Arrays;
import java.util.List;
import org.palpate.volume.BitCube;

/**
 * Finds the nodes that segments that stand still fix: those with at least a fifth of the voxels
 * around them in one.
 *
 * <p>One thread; allocates nothing after construction.
 */
final class StillNodes {
  /** The share of still voxels around a node that fixes it. */
  private static final double FIXING_SHARE = 0.2;

  private final LatticeLayout layout;
  private final List<BitCube> still;
  private final double[] stillShare;

  StillNodes(LatticeLayout layout, List<BitCube> still) {
    this.layout = layout;
    this.still = still;
    stillShare = new double[layout.nodeCount()];
  }

  /**
   * Adds these nodes to those that are fixed.
   *
   * @param fixed for each node, changed in place
   */
  void fix(boolean[] fixed) {
    Arrays.fill(stillShare, 0);
    for (int cell = 0; cell < layout.cellCount(); cell++) {
      double share = share(layout, still, cell) / LatticeLayout.CORNERS;
      for (int corner = 0; corner < LatticeLayout.CORNERS; corner++) {
        stillShare[layout.firstNode(cell) + layout.cornerOffset(corner)] += share;
      }
    }
    for (int node = 0; node < fixed.length; node++) {
      fixed[node] |= stillShare[node] >= FIXING_SHARE;
    }
  }

  /** Returns the sum over the cubes of the share of a cell's voxels that each holds. */
  static double share(LatticeLayout layout, List<BitCube> cubes, int cell) {
    double share = 0;
    for (int n = 0; n < cubes.size(); n++) {
      share += share(layout, cubes.get(n), cell);
    }
    return share;
  }

  private static double share(LatticeLayout layout, BitCube bits, int cell) {
    int x = layout.firstVoxel(0, layout.cellIndex(0, cell));
    int y = layout.firstVoxel(1, layout.cellIndex(1, cell));
    int z = layout.firstVoxel(2, layout.cellIndex(2, cell));
    int count = 0;
    for (int k = z; k < z + layout.voxelsPerCell(2); k++) {
      for (int j = y; j < y + layout.voxelsPerCell(1); j++) {
        for (int i = x; i < x + layout.voxelsPerCell(0); i++) {
          count += bits.get(i, j, k) ? 1 : 0;
        }
      }
    }
    double all = (double) layout.voxelsPerCell(0) * layout.voxelsPerCell(1);
    return count / (all * layout.voxelsPerCell(2));
  }
}
