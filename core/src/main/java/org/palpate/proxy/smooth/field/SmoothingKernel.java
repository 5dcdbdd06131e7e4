package org.palpate.proxy.smooth.field;

import org.palpate.geometry.Vec3;

/**
 * The smoothing of voxels along each axis: two box filters of whole voxels, and a quadratic
 * B-spline.
 *
 * <p>The two boxes give integer filter taps, from which a coefficient at each grid corner is made;
 * the splines interpolate between the corners. Boxes of whole voxels cancel the ripple of the
 * lattice, which B-splines of other widths leave behind.
 *
 * <p>If the spacing differs between the axes, longer voxels get narrower boxes. The kernel is
 * therefore about equally wide in millimetres along every axis. It is wider only across the cuts of
 * very long voxels, because cells are longer there.
 *
 * <p>References: box splines, de Boor, Hoellig and Riemenschneider 1993; normals of digital
 * surfaces by convolution, Esbelin and Malgouyres 2009, and by integral invariants, Coeurjolly,
 * Lachaud and Levallois 2013.
 */
final class SmoothingKernel {
  /** The filter taps along an axis; the coefficient at corner c weighs voxels c-5 to c+4. */
  static final int TAPS = 10;

  /** The widths in voxels of the two boxes, widest first; their taps are one less than the sum. */
  private static final int[][] BOXES = {{6, 5}, {5, 4}, {4, 3}, {3, 2}, {2, 1}};

  /** The boxes for bits along the shortest axis: wide enough to hide single voxels. */
  private static final int WIDEST_FOR_BITS = 0;

  /** The boxes for grey values, which show where the surface runs between two voxels. */
  private static final int WIDEST_FOR_GREY = 2;

  private final int[][] taps = new int[3][];
  private final int[][] boxes = new int[3][];
  private final double[] sigmaEdges = new double[3];
  private final double scale;

  private SmoothingKernel(ThinGrid grid, Vec3 voxelEdges, int widest) {
    Vec3 edges = grid.cellEdges(voxelEdges);
    double product = 1;
    for (int axis = 0; axis < 3; axis++) {
      double ratio = edges.get(axis);
      int[] chosen = grid.isCut(axis) ? BOXES[widest] : boxesFor(ratio, widest);
      boxes[axis] = chosen;
      taps[axis] = tapsOf(chosen[0], chosen[1]);
      sigmaEdges[axis] = ratio * sigmaVoxels(chosen);
      product *= chosen[0] * chosen[1];
    }
    scale = 1 / product;
  }

  /** Returns the kernel for the bits of a grid, given the edges of a voxel in shortest edges. */
  static SmoothingKernel forBits(ThinGrid grid, Vec3 voxelEdges) {
    return new SmoothingKernel(grid, voxelEdges, WIDEST_FOR_BITS);
  }

  /** Returns the kernel for the grey values of a grid, given the edges of a voxel. */
  static SmoothingKernel forGrey(ThinGrid grid, Vec3 voxelEdges) {
    return new SmoothingKernel(grid, voxelEdges, WIDEST_FOR_GREY);
  }

  /** Returns the boxes whose metric width is nearest to that of the widest on the shortest axis. */
  private static int[] boxesFor(double ratio, int widest) {
    double wanted = sigmaVoxels(BOXES[widest]);
    int[] best = BOXES[widest];
    for (int n = widest; n < BOXES.length; n++) {
      double off = Math.abs(ratio * sigmaVoxels(BOXES[n]) - wanted);
      if (off < Math.abs(ratio * sigmaVoxels(best) - wanted)) {
        best = BOXES[n];
      }
    }
    return best;
  }

  /** Returns the standard deviation of the convolution of the two boxes and a box of one voxel. */
  private static double sigmaVoxels(int[] boxes) {
    return Math.sqrt((boxes[0] * boxes[0] + boxes[1] * boxes[1] + 1) / 12.0);
  }

  private static int[] tapsOf(int wide, int narrow) {
    int[] result = new int[TAPS];
    int first = firstTap(wide, narrow);
    for (int a = 0; a < wide; a++) {
      for (int b = 0; b < narrow; b++) {
        result[first + a + b]++;
      }
    }
    return result;
  }

  private static int firstTap(int wide, int narrow) {
    return (TAPS - (wide + narrow - 1)) / 2;
  }

  /** Returns the first tap along an axis that is not 0. */
  int firstTap(int axis) {
    return firstTap(boxes[axis][0], boxes[axis][1]);
  }

  /** Returns the width of the wider box along an axis, in voxels. */
  int wideBox(int axis) {
    return boxes[axis][0];
  }

  /** Returns the width of the narrower box along an axis, in voxels. */
  int narrowBox(int axis) {
    return boxes[axis][1];
  }

  /** Returns one of the ten taps along an axis; tap t equals tap 9-t. */
  int tap(int axis, int t) {
    return taps[axis][t];
  }

  /** Returns the factor that turns a sum of taps over all three axes into an occupancy. */
  double scale() {
    return scale;
  }

  /** Returns the standard deviation along an axis, in shortest voxel edges. */
  double sigmaEdges(int axis) {
    return sigmaEdges[axis];
  }
}
