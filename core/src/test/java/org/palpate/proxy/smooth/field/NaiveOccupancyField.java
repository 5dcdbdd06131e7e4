package org.palpate.proxy.smooth.field;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.palpate.geometry.Vec3;

/**
 * The occupancy field written down as its definition says: a test oracle.
 *
 * <p>Every voxel of the window adds its occupancy times a weight. The weight is the product over
 * the axes of the convolution of two boxes of whole voxels and a quadratic B-spline. Empty voxels
 * that the seed does not reach within the window count as solid.
 */
final class NaiveOccupancyField {
  private static final int EDGE = 12;
  private static final int[][] FACES = {
    {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}
  };

  private final Cells cells;

  /** The corrections of cells on terraces; null if the field has none. */
  private final NaiveTerraces terraces;

  private final int[][] boxes;
  private final VoxelOccupancy voxels;

  /** The axis along which cells were cut last; -1 if occupancies do not depend on a cut. */
  private final int cutAxis;

  /** The cells of the field: voxels or thin slices of them. */
  interface Cells {
    boolean isSolid(int x, int y, int z);
  }

  /** The occupancy of a cell that is solid or that the seed reaches. */
  interface VoxelOccupancy {
    double of(int i, int j, int k, boolean isSolid);
  }

  /** Creates the field of the bits of cubes for the two box widths along each axis. */
  NaiveOccupancyField(Cells cells, NaiveTerraces terraces, int[][] boxes) {
    this(cells, terraces, boxes, (i, j, k, isSolid) -> isSolid ? 1 : 0, -1);
  }

  /**
   * Creates the field of thin slices. A cell that is solid in part counts as such if the seed
   * reaches it or a cell beside it along the axis of the last cut.
   */
  NaiveOccupancyField(NaiveThinSlices slices, NaiveTerraces terraces, int[][] boxes) {
    this(slices, terraces, boxes, (i, j, k, isSolid) -> slices.occupancy(i, j, k), slices.axis());
  }

  /** Creates the field of voxels with any occupancy. */
  NaiveOccupancyField(Cells cells, int[][] boxes, VoxelOccupancy voxels) {
    this(cells, null, boxes, voxels, -1);
  }

  private NaiveOccupancyField(
      Cells cells, NaiveTerraces terraces, int[][] boxes, VoxelOccupancy voxels, int cutAxis) {
    this.cells = cells;
    this.terraces = terraces;
    this.boxes = boxes;
    this.voxels = voxels;
    this.cutAxis = cutAxis;
  }

  /**
   * Returns the occupancy at a point, in cells, as seen from the first of some cells that is empty
   * and in the window.
   */
  double occupancy(Vec3 point, int[]... seeds) {
    int[] low = {low(point.x), low(point.y), low(point.z)};
    Set<List<Integer>> free = new HashSet<>();
    addAllFree(low, free);
    if (terraces != null && free.size() == EDGE * EDGE * EDGE) {
      return 0; // without a solid cell nothing is read that counts in part
    }
    Set<List<Integer>> reached = flood(low, seeds);
    boolean allReached = reached.size() == free.size();
    double sum = 0;
    for (int k = low[2]; k < low[2] + EDGE; k++) {
      for (int j = low[1]; j < low[1] + EDGE; j++) {
        for (int i = low[0]; i < low[0] + EDGE; i++) {
          sum +=
              voxelOccupancy(i, j, k, reached, allReached)
                  * weight(0, point.x - i - 0.5)
                  * weight(1, point.y - j - 0.5)
                  * weight(2, point.z - k - 0.5);
        }
      }
    }
    return sum;
  }

  /** Returns the first voxel of the window around the nearest corner. */
  private static int low(double coordinate) {
    return (int) Math.floor(coordinate + 0.5) - EDGE / 2;
  }

  private double voxelOccupancy(
      int i, int j, int k, Set<List<Integer>> reached, boolean allReached) {
    boolean isSolid = cells.isSolid(i, j, k);
    boolean isCutOff = !isSolid && !reached.contains(List.of(i, j, k));
    boolean isWhole = isSolid && cutAxis >= 0 && !allReached && !isBeside(i, j, k, reached);
    if (isCutOff || isWhole) {
      return 1;
    }
    double onTerrace = terraces == null || isSolid ? 0 : terraces.correction(i, j, k);
    return voxels.of(i, j, k, isSolid) + onTerrace;
  }

  private boolean isBeside(int i, int j, int k, Set<List<Integer>> reached) {
    int[] face = FACES[2 * cutAxis];
    return reached.contains(List.of(i + face[0], j + face[1], k + face[2]))
        || reached.contains(List.of(i - face[0], j - face[1], k - face[2]));
  }

  private double weight(int axis, double offset) {
    int wide = boxes[axis][0];
    int narrow = boxes[axis][1];
    double sum = 0;
    for (int a = 0; a < wide; a++) {
      for (int b = 0; b < narrow; b++) {
        sum += spline(offset - (a - (wide - 1) / 2.0) - (b - (narrow - 1) / 2.0));
      }
    }
    return sum / (wide * narrow);
  }

  /** Returns the centred quadratic B-spline. */
  private static double spline(double t) {
    double u = Math.abs(t);
    if (u <= 0.5) {
      return 0.75 - u * u;
    }
    return u < 1.5 ? 0.5 * (1.5 - u) * (1.5 - u) : 0;
  }

  /** Returns the empty cells that the first possible seed reaches; all of them without a seed. */
  private Set<List<Integer>> flood(int[] low, int[][] seeds) {
    Set<List<Integer>> reached = new HashSet<>();
    List<Integer> start =
        Arrays.stream(seeds)
            .map(seed -> List.of(seed[0], seed[1], seed[2]))
            .filter(seed -> isFree(low, seed))
            .findFirst()
            .orElse(null);
    if (start == null) {
      addAllFree(low, reached);
      return reached;
    }
    ArrayDeque<List<Integer>> open = new ArrayDeque<>();
    open.add(start);
    reached.add(start);
    while (!open.isEmpty()) {
      List<Integer> at = open.remove();
      for (int[] face : FACES) {
        List<Integer> next = List.of(at.get(0) + face[0], at.get(1) + face[1], at.get(2) + face[2]);
        if (isFree(low, next) && reached.add(next)) {
          open.add(next);
        }
      }
    }
    return reached;
  }

  private void addAllFree(int[] low, Set<List<Integer>> reached) {
    for (int k = low[2]; k < low[2] + EDGE; k++) {
      for (int j = low[1]; j < low[1] + EDGE; j++) {
        for (int i = low[0]; i < low[0] + EDGE; i++) {
          List<Integer> voxel = List.of(i, j, k);
          if (isFree(low, voxel)) {
            reached.add(voxel);
          }
        }
      }
    }
  }

  private boolean isFree(int[] low, List<Integer> voxel) {
    for (int axis = 0; axis < 3; axis++) {
      if (voxel.get(axis) < low[axis] || voxel.get(axis) >= low[axis] + EDGE) {
        return false;
      }
    }
    return !cells.isSolid(voxel.get(0), voxel.get(1), voxel.get(2));
  }
}
