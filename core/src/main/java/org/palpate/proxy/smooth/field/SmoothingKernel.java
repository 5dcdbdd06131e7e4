package org.palpate.proxy.smooth.field;

import org.palpate.geometry.GridMetric;

/**
 * How bits are smoothed along each axis: by two boxes of whole voxels and a third of one voxel, as
 * taps between the voxels and quadratic B-splines between the taps. Boxes of whole voxels leave no
 * ripple of the lattice behind, which scaled B-splines do.
 *
 * <p>Where spacing differs between axes the longer voxels get narrower boxes, so that the kernel is
 * about as wide in millimetres along every axis.
 *
 * <p>References: box splines, de Boor, Hoellig and Riemenschneider 1993; normals of digital
 * surfaces by convolution, Esbelin and Malgouyres 2009, and by integral invariants, Coeurjolly,
 * Lachaud and Levallois 2013.
 */
public final class SmoothingKernel {
  /** Taps along an axis; corner c weighs the voxels c-5 to c+4. */
  static final int TAPS = 10;

  /** The boxes that are tried, by their two widths in voxels: as many taps as their sum less 1. */
  private static final int[][] BOXES = {{6, 5}, {5, 4}, {4, 3}, {3, 2}, {2, 1}};

  private final int[][] taps = new int[3][];
  private final int[][] boxes = new int[3][];
  private final double[] sigmaEdges = new double[3];
  private final double scale;

  /** For bits: wide enough to hide stairs. */
  public static final int FOR_BITS = 0;

  /** For grey values, which know where between two voxels the surface runs. */
  public static final int FOR_GREY = 2;

  /**
   * The kernel for voxels of this spacing.
   *
   * @param widest {@link #FOR_BITS} or {@link #FOR_GREY}, the boxes along the shortest axis
   */
  public SmoothingKernel(GridMetric metric, int widest) {
    double shortest = metric.shortestEdgeMm();
    double product = 1;
    for (int axis = 0; axis < 3; axis++) {
      double ratio = spacing(metric, axis) / shortest;
      int[] chosen = boxesFor(ratio, widest);
      boxes[axis] = chosen;
      taps[axis] = tapsOf(chosen[0], chosen[1]);
      sigmaEdges[axis] = ratio * sigmaVoxels(chosen);
      product *= chosen[0] * chosen[1];
    }
    scale = 1 / product;
  }

  private static double spacing(GridMetric metric, int axis) {
    return axis == 0 ? metric.spacingX() : axis == 1 ? metric.spacingY() : metric.spacingZ();
  }

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

  /** The standard deviation of the two boxes and the box of one voxel, one after the other. */
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

  /** The first tap along an axis that weighs anything. */
  int firstTap(int axis) {
    return firstTap(boxes[axis][0], boxes[axis][1]);
  }

  /** Voxels of the wider box along an axis. */
  int wideBox(int axis) {
    return boxes[axis][0];
  }

  /** Voxels of the narrower box along an axis. */
  int narrowBox(int axis) {
    return boxes[axis][1];
  }

  /** The weight of one of the ten taps along an axis; tap t and tap 9-t are equal. */
  int tap(int axis, int t) {
    return taps[axis][t];
  }

  /** What turns a sum of taps over all three axes into a share between 0 and 1. */
  double scale() {
    return scale;
  }

  /** The standard deviation along an axis, in shortest voxel edges. */
  double sigmaEdges(int axis) {
    return sigmaEdges[axis];
  }
}
