package org.palpate.testing;

import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/** A hollow shaft that bends and widens towards its ends, like a long bone. */
public final class HollowShaft {
  /** Its grid. */
  public static final VoxelGrid GRID = VoxelGrid.ofUnitVoxels(44, 44, 120);

  private static final double WALL = 4.5;

  private HollowShaft() {}

  /** Returns its voxels. */
  public static BitCube bits() {
    return bits(1);
  }

  /**
   * Returns its voxels on a finer grid of the same place.
   *
   * @param times the voxels along an edge of a voxel of {@link #GRID}
   */
  public static BitCube bits(int times) {
    BitCube bits = new BitCube(times * GRID.sizeX(), times * GRID.sizeY(), times * GRID.sizeZ());
    for (int k = 6 * times; k < 114 * times; k++) {
      double z = (double) k / times;
      double end = (z - 60) / 54.0;
      double wide = 12 + 4 * end * end * end * end;
      for (int j = 0; j < bits.sizeY(); j++) {
        for (int i = 0; i < bits.sizeX(); i++) {
          double x = (i + 0.5) / times - 22 - 3 * StrictMath.sin(z / 40.0);
          double y = (j + 0.5) / times - 22;
          double r = Math.sqrt(x * x + y * y);
          if (r < wide && r > wide - WALL) {
            bits.set(i, j, k);
          }
        }
      }
    }
    return bits;
  }
}
