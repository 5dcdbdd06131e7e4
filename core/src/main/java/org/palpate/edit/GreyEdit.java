package org.palpate.edit;

import org.palpate.geometry.IntBox;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.proxy.smooth.field.GreyIsosurfaceSource;
import org.palpate.volume.VoxelGrid;

/**
 * Replaces the grey values that define a smooth surface. It takes one frame, whatever their number.
 * Solid voxels do not change; other edits change them.
 */
public final class GreyEdit extends Edit {
  private final GreyIsosurfaceSource source;
  private final GreyIsosurface replacement;
  private final IntBox none = new IntBox();

  /**
   * Makes an edit.
   *
   * @param segment index of the segment in the scene
   * @param source gives the solver its grey values
   * @param replacement the new grey values, which the caller must not change any more
   */
  public GreyEdit(int segment, GreyIsosurfaceSource source, GreyIsosurface replacement) {
    super(segment);
    this.source = source;
    this.replacement = replacement;
  }

  @Override
  void prepare(SegmentGrids grids) {
    VoxelGrid grid = grids.grid(segment());
    VoxelGrid values = replacement.volume().grid();
    if (values.sizeX() != grid.sizeX()
        || values.sizeY() != grid.sizeY()
        || values.sizeZ() != grid.sizeZ()) {
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
  int apply(VoxelWriter out, int maxVoxels) {
    source.replace(replacement);
    out.noteGrey();
    out.applied(segment(), none);
    finish();
    return 1;
  }
}
