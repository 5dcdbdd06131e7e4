package org.palpate.testing;

import java.util.List;
import java.util.SplittableRandom;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/** Two blocks whose rough faces fit each other column by column; the upper one is movable. */
public final class RoughBlocks {
  private RoughBlocks() {}

  /**
   * Returns a scene of a fixed lower block and a movable upper one that fill a grid together.
   *
   * @param least the least height of a column of the lower block, voxels
   * @param most the largest height
   */
  public static BodyScene scene(SplittableRandom random, VoxelGrid grid, int least, int most) {
    BitCube low = new BitCube(grid.sizeX(), grid.sizeY(), grid.sizeZ());
    BitCube high = new BitCube(grid.sizeX(), grid.sizeY(), grid.sizeZ());
    for (int j = 0; j < grid.sizeY(); j++) {
      for (int i = 0; i < grid.sizeX(); i++) {
        int height = random.nextInt(least, most + 1);
        for (int k = 0; k < grid.sizeZ(); k++) {
          (k < height ? low : high).set(i, j, k);
        }
      }
    }
    return new BodyScene(
        List.of(
            new Body("low", low, grid, Mobility.FIXED),
            new Body("high", high, grid, Mobility.MOVABLE)));
  }
}
