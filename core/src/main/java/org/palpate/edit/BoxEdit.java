package org.palpate.edit;

import org.palpate.geometry.GridMetric;
import org.palpate.geometry.IntBox;
import org.palpate.volume.VoxelGrid;

/**
 * An edit that visits the voxels of a box in the order of k, j and i, in as many frames as it
 * takes. The haptic thread finds the box in the first of them.
 */
abstract sealed class BoxEdit extends Edit permits BrushEdit, ShapeEdit {
  private final IntBox box = new IntBox();
  private final IntBox changed = new IntBox();
  private GridMetric metric;
  private int sizeX;
  private int sizeY;
  private int sizeZ;
  private boolean isBegun;
  private int i;
  private int j;
  private int k;

  BoxEdit(int segment) {
    super(segment);
  }

  @Override
  void prepare(SegmentGrids grids) {
    VoxelGrid grid = grids.grid(segment());
    metric = grids.metric(segment());
    sizeX = grid.sizeX();
    sizeY = grid.sizeY();
    sizeZ = grid.sizeZ();
  }

  /** Returns the metric of the grid. */
  final GridMetric metric() {
    return metric;
  }

  /** Calls {@link #include}; without a call, no voxel is visited. Haptic thread. */
  abstract void findBox(VoxelWriter out);

  /** Visits a voxel of the box and returns whether it changed. Haptic thread. */
  abstract boolean visit(VoxelWriter out, int i, int j, int k);

  /**
   * Includes the voxels around a ball in the box; the part outside the grid is left out.
   *
   * @param x the centre, as are y and z, grid coordinates
   */
  final void include(double x, double y, double z, double radiusMm) {
    double reachX = radiusMm / metric.spacingX();
    double reachY = radiusMm / metric.spacingY();
    double reachZ = radiusMm / metric.spacingZ();
    box.lowX = Math.min(box.lowX, lowest(x - reachX));
    box.lowY = Math.min(box.lowY, lowest(y - reachY));
    box.lowZ = Math.min(box.lowZ, lowest(z - reachZ));
    box.highX = Math.max(box.highX, highest(x + reachX, sizeX));
    box.highY = Math.max(box.highY, highest(y + reachY, sizeY));
    box.highZ = Math.max(box.highZ, highest(z + reachZ, sizeZ));
  }

  private static int lowest(double coordinate) {
    return (int) Math.max(0, Math.floor(coordinate));
  }

  private static int highest(double coordinate, int size) {
    return (int) Math.min(size - 1, Math.ceil(coordinate));
  }

  @Override
  final int apply(VoxelWriter out, int maxVoxels) {
    if (!isBegun) {
      isBegun = true;
      findBox(out);
      i = box.lowX;
      j = box.lowY;
      k = box.lowZ;
    }
    if (box.lowX > box.highX || box.lowY > box.highY || box.lowZ > box.highZ) {
      finish();
      return 1;
    }
    changed.clear();
    int visited = 0;
    while (visited < maxVoxels && k <= box.highZ) {
      if (visit(out, i, j, k)) {
        changed.include(i, j, k);
      }
      moveToNextVoxel();
      visited++;
    }
    out.applied(segment(), changed);
    if (k > box.highZ) {
      finish();
    }
    return visited;
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
