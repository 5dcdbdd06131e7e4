package org.palpate.benchmarks.carve;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Checks that the burr of the timed study cuts what its motion covers, and counts it. */
class DrilledSlabTest {
  private static final int SIZE = 160;
  private static final int SOLID_LAYERS = 32;

  @Test
  void aSlabIsWholeUntilTheBurrReachesIt() {
    DrilledSlab slab = new DrilledSlab();
    assertEquals((long) SIZE * SIZE * SOLID_LAYERS, slab.bits().solidCount());
    assertEquals(0, slab.removed());
    assertEquals(31, slab.bits().bounds().highZ, "half of the grid, 8 mm");
    assertEquals(16 * 40 * 40, DrilledSlab.grid().voxelCount() * 0.25 * 0.25 * 0.25, 1e-9, "mm^3");
  }

  @Test
  void theBurrRemovesVoxelsAtItsDepthAloneAndReportsEachOnce() {
    DrilledSlab slab = new DrilledSlab();
    long[] heard = new long[1];
    slab.listen((segment, i, j, k, solid) -> heard[0] += solid ? 0 : 1);
    for (int frame = 0; frame < 400; frame++) {
      slab.runFrame();
    }
    assertTrue(slab.removed() > 500, "removed " + slab.removed());
    assertEquals(slab.removed(), heard[0]);
    assertTrue(deepest(slab) >= 24, "the hand presses 8 layers deep: " + deepest(slab));
  }

  /** Returns the lowest layer with an empty voxel. */
  private static int deepest(DrilledSlab slab) {
    for (int k = 0; k < SOLID_LAYERS; k++) {
      for (int n = 0; n < SIZE * SIZE; n++) {
        if (!slab.bits().get(n % SIZE, n / SIZE, k)) {
          return k;
        }
      }
    }
    return SOLID_LAYERS;
  }

  @Test
  void aHandThatDoesNotCutLeavesTheSlabWhole() {
    DrilledSlab slab = new DrilledSlab();
    for (int frame = 0; frame < 50; frame++) {
      slab.moveHand();
      slab.follow();
    }
    assertEquals(0, slab.removed());
  }
}
