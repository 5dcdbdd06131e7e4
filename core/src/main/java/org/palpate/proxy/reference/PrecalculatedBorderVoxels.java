package org.palpate.proxy.reference;

import org.palpate.collision.CollisionScene;
import org.palpate.volume.BitCube;

/**
 * Empty-space border voxels found beforehand for one set of obstacles: one look-up each, 1/8 byte a
 * voxel, and the need to be told of every edit.
 *
 * <p>Written by the haptic thread, between frames. Source: Vlasov, Friese, Wolter 2013, note 1.
 */
public final class PrecalculatedBorderVoxels implements BorderVoxels {
  /** Border voxels reach one voxel outside the grid: voxel i is kept as bit i + 1. */
  private static final int RIM = 1;

  private final CollisionScene obstacles;
  private final BorderVoxels onTheFly = BorderVoxels.onTheFly();
  private final BitCube border;

  /** Looks at every voxel of a grid of the given sizes, and round it. */
  public PrecalculatedBorderVoxels(CollisionScene obstacles, int sizeX, int sizeY, int sizeZ) {
    this.obstacles = obstacles;
    border = new BitCube(sizeX + 2 * RIM, sizeY + 2 * RIM, sizeZ + 2 * RIM);
    update(0, 0, 0, sizeX - 1, sizeY - 1, sizeZ - 1);
  }

  /** Looks again round a voxel that was made solid or empty. */
  public void voxelChanged(int i, int j, int k) {
    update(i, j, k, i, j, k);
  }

  /** Looks again in and round a box of voxels, both ends included, in which some changed. */
  public void update(int lowX, int lowY, int lowZ, int highX, int highY, int highZ) {
    for (int k = lowZ - RIM; k <= highZ + RIM; k++) {
      for (int j = lowY - RIM; j <= highY + RIM; j++) {
        for (int i = lowX - RIM; i <= highX + RIM; i++) {
          put(i, j, k, onTheFly.isBorder(obstacles, i, j, k));
        }
      }
    }
  }

  private void put(int i, int j, int k, boolean isBorder) {
    if (isBorder) {
      border.set(i + RIM, j + RIM, k + RIM);
    } else {
      border.clear(i + RIM, j + RIM, k + RIM);
    }
  }

  /** {@code ofFrame} is not looked at: it must hold what the constructor was given. */
  @Override
  public boolean isBorder(CollisionScene ofFrame, int i, int j, int k) {
    return border.get(i + RIM, j + RIM, k + RIM);
  }
}
