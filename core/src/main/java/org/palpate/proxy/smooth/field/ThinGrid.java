package org.palpate.proxy.smooth.field;

import org.palpate.geometry.Vec3;

/**
 * The grid of cells on which a field is built. If voxels are much longer along one axis than along
 * the two others, cells are thin slices of voxels, about as thick as they are wide. Otherwise cells
 * are voxels.
 *
 * <p>The middle of slice k of voxels lies at (k + 0.5) * {@code perVoxel} in cells. A pair k is the
 * space between the middles of slices k and k + 1; a cell belongs to the pair that holds its
 * centre.
 *
 * @param axis the long axis: 0, 1 or 2
 * @param perVoxel the cells for each voxel along it; need not be a whole number; 1 if cells are
 *     voxels
 */
record ThinGrid(int axis, double perVoxel) {
  /** The most cells for each voxel; slices farther apart than this get thicker cells. */
  static final int MAX_PER_VOXEL = 10;

  /** Cells that are voxels. */
  static final ThinGrid WHOLE = new ThinGrid(2, 1);

  /**
   * Edges up to this length, in shortest edges, count as equal if the field is made from bits. To
   * cut shorter ones helps where a surface is strongly curved, and harms where it is flat, because
   * bits are rounded to cells.
   */
  private static final double MAX_EQUAL_OF_BITS = 1.45;

  /** The same for a field that is made from grey values, which need no rounding. */
  private static final double MAX_EQUAL_OF_GREY = 1.15;

  /** Returns the grid for the bits of voxels with these edges, in shortest edges. */
  static ThinGrid ofBits(Vec3 edges) {
    return of(edges, MAX_EQUAL_OF_BITS);
  }

  /** Returns the grid for the grey values of voxels with these edges, in shortest edges. */
  static ThinGrid ofGrey(Vec3 edges) {
    return of(edges, MAX_EQUAL_OF_GREY);
  }

  private static ThinGrid of(Vec3 edges, double maxEqual) {
    ThinGrid grid = WHOLE;
    for (int axis = 0; axis < 3; axis++) {
      if (edges.get(axis) > maxEqual) {
        if (!grid.isWhole()) {
          return WHOLE;
        }
        grid = new ThinGrid(axis, Math.min(MAX_PER_VOXEL, edges.get(axis)));
      }
    }
    return grid;
  }

  /** Whether cells are voxels. */
  boolean isWhole() {
    return perVoxel == 1;
  }

  /** Returns the cells for each voxel along any axis. */
  double perVoxel(int along) {
    return along == axis ? perVoxel : 1;
  }

  /** Returns the edges of a cell, given those of a voxel. */
  Vec3 cellEdges(Vec3 voxelEdges) {
    Vec3 cell = new Vec3().set(voxelEdges);
    cell.set(axis, cell.get(axis) / perVoxel);
    return cell;
  }

  /** Returns the cell that holds the middle of a slice of voxels. */
  int middleOf(int slice) {
    return SeedCell.floor((slice + 0.5) * perVoxel);
  }

  /** Returns the slice of voxels that holds the centre of a cell. */
  int voxelOf(int cell) {
    return SeedCell.floor((cell + 0.5) / perVoxel);
  }

  /** Returns how far the centre of a cell lies beyond the middle of a slice of voxels, in cells. */
  double beyondMiddle(int cell, int slice) {
    return cell + 0.5 - (slice + 0.5) * perVoxel;
  }

  /** Returns the first cell of a pair. */
  int firstOfPair(int pair) {
    return (int) Math.ceil((pair + 0.5) * perVoxel - 0.5);
  }

  /** Returns the pair that holds the centre of a cell. */
  int pairOf(int cell) {
    int pair = (int) Math.floor((cell + 0.5) / perVoxel - 0.5);
    if (cell < firstOfPair(pair)) {
      return pair - 1;
    }
    return cell < firstOfPair(pair + 1) ? pair : pair + 1;
  }
}
