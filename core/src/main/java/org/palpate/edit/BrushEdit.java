package org.palpate.edit;

import org.palpate.geometry.GridMetric;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;
import org.palpate.volume.VoxelGrid;

/**
 * Makes every voxel solid or empty whose centre lies within a ball. A large ball takes several
 * frames.
 */
public final class BrushEdit extends Edit {
  private final Vec3 centre;
  private final double radiusMm;
  private final boolean solid;
  private GridMetric metric;
  private final IntBox box = new IntBox();
  private int i;
  private int j;
  private int k;

  /**
   * Makes an edit of a ball.
   *
   * @param segment index of the segment in the scene
   * @param centreGrid grid coordinates, finite
   * @param radiusMm metric radius, at least 0
   * @param solid whether the voxels become solid; empty else
   */
  public BrushEdit(int segment, Vec3 centreGrid, double radiusMm, boolean solid) {
    super(segment);
    centre = new Vec3().set(centreGrid);
    this.radiusMm = radiusMm;
    this.solid = solid;
    if (!centre.isFinite() || !(radiusMm >= 0)) {
      throw new IllegalArgumentException(
          "centre must be finite and radius at least 0: centreGrid="
              + centreGrid
              + " radiusMm="
              + radiusMm);
    }
  }

  /** Finds the box of the ball. Any ball fits: the part outside the grid is left out. */
  @Override
  void prepare(SegmentGrids grids) {
    VoxelGrid grid = grids.grid(segment());
    metric = grids.metric(segment());
    box.lowX = lowest(centre.x, metric.spacingX());
    box.lowY = lowest(centre.y, metric.spacingY());
    box.lowZ = lowest(centre.z, metric.spacingZ());
    box.highX = highest(centre.x, metric.spacingX(), grid.sizeX());
    box.highY = highest(centre.y, metric.spacingY(), grid.sizeY());
    box.highZ = highest(centre.z, metric.spacingZ(), grid.sizeZ());
    i = box.lowX;
    j = box.lowY;
    k = box.lowZ;
  }

  private int lowest(double centreGrid, double spacing) {
    return (int) Math.max(0, Math.floor(centreGrid - radiusMm / spacing));
  }

  private int highest(double centreGrid, double spacing, int size) {
    return (int) Math.min(size - 1, Math.ceil(centreGrid + radiusMm / spacing));
  }

  @Override
  int apply(VoxelWriter out, int maxVoxels) {
    boolean empty = box.lowX > box.highX || box.lowY > box.highY || box.lowZ > box.highZ;
    if (empty) {
      finish();
      return 1;
    }
    int visited = 0;
    while (visited < maxVoxels && k <= box.highZ) {
      brushVoxel(out);
      moveToNextVoxel();
      visited++;
    }
    out.applied(segment(), box);
    if (k > box.highZ) {
      finish();
    }
    return visited;
  }

  private void brushVoxel(VoxelWriter out) {
    double square = metric.squaredDistance(centre.x, centre.y, centre.z, i + 0.5, j + 0.5, k + 0.5);
    if (square <= radiusMm * radiusMm) {
      out.write(segment(), i, j, k, solid);
    }
  }

  private void moveToNextVoxel() {
    if (++i > box.highX) {
      i = box.lowX;
      if (++j > box.highY) {
        j = box.lowY;
        k++;
      }
    }
  }
}
