package org.palpate.elastic.lattice;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.IntBox;

class ActiveCellsTest {
  private final LatticeLayout layout =
      LatticeLayout.around(box(32), new GridMetric(1, 1, 1), 4, 0, 4, 1);

  private static IntBox box(int edge) {
    IntBox box = new IntBox();
    box.include(0, 0, 0);
    box.include(edge - 1, edge - 1, edge - 1);
    return box;
  }

  /** Returns cells that stand on a floor below a height, and are fixed on the rim. */
  private ActiveCells standing(int height) {
    boolean[] fixed = new boolean[layout.nodeCount()];
    for (int node = 0; node < fixed.length; node++) {
      for (int axis = 0; axis < 3; axis++) {
        int index = layout.nodeIndex(axis, node);
        fixed[node] |= index == 0 || index == layout.cells(axis);
      }
      fixed[node] |= layout.nodeIndex(2, node) <= height;
    }
    return new ActiveCells(layout, fixed);
  }

  @Test
  void aFloorBetweenCoarseNodesFixesThoseBelowItAlone() {
    ActiveCells coarse = standing(3).coarser();
    for (int z = 0; z < 4; z++) {
      assertEquals(z <= 1, coarse.isFixed(coarse.layout().node(2, 2, z)), "height " + z);
    }
  }

  @Test
  void aCoarseNodeAmongFixedNodesIsFixed() {
    boolean[] fixed = new boolean[layout.nodeCount()];
    for (int node = 0; node < fixed.length; node++) {
      int sum = 0;
      boolean rim = false;
      for (int axis = 0; axis < 3; axis++) {
        int index = layout.nodeIndex(axis, node);
        sum += index;
        rim |= index == 0 || index == layout.cells(axis);
      }
      fixed[node] = rim || sum % 2 == 1; // Every second node, but none that is a coarse node.
    }
    ActiveCells coarse = new ActiveCells(layout, fixed).coarser();
    assertEquals(true, coarse.isFixed(coarse.layout().node(2, 2, 2)));
    assertEquals(0, coarse.count());
  }
}
