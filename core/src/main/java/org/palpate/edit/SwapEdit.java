package org.palpate.edit;

import org.palpate.geometry.IntBox;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * Replaces the bit cube of a segment, for a change of many voxels that was built aside. It takes
 * one frame, whatever the size.
 *
 * <p>After {@link #isDone} the replaced cube belongs to the caller, and the new one to the haptic
 * thread.
 */
public final class SwapEdit extends Edit {
  private final BitCube replacement;
  private final IntBox all = new IntBox();
  private BitCube replaced;

  /**
   * Makes an edit.
   *
   * @param segment index of the segment in the scene
   * @param replacement the new cube, which the caller must not change any more
   */
  public SwapEdit(int segment, BitCube replacement) {
    super(segment);
    this.replacement = replacement;
    all.include(0, 0, 0);
    all.include(replacement.sizeX() - 1, replacement.sizeY() - 1, replacement.sizeZ() - 1);
  }

  /**
   * {@return the cube that was replaced}
   *
   * @throws IllegalStateException before {@link #isDone}
   */
  public BitCube replaced() {
    if (!isDone()) {
      throw new IllegalStateException("not swapped yet; wait until isDone(): segment=" + segment());
    }
    return replaced;
  }

  @Override
  void prepare(SegmentGrids grids) {
    VoxelGrid grid = grids.grid(segment());
    String sizes = sizes(replacement.sizeX(), replacement.sizeY(), replacement.sizeZ());
    String gridSizes = sizes(grid.sizeX(), grid.sizeY(), grid.sizeZ());
    if (!sizes.equals(gridSizes)) {
      throw new IllegalArgumentException(
          "cube must have the grid's sizes: cube=" + sizes + " grid=" + gridSizes);
    }
  }

  private static String sizes(int x, int y, int z) {
    return x + "x" + y + "x" + z;
  }

  @Override
  int apply(VoxelWriter out, int maxVoxels) {
    replaced = out.replace(segment(), replacement);
    out.applied(segment(), all);
    finish();
    return 1;
  }
}
