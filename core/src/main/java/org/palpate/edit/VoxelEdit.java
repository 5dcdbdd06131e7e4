package org.palpate.edit;

import org.palpate.geometry.IntBox;

/** Makes one voxel solid or empty. */
public final class VoxelEdit extends Edit {
  private final int i;
  private final int j;
  private final int k;
  private final boolean solid;
  private final IntBox voxel = new IntBox();

  /**
   * Makes an edit of a voxel.
   *
   * @param segment index of the segment in the scene
   * @param i the voxel's number along x
   * @param j its number along y
   * @param k its number along z
   * @param solid whether the voxel becomes solid; otherwise it becomes empty
   */
  public VoxelEdit(int segment, int i, int j, int k, boolean solid) {
    super(segment);
    this.i = i;
    this.j = j;
    this.k = k;
    this.solid = solid;
    voxel.include(i, j, k);
  }

  @Override
  void prepare(SegmentGrids grids) {
    grids.requireVoxel(segment(), i, j, k);
  }

  @Override
  int apply(VoxelWriter out, int maxVoxels) {
    out.write(segment(), i, j, k, solid);
    out.applied(segment(), voxel);
    finish();
    return 1;
  }
}
