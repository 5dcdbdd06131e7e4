package org.palpate.elastic.lattice;

import java.util.Arrays;
import org.palpate.volume.BitCube;

/**
 * Sums the solid voxels of a cell: their mean modulus, and their second moments about their centre.
 * One thread; allocates nothing after construction.
 */
final class CellMatter {
  private final LatticeLayout layout;
  private final int[] begin = new int[3];
  private final double[] first = new double[3];
  private final double[] second = new double[3];
  private double sum;
  private long voxels;

  CellMatter(LatticeLayout layout) {
    this.layout = layout;
  }

  /** Begins a cell. */
  void begin(int cell) {
    begin(
        layout.firstVoxel(0, layout.cellIndex(0, cell)),
        layout.firstVoxel(1, layout.cellIndex(1, cell)),
        layout.firstVoxel(2, layout.cellIndex(2, cell)));
  }

  /** Begins a cell with any first voxel. */
  void begin(int x, int y, int z) {
    sum = 0;
    voxels = 0;
    begin[0] = x;
    begin[1] = y;
    begin[2] = z;
    Arrays.fill(first, 0);
    Arrays.fill(second, 0);
  }

  /** Adds the voxels of a segment. */
  void add(BitCube bits, double modulus) {
    for (int k = 0; k < layout.voxelsPerCell(2); k++) {
      for (int j = 0; j < layout.voxelsPerCell(1); j++) {
        for (int i = 0; i < layout.voxelsPerCell(0); i++) {
          if (bits.get(begin[0] + i, begin[1] + j, begin[2] + k)) {
            voxels++;
            sum += modulus;
            add(0, i, modulus);
            add(1, j, modulus);
            add(2, k, modulus);
          }
        }
      }
    }
  }

  private void add(int axis, int index, double modulus) {
    first[axis] += modulus * index;
    second[axis] += modulus * index * index;
  }

  /** Returns the share of the cell that is solid; voxels of two segments count twice. */
  double share() {
    return voxels / volume();
  }

  /** Returns the mean modulus, to which empty voxels add nothing. */
  double modulus() {
    return sum / volume();
  }

  private double volume() {
    double plane = (double) layout.voxelsPerCell(0) * layout.voxelsPerCell(1);
    return plane * layout.voxelsPerCell(2);
  }

  /**
   * Returns the second moment along an axis over that of a full cell, at most 1: two parts at both
   * ends of a cell are not taken for the faces of one beam.
   */
  double moment(int axis) {
    if (sum == 0) {
      return 1;
    }
    double mean = first[axis] / sum;
    double square = second[axis] / sum - mean * mean;
    double edge = layout.voxelsPerCell(axis);
    return Math.min(1, (12 * square + 1) / (edge * edge)); // A voxel itself has 1/12.
  }
}
