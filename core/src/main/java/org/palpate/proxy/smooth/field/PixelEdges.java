package org.palpate.proxy.smooth.field;

import org.palpate.geometry.Vec3;

/**
 * The edges of the pixels of a slice. Turns offsets between pixels into distances, in shortest
 * voxel edges; u and v are the two axes of the slice.
 *
 * @param u the edge along u, at least 1
 * @param v the edge along v, at least 1
 */
record PixelEdges(double u, double v) {
  /**
   * Returns the edges of the pixels of slices across an axis, given those of the cells: u is the
   * first of the other axes, but z if x is the long axis, see {@link SliceBits}.
   */
  static PixelEdges across(int axis, Vec3 cellEdges) {
    return new PixelEdges(
        axis == 0 ? cellEdges.z : cellEdges.x, axis == 1 ? cellEdges.z : cellEdges.y);
  }

  /**
   * Returns the squared distance between two pixels, given their offsets along u and v in pixels.
   */
  double square(int alongU, int alongV) {
    return alongU * alongU * (u * u) + alongV * alongV * (v * v);
  }

  /** Returns the squared distance to the nearest pixel that lies farther away along u or v. */
  double nearestBeyond(int pixels) {
    return Math.min(square(pixels + 1, 0), square(0, pixels + 1));
  }

  /**
   * Returns the distance from the middle of a pixel to the outline before another: half a pixel
   * less than to the middle of that one. For the pixel itself it is -0.5.
   *
   * @param alongU how many pixels the other one lies away along u
   */
  double toOutline(int alongU, int alongV) {
    if (alongU == 0 && alongV == 0) {
      return -0.5;
    }
    double length = Math.sqrt(square(alongU, alongV));
    double pixels = Math.sqrt(alongU * alongU + alongV * alongV);
    return length - 0.5 * (length / pixels);
  }

  /** Returns half the diagonal of a pixel. */
  double halfDiagonal() {
    return 0.5 * Math.sqrt(square(1, 1));
  }
}
