package org.palpate.edit;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * Makes every voxel solid or empty whose centre lies within a ball; a large one takes more frames
 * than one.
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
   * A ball.
   *
   * @param centreGrid grid coordinates, finite
   * @param radiusMm metric radius, at least 0
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

  /** Any ball fits: what lies outside the grid is left out. */
  @Override
  void check(VoxelGrid grid, GridMetric gridMetric) {
    metric = gridMetric;
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

  private int lowest(double at, double spacing) {
    return (int) Math.max(0, Math.floor(at - radiusMm / spacing));
  }

  private int highest(double at, double spacing, int size) {
    return (int) Math.min(size - 1, Math.ceil(at + radiusMm / spacing));
  }

  @Override
  int apply(CollisionScene obstacles, int voxels) {
    boolean empty = box.lowX > box.highX || box.lowY > box.highY || box.lowZ > box.highZ;
    if (empty) {
      finish();
      return 1;
    }
    BitCube bits = obstacles.cube(segment());
    int looked = 0;
    while (looked < voxels && k <= box.highZ) {
      brush(bits);
      step();
      looked++;
    }
    if (k > box.highZ) {
      finish();
    }
    return looked;
  }

  private void brush(BitCube bits) {
    double square = metric.squaredDistance(centre.x, centre.y, centre.z, i + 0.5, j + 0.5, k + 0.5);
    if (square > radiusMm * radiusMm) {
      return;
    }
    if (solid) {
      bits.set(i, j, k);
    } else {
      bits.clear(i, j, k);
    }
  }

  private void step() {
    if (++i > box.highX) {
      i = box.lowX;
      if (++j > box.highY) {
        j = box.lowY;
        k++;
      }
    }
  }
}
