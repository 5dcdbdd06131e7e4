package org.palpate.rigid;

import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * Cuts the rim voxels of a segment into cells and samples the centres of those cells that lie at an
 * open face. Keeps scratch.
 */
final class RimCells {
  private final BitCube bits;
  private final VoxelGrid grid;
  private final int cellsX;
  private final int cellsY;
  private final int cellsZ;
  private final double coverRadiusMm;
  private final Vec3 centre = new Vec3();

  RimCells(BitCube bits, VoxelGrid grid, int parts) {
    if (parts < 1) {
      throw new IllegalArgumentException("parts must be at least 1: parts=" + parts);
    }
    this.bits = bits;
    this.grid = grid;
    Vec3 spacing = grid.spacingMm();
    double cell = GridMetric.of(spacing).shortestEdgeMm() / parts;
    cellsX = cells(spacing.x, cell);
    cellsY = cells(spacing.y, cell);
    cellsZ = cells(spacing.z, cell);
    coverRadiusMm =
        new Vec3(spacing.x / cellsX, spacing.y / cellsY, spacing.z / cellsZ).length() / 2;
  }

  private static int cells(double spacing, double cell) {
    return Math.max(1, (int) Math.ceil(spacing / cell - 1e-9));
  }

  /** Returns half the diagonal of a cell, mm. */
  double coverRadiusMm() {
    return coverRadiusMm;
  }

  /** Samples one solid voxel; adds nothing if all its faces are covered. Positions are world mm. */
  void sample(int i, int j, int k, ToolShape.PointSink sink) {
    boolean lowX = !bits.get(i - 1, j, k);
    boolean highX = !bits.get(i + 1, j, k);
    boolean lowY = !bits.get(i, j - 1, k);
    boolean highY = !bits.get(i, j + 1, k);
    boolean lowZ = !bits.get(i, j, k - 1);
    boolean highZ = !bits.get(i, j, k + 1);
    if (!(lowX || highX || lowY || highY || lowZ || highZ)) {
      return;
    }
    for (int w = 0; w < cellsZ; w++) {
      boolean openZ = (lowZ && w == 0) || (highZ && w == cellsZ - 1);
      for (int v = 0; v < cellsY; v++) {
        boolean openY = (lowY && v == 0) || (highY && v == cellsY - 1);
        for (int u = 0; u < cellsX; u++) {
          boolean openX = (lowX && u == 0) || (highX && u == cellsX - 1);
          if (openX || openY || openZ) {
            add(i + (u + 0.5) / cellsX, j + (v + 0.5) / cellsY, k + (w + 0.5) / cellsZ, sink);
          }
        }
      }
    }
  }

  private void add(double gridX, double gridY, double gridZ, ToolShape.PointSink sink) {
    grid.gridToWorld(centre.set(gridX, gridY, gridZ), centre);
    sink.add(centre.x, centre.y, centre.z);
  }
}
