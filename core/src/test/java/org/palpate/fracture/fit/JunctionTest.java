package org.palpate.fracture.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Pose;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/** Scores blocks that stand on each other. */
class JunctionTest {
  private static final int SIZE = 40;
  private static final VoxelGrid GRID = VoxelGrid.ofUnitVoxels(SIZE, SIZE, SIZE);

  /** A column of 8 by 8 voxels that stands on the slice 16. */
  private static final BitCube COLUMN = block(16, 24, 16, 30);

  /** Returns the voxels from low to high along x and y, and from bottom to top along z. */
  private static BitCube block(int low, int high, int bottom, int top) {
    BitCube bits = new BitCube(SIZE, SIZE, SIZE);
    for (int k = bottom; k < top; k++) {
      for (int j = low; j < high; j++) {
        for (int i = low; i < high; i++) {
          bits.set(i, j, k);
        }
      }
    }
    return bits;
  }

  private static double exactScore(BitCube faced, double liftMm) {
    FragmentSurface surface = FragmentSurface.of(COLUMN, GRID);
    SurfaceCells cells = new SurfaceCells(FragmentSurface.of(faced, GRID), faced, GRID, 1);
    int[] all = IntStream.range(0, surface.points().size()).toArray();
    return new Junction(surface, cells, 1, 0).exactScore(Pose.at(0, 0, liftMm), all);
  }

  @Test
  void aColumnThatGoesOnFitsExactlyAndALiftedOneLess() {
    BitCube below = block(16, 24, 4, 16);
    double there = exactScore(below, 0);
    assertTrue(there > 100, "score " + there);
    assertTrue(exactScore(below, 0.5) < there / 2);
    assertTrue(exactScore(below, -3) < there / 2);
    assertEquals(0, exactScore(below, 30));
  }

  @Test
  void skinThatIsLaidOnSkinDoesNotFitBecauseNoSkinGoesOn() {
    double onPlate = exactScore(block(4, 36, 10, 16), 0);
    assertTrue(onPlate <= 0, "the base of 64 mm^2 coincides, score " + onPlate);
  }
}
