package org.palpate.edit;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * Puts another bit cube in the place of a segment's, for a bulk change that was built aside. One
 * frame, whatever the size. After {@link #isDone} the old cube is the caller's and the new one the
 * haptic thread's.
 */
public final class SwapEdit extends Edit {
  private final BitCube fresh;
  private BitCube retired;

  /** {@code fresh} is given away: its maker changes it no more. */
  public SwapEdit(int segment, BitCube fresh) {
    super(segment);
    this.fresh = fresh;
  }

  /**
   * The cube that was replaced.
   *
   * @throws IllegalStateException before {@link #isDone}
   */
  public BitCube retired() {
    if (!isDone()) {
      throw new IllegalStateException("not swapped yet: segment=" + segment());
    }
    return retired;
  }

  @Override
  void check(VoxelGrid grid, GridMetric gridMetric) {
    boolean fits =
        fresh.sizeX() == grid.sizeX()
            && fresh.sizeY() == grid.sizeY()
            && fresh.sizeZ() == grid.sizeZ();
    if (!fits) {
      throw new IllegalArgumentException(
          "cube must have the grid's sizes: cube="
              + fresh.sizeX()
              + "x"
              + fresh.sizeY()
              + "x"
              + fresh.sizeZ()
              + " grid="
              + grid.sizeX()
              + "x"
              + grid.sizeY()
              + "x"
              + grid.sizeZ());
    }
  }

  @Override
  int apply(CollisionScene obstacles, int voxels) {
    retired = obstacles.replace(segment(), fresh);
    finish();
    return 1;
  }
}
