package org.palpate.scene.surface;

import org.palpate.geometry.IntBox;
import org.palpate.volume.BitCube;

/**
 * Divides the cells of a grid into bricks.
 *
 * <p>Cell (a,b,c) lies between the centres of voxels (a-1,b-1,c-1) and (a,b,c), so its middle has
 * grid coordinates (a,b,c). Cells run from 0 to the grid's size, so that a surface closes at the
 * border.
 *
 * @param edge cells along an edge of a brick
 * @param bricksX number of bricks along x
 * @param bricksY number of bricks along y
 * @param bricksZ number of bricks along z
 */
public record BrickLayout(int edge, int bricksX, int bricksY, int bricksZ) {

  /** Returns the layout of the bricks that cover a cube. */
  public static BrickLayout of(BitCube bits, int edge) {
    return new BrickLayout(
        edge, bricks(bits.sizeX(), edge), bricks(bits.sizeY(), edge), bricks(bits.sizeZ(), edge));
  }

  private static int bricks(int size, int edge) {
    return size / edge + 1;
  }

  /** Returns the number of bricks. */
  public int count() {
    return bricksX * bricksY * bricksZ;
  }

  /** Returns the position of a brick along x, in bricks. */
  public int x(int brick) {
    return brick % bricksX;
  }

  /** Returns the position of a brick along y, in bricks. */
  public int y(int brick) {
    return brick / bricksX % bricksY;
  }

  /** Returns the position of a brick along z, in bricks. */
  public int z(int brick) {
    return brick / bricksX / bricksY;
  }

  /** Returns the number of the brick at a position in bricks. */
  int brick(int x, int y, int z) {
    return (z * bricksY + y) * bricksX + x;
  }

  /**
   * Writes the box of bricks whose triangles may change with the given voxels into {@code dest}, in
   * bricks. It is empty if the voxels are.
   *
   * @param voxels a box around the changed voxels
   * @param reachCells distance over which a voxel changes the surface, see {@link
   *     SurfaceExtractor#reach}
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
