package org.palpate.proxy.smooth.field;

/**
 * A division of long voxels along one axis into thin cells.
 *
 * <p>The middle of slice k of voxels lies at (k + 0.5) * {@code perVoxel} in cells. A pair k is the
 * space between the middles of slices k and k + 1; a cell belongs to the pair that holds its
 * centre.
 *
 * @param axis the long axis: 0, 1 or 2
 * @param perVoxel the cells for each voxel along it; need not be a whole number
 */
record AxisCut(int axis, double perVoxel) {
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
