package org.palpate.proxy.smooth.field;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.palpate.geometry.Vec3;

/**
 * The grid of cells on which a field is built. Voxels that are long along one or two axes are cut
 * along these, so that cells are about cubes, or longer if a voxel is very long. Otherwise cells
 * are voxels.
 *
 * @param cuts the cuts in the order in which they are made, that of the longest edges first; empty
 *     if cells are voxels
 */
record ThinGrid(List<AxisCut> cuts) {
  /**
   * The most cells for each voxel along an axis. Longer voxels get longer cells, over which the
   * smoothing is wider: the isosurface has to clear half of such a voxel.
   */
  static final int MAX_PER_VOXEL = 8;

  /** The same for grey values, whose smoothing is narrower. */
  private static final double MAX_PER_VOXEL_OF_GREY = 5;

  /**
   * The most cells along the diagonal of a voxel of grey values that is cut along two axes. The
   * isosurface has to clear half of this diagonal.
   */
  private static final double MAX_ALONG_DIAGONAL_OF_GREY = 5.3;

  /** Cells that are voxels. */
  static final ThinGrid WHOLE = new ThinGrid(List.of());

  /**
   * If the field is made from bits, voxels without an edge longer than this are not cut. Lengths
   * are in shortest edges.
   */
  private static final double MAX_EQUAL_OF_BITS = 1.05;

  /**
   * If the field is made from bits, a second edge up to this length is not cut. The cells of the
   * first cut are rounded to bits, which would cost more than the second cut gains.
   */
  private static final double MAX_SECOND_OF_BITS = 1.45;

  /** If the field is made from grey values, an edge up to this length is not cut. */
  private static final double MAX_EQUAL_OF_GREY = 1.15;

  /** Returns the grid for the bits of voxels with these edges, in shortest edges. */
  static ThinGrid ofBits(Vec3 edges) {
    return of(edges, MAX_PER_VOXEL, MAX_EQUAL_OF_BITS, MAX_SECOND_OF_BITS);
  }

  /** Returns the grid for the grey values of voxels with these edges, in shortest edges. */
  static ThinGrid ofGrey(Vec3 edges) {
    return of(edges, mostPerVoxelOfGrey(edges), MAX_EQUAL_OF_GREY, MAX_EQUAL_OF_GREY);
  }

  /** Returns the most cells for each voxel along an axis; fewer if a second axis is cut too. */
  private static double mostPerVoxelOfGrey(Vec3 edges) {
    double second =
        Math.max(Math.min(edges.x, edges.y), Math.min(Math.max(edges.x, edges.y), edges.z));
    if (second <= MAX_EQUAL_OF_GREY) {
      return MAX_PER_VOXEL_OF_GREY;
    }
    double diagonal = MAX_ALONG_DIAGONAL_OF_GREY;
    double ofSecond = Math.min(second, diagonal / Math.sqrt(2));
    return Math.min(MAX_PER_VOXEL_OF_GREY, Math.sqrt(diagonal * diagonal - ofSecond * ofSecond));
  }

  private static ThinGrid of(Vec3 edges, double mostPerVoxel, double maxEqual, double maxSecond) {
    List<AxisCut> axes = new ArrayList<>();
    for (int axis = 2; axis >= 0; axis--) {
      axes.add(new AxisCut(axis, Math.min(mostPerVoxel, edges.get(axis))));
    }
    axes.sort(Comparator.comparingDouble(AxisCut::perVoxel).reversed());
    List<AxisCut> cuts = new ArrayList<>();
    for (AxisCut cut : axes) {
      if (cut.perVoxel() > (cuts.isEmpty() ? maxEqual : maxSecond)) {
        cuts.add(cut);
      }
    }
    return new ThinGrid(List.copyOf(cuts));
  }

  /** Whether cells are voxels. */
  boolean isWhole() {
    return cuts.isEmpty();
  }

  /** Whether voxels are cut along an axis. */
  boolean isCut(int axis) {
    return perVoxel(axis) != 1;
  }

  /** Returns the cells for each voxel along an axis. */
  double perVoxel(int axis) {
    double perVoxel = 1;
    for (AxisCut cut : cuts) {
      perVoxel = cut.axis() == axis ? cut.perVoxel() : perVoxel;
    }
    return perVoxel;
  }

  /** Returns the edges of a cell, given those of a voxel. */
  Vec3 cellEdges(Vec3 voxelEdges) {
    Vec3 cell = new Vec3().set(voxelEdges);
    for (AxisCut cut : cuts) {
      cell.set(cut.axis(), cell.get(cut.axis()) / cut.perVoxel());
    }
    return cell;
  }
}
