package org.palpate.proxy.smooth.field;

/**
 * Measures distances within a slice from the middle of a pixel to the outline between solid and
 * empty pixels, in pixels. The outline lies half a pixel before the nearest pixel of the other
 * kind.
 *
 * <p>Most outlines are near. All columns of a tile look for them at once, see {@link
 * NearestPixels}. Only columns without one search the whole reach, one by one.
 *
 * <p>Pixels farther than {@code reach} along u or v are not searched. References: shape-based
 * interpolation by distances to the outline, Raya and Udupa 1990; Herman, Zheng and Bucholtz 1992.
 */
final class SliceOutline {
  private static final int NEAR_BRICKS = (NearestPixels.REACH + 3) / 4;

  /** The bit of the pixel from which is searched in a row that was turned. */
  private static final int MIDDLE = SliceBits.EDGE / 2;

  /**
   * The farthest that rounding moves a pixel on a straight line, half its diagonal, and a little
   * more.
   */
  private static final double MOST_ROUNDED = 0.7072;

  private final SliceBits bits;
  private final NearestPixels nearest;
  private final int reach;

  /** The squared distances of a tile's columns. */
  private final int[] squares = new int[ThinSlices.COLUMNS];

  /** The distance to the outline if the nearest pixel of the other kind is this far, squared. */
  private final double[] distances;

  /** The nearest pixel less the one from which {@link #distanceOpposite} searched. */
  private int nearestU;

  private int nearestV;

  /**
   * Creates distances over the bits of slices.
   *
   * @param reach a multiple of 4, at most 24
   */
  SliceOutline(SliceBits bits, int reach) {
    this.bits = bits;
    this.reach = reach;
    nearest = new NearestPixels(bits);
    distances = new double[(reach + 1) * (reach + 1) + 1];
    for (int square = 0; square < distances.length; square++) {
      distances[square] = Math.min(reach, Math.sqrt(square) - 0.5);
    }
  }

  /** Returns the greatest distance that is measured; greater ones count as this. */
  double reach() {
    return reach;
  }

  /** Reads all pixels of a slice within reach of the tile of brick (u,v). */
  void coverAll(int brickU, int brickV, int slice) {
    bits.cover(brickU, brickV, slice, reach / 4);
  }

  /**
   * Writes the distances from pixels of a tile to the outline around the pixels of a kind, at most
   * the reach.
   *
   * @param solid whether the nearest solid or the nearest empty pixel is sought
   * @param columns the pixels, a bit each
   * @param dest receives a distance for each of them
   */
  void measure(int brickU, int brickV, int slice, boolean solid, int columns, double[] dest) {
    bits.cover(brickU, brickV, slice, NEAR_BRICKS);
    int found = 0;
    if (isAnyWithin(0, brickU, brickV, slice, solid)
        || isAnyWithin(NearestPixels.REACH, brickU, brickV, slice, solid)) {
      found = nearest.find(brickU, brickV, slice, solid, columns, squares);
      for (int left = found; left != 0; left &= left - 1) {
        int column = Integer.numberOfTrailingZeros(left);
        dest[column] = distances[squares[column]];
      }
    }
    if (found != columns) {
      measureFar(brickU, brickV, slice, solid, columns & ~found, dest);
    }
  }

  private void measureFar(
      int brickU, int brickV, int slice, boolean solid, int columns, double[] dest) {
    coverAll(brickU, brickV, slice);
    boolean any = isAnyWithin(reach, brickU, brickV, slice, solid);
    for (int left = columns; left != 0; left &= left - 1) {
      int column = Integer.numberOfTrailingZeros(left);
      dest[column] =
          any
              ? distance(4 * brickU + (column & 3), 4 * brickV + (column >> 2), slice, solid)
              : reach;
    }
  }

  /** Whether the searched squares around the pixels of a tile hold any pixel of a kind. */
  private boolean isAnyWithin(int pixels, int brickU, int brickV, int slice, boolean solid) {
    long columns = Long.rotateLeft(-1L >>> (SliceBits.EDGE - 4 - 2 * pixels), 4 * brickU - pixels);
    long flip = solid ? 0 : -1;
    long any = 0;
    for (int v = 4 * brickV - pixels; v < 4 * brickV + 4 + pixels; v++) {
      any |= bits.row(v, slice) ^ flip;
    }
    return (any & columns) != 0;
  }

  /**
   * Returns the distance from pixel (u,v) to the outline around the pixels of a kind, at most the
   * reach. Call {@link #coverAll} before.
   *
   * @param solid whether the nearest solid or the nearest empty pixel is sought
   */
  double distance(int u, int v, int slice, boolean solid) {
    return distances[square(u, v, slice, solid)];
  }

  /** Returns the squared distance to the nearest pixel of a kind; more than the reach's if none. */
  private int square(int u, int v, int slice, boolean solid) {
    long flip = solid ? 0 : -1;
    int best = (reach + 1) * (reach + 1);
    for (int off = 0; off <= reach && off * off < best; off++) {
      long both = (bits.row(v + off, slice) ^ flip) | (bits.row(v - off, slice) ^ flip);
      int along = pixelsAlong(Long.rotateRight(both, u - MIDDLE));
      if (along * along + off * off < best) {
        best = along * along + off * off;
      }
    }
    return best;
  }

  /** Returns how far from the middle of a row the nearest set bit is; over the reach if none. */
  private static int pixelsAlong(long row) {
    return Math.min(pixelsUp(row), pixelsDown(row));
  }

  private static int pixelsUp(long row) {
    return Long.numberOfTrailingZeros(row >>> MIDDLE);
  }

  private static int pixelsDown(long row) {
    return Long.numberOfLeadingZeros(row << (MIDDLE - 1));
  }

  /**
   * Returns the distance from pixel (u,v) to the outline on the far side: along the straight line
   * that leads away from the nearest pixel of a kind. Call {@link #coverAll} before.
   *
   * @param solid the kind of pixels outside; one of them is within reach
   * @param near the distance to the outline
   */
  double distanceOpposite(int u, int v, int slice, boolean solid, double near) {
    double length = near + 0.5;
    findNearest(u, v, slice, solid, (int) (length * length + 0.5));
    double scale = 1 / Math.sqrt(nearestU * nearestU + nearestV * nearestV);
    int steps = Math.max(1, (int) (length - MOST_ROUNDED)); // no pixel of the kind is nearer
    while (steps < reach
        && !isKind(
            u - rounded(steps * scale * nearestU),
            v - rounded(steps * scale * nearestV),
            slice,
            solid)) {
      steps++;
    }
    return steps - 0.5;
  }

  private boolean isKind(int u, int v, int slice, boolean solid) {
    return (bits.row(v, slice) >>> u & 1) != 0 == solid;
  }

  private static int rounded(double value) {
    return (int) Math.floor(value + 0.5);
  }

  /**
   * Finds the nearest pixel of a kind, given its squared distance. Of equals that of the fewest
   * rows away counts, then that of low v, then that of high u.
   */
  private void findNearest(int u, int v, int slice, boolean solid, int square) {
    int off = 0;
    while (!isNearest(u, v, -off, slice, solid, square)
        && !isNearest(u, v, off, slice, solid, square)) {
      off++;
    }
  }

  /** Whether a row holds the nearest pixel; sets it if so. */
  private boolean isNearest(int u, int v, int rows, int slice, boolean solid, int square) {
    long flip = solid ? 0 : -1;
    long row = Long.rotateRight(bits.row(v + rows, slice) ^ flip, u - MIDDLE);
    int along = pixelsAlong(row);
    nearestU = pixelsUp(row) == along ? along : -along;
    nearestV = rows;
    return along * along + rows * rows == square;
  }
}
