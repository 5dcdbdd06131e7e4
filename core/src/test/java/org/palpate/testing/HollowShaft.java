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
    BitCube bits = new BitCube(GRID.sizeX(), GRID.sizeY(), GRID.sizeZ());
    for (int k = 6; k < 114; k++) {
      for (int j = 0; j < GRID.sizeY(); j++) {
        for (int i = 0; i < GRID.sizeX(); i++) {
          double x = i + 0.5 - 22 - 3 * StrictMath.sin(k / 40.0);
          double y = j + 0.5 - 22;
          double r = Math.sqrt(x * x + y * y);
          double end = (k - 60) / 54.0;
          double wide = 12 + 4 * end * end * end * end;
          if (r < wide && r > wide - WALL) {
            bits.set(i, j, k);
          }
        }
      }
    }
    return bits;
  }
}
