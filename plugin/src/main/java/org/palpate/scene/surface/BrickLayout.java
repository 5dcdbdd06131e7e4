package org.palpate.scene.surface;

import org.palpate.geometry.IntBox;
import org.palpate.volume.BitCube;

/**
 * How the cells of a grid are cut into bricks.
 *
 * <p>Cell (a,b,c) lies between the centres of voxels (a-1,b-1,c-1) and (a,b,c); its middle has grid
 * coordinates (a,b,c). Cells run from 0 to the grid's size, so that a surface closes at the border.
 *
 * @param edge cells along an edge of a brick
 * @param bricksX bricks along x
 * @param bricksY bricks along y
 * @param bricksZ bricks along z
 */
public record BrickLayout(int edge, int bricksX, int bricksY, int bricksZ) {

  /** The bricks that cover a cube. */
  public static BrickLayout of(BitCube bits, int edge) {
    return new BrickLayout(
        edge, bricks(bits.sizeX(), edge), bricks(bits.sizeY(), edge), bricks(bits.sizeZ(), edge));
  }

  private static int bricks(int size, int edge) {
    return size / edge + 1;
  }

  public int count() {
    return bricksX * bricksY * bricksZ;
  }

  public int x(int brick) {
    return brick % bricksX;
  }

  public int y(int brick) {
    return brick / bricksX % bricksY;
  }

  public int z(int brick) {
    return brick / bricksX / bricksY;
  }

  /** The brick at a place, counted in bricks. */
  public int brick(int x, int y, int z) {
    return (z * bricksY + y) * bricksX + x;
  }

  /**
   * Writes the bricks whose triangles can change when the voxels do into {@code dest}, counted in
   * bricks; empty where the voxels are.
   *
   * @param reachCells how far the place of one voxel is felt, see {@link SurfaceExtractor#reach}
   */
  public IntBox touchedBy(IntBox voxels, int reachCells, IntBox dest) {
    if (voxels.isEmpty()) {
      dest.clear();
      return dest;
    }
    dest.lowX = Math.max(0, Math.floorDiv(voxels.lowX - reachCells, edge));
    dest.lowY = Math.max(0, Math.floorDiv(voxels.lowY - reachCells, edge));
    dest.lowZ = Math.max(0, Math.floorDiv(voxels.lowZ - reachCells, edge));
    dest.highX = Math.min(bricksX - 1, (voxels.highX + 1 + reachCells) / edge);
    dest.highY = Math.min(bricksY - 1, (voxels.highY + 1 + reachCells) / edge);
    dest.highZ = Math.min(bricksZ - 1, (voxels.highZ + 1 + reachCells) / edge);
    return dest;
  }
}
