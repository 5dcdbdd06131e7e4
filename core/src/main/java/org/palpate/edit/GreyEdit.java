package org.palpate.edit;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.proxy.smooth.field.GreyIsosurfaceSource;
import org.palpate.volume.VoxelGrid;

/**
 * Puts other grey values in the place of those that a smooth surface goes by. One frame, whatever
 * the size; which voxels are solid is the business of other edits.
 */
public final class GreyEdit extends Edit {
  private final GreyIsosurfaceSource grey;
  private final GreyIsosurface fresh;

  /** {@code fresh} is given away: its maker changes it no more. */
  public GreyEdit(int segment, GreyIsosurfaceSource grey, GreyIsosurface fresh) {
    super(segment);
    this.grey = grey;
    this.fresh = fresh;
  }

  @Override
  void check(VoxelGrid grid, GridMetric gridMetric) {
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
  int apply(CollisionScene obstacles, int voxels) {
    grey.replace(fresh);
    finish();
    return 1;
  }
}
