package org.palpate.interaction;

import org.palpate.proxy.Metric;
import org.palpate.proxy.Obstacles;
import org.palpate.proxy.smooth.GreySurface;
import org.palpate.proxy.smooth.LiveGrey;
import org.palpate.volume.VoxelGrid;

/**
 * Puts other grey values in the place of those that a smooth surface goes by. One frame, whatever
 * the size; which voxels are solid is the business of other edits.
 */
public final class GreyEdit extends Edit {
  private final LiveGrey grey;
  private final GreySurface fresh;

  /** {@code fresh} is given away: its maker changes it no more. */
  public GreyEdit(int segment, LiveGrey grey, GreySurface fresh) {
    super(segment);
    this.grey = grey;
    this.fresh = fresh;
  }

  @Override
  void check(VoxelGrid grid, Metric gridMetric) {
    VoxelGrid values = fresh.volume().grid();
    if (!sizes(values).equals(sizes(grid))) {
      throw new IllegalArgumentException(
          "grey values must have the grid's sizes: values="
              + sizes(values)
              + " grid="
              + sizes(grid));
    }
  }

  private static String sizes(VoxelGrid grid) {
    return grid.sizeX() + "x" + grid.sizeY() + "x" + grid.sizeZ();
  }

  @Override
  int apply(Obstacles obstacles, int voxels) {
    grey.replace(fresh);
    finish();
    return 1;
  }
}
