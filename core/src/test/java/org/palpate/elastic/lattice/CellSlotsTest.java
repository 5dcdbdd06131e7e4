package org.palpate.elastic.lattice;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.palpate.testing.Seeds;

class CellSlotsTest {
  private final Random random = new Random(Seeds.seed());

  /** A lattice in which some nodes are free, so that there are gaps of all lengths. */
  private ActiveCells cells(double freePart) {
    LatticeLayout layout =
        new LatticeLayout(
            new int[3], new int[] {4, 4, 4}, new int[] {24, 8, 4}, new double[] {4, 4, 4});
    boolean[] fixed = new boolean[layout.nodeCount()];
    Arrays.fill(fixed, true);
    for (int node = 0; node < fixed.length; node++) {
      fixed[node] = random.nextDouble() >= freePart;
    }
    return new ActiveCells(layout, fixed);
  }

  @Test
  void eachCellHasOneSlotAndTheSlotsOfARunFollowItsNodes() {
    for (double freePart : new double[] {0, 0.002, 0.02, 0.3, 1}) {
      int tile = 1 + random.nextInt(40);
      ActiveCells cells = cells(freePart);
      CellSlots slots = new CellSlots(cells, tile);
      float[] numbers = new float[cells.count()];
      for (int cell = 0; cell < numbers.length; cell++) {
        numbers[cell] = cell + 1;
      }
      float[] spread = new float[slots.count()];
      slots.spread(numbers, spread);
      int found = 0;
      for (int run = 0; run < slots.runs(); run++) {
        int begin = slots.begin(run);
        int end = slots.begin(run + 1);
        assertTrue(end > begin && (end - 1) / tile == begin / tile, "a run within a tile");
        for (int slot = begin; slot < end; slot++) {
          if (spread[slot] != 0) {
            assertEquals(found + 1, spread[slot], "cells in their order");
            assertEquals(cells.firstNode(found), slots.node(run) + slot - begin);
            found++;
          }
        }
      }
      assertEquals(cells.count(), found);
    }
  }

  @Test
  void aFullLayerIsOneRunInEachTile() {
    CellSlots slots = new CellSlots(cells(1), 1000);
    assertEquals(4, slots.runs(), "one run for each layer of 24 by 8 cells");
    assertEquals(4 * (25 * 8 - 1), slots.count());
  }
}
