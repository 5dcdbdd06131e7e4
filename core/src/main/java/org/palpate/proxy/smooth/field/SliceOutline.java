package org.palpate.proxy.smooth.field;

/**
 * Measures distances within a slice from the middle of a pixel to the outline between solid and
 * empty pixels, in pixels. The outline lies half a pixel before the nearest pixel of the other
 * kind.
 *
 * <p>Before {@link #isAnyAround} and {@link #distance}, call {@link #coverNear} for the tile of the
 * pixel: it reads the pixels near the tile into a cache.
 *
 * <p>Pixels farther than {@code reach} along u or v are not searched. References: shape-based
 * interpolation by distances to the outline, Raya and Udupa 1990; Herman, Zheng and Bucholtz 1992.
 */
final class SliceOutline {
  /** Searched first; what lies farther is read only where there is nothing so near. */
  private static final int NEAR = 8;

  private static final int NEAR_BRICKS = NEAR / 4;

  /** The bit of the pixel from which is searched in a row that was turned. */
  private static final int MIDDLE = SliceBits.EDGE / 2;

  private final SliceBits bits;
  private final int reach;

  /** The pixel that {@link #findNearest} found, less the one from which it searched. */
  private int nearestU;

  private int nearestV;

  /**
   * Creates distances over the bits of slices.
   *
   * @param reach a multiple of 4, at most 28
   */
  SliceOutline(SliceBits bits, int reach) {
    this.bits = bits;
    this.reach = reach;
  }

  /** Returns the greatest distance that is measured; greater ones count as this. */
  double reach() {
    return reach;
  }

  /** Reads the pixels of a slice near the tile of brick (u,v). */
  void coverNear(int brickU, int brickV, int slice) {
    bits.cover(brickU, brickV, slice, NEAR_BRICKS);
  }

  /** Reads all pixels of a slice within reach of pixel (u,v). */
  void coverAll(int u, int v, int slice) {
    bits.cover(u >> 2, v >> 2, slice, reach / 4);
  }

  /**
   * Whether the searched squares around the pixels of a tile hold any pixel of a kind.
   *
   * @param solid whether solid or empty pixels are sought
   */
  boolean isAnyAround(int brickU, int brickV, int slice, boolean solid) {
    if (isAnyWithin(NEAR, brickU, brickV, slice, solid)) {
      return true;
    }
    bits.cover(brickU, brickV, slice, reach / 4);
    return isAnyWithin(reach, brickU, brickV, slice, solid);
  }

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
   * reach.
   *
   * @param solid whether the nearest solid or the nearest empty pixel is sought
   */
  double distance(int u, int v, int slice, boolean solid) {
    int square = squareWithin(NEAR, u, v, slice, solid);
    if (square > NEAR * NEAR) {
      coverAll(u, v, slice);
      square = squareWithin(reach, u, v, slice, solid);
    }
    return Math.min(reach, Math.sqrt(square) - 0.5);
  }

  /** Returns the squared distance to the nearest such pixel, or more than that of {@code most}. */
  private int squareWithin(int most, int u, int v, int slice, boolean solid) {
    long flip = solid ? 0 : -1;
    int best = (most + 1) * (most + 1);
    for (int off = 0; off <= most && off * off < best; off++) {
      long both = (bits.row(v + off, slice) ^ flip) | (bits.row(v - off, slice) ^ flip);
      long row = Long.rotateRight(both, u - MIDDLE);
      int along = Math.min(pixelsUp(row), pixelsDown(row));
      best = Math.min(best, along * along + off * off);
    }
    return best;
  }

  /**
   * Returns how far from the middle of a row the first set bit is, upwards; 64 if there is none.
   */
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
   */
  double distanceOpposite(int u, int v, int slice, boolean solid) {
    findNearest(u, v, slice, solid);
    double scale = 1 / Math.sqrt(nearestU * nearestU + nearestV * nearestV);
    int steps = 1;
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

  /** Finds the nearest pixel; the first of equals in the order of the loops counts. */
  private void findNearest(int u, int v, int slice, boolean solid) {
    long flip = solid ? 0 : -1;
    int best = Integer.MAX_VALUE;
    for (int off = 0; off <= reach && off * off < best; off++) {
      for (int side = -1; side <= 1; side += 2) {
        long row = Long.rotateRight(bits.row(v + side * off, slice) ^ flip, u - MIDDLE);
        int up = pixelsUp(row);
        int down = pixelsDown(row);
        int along = Math.min(up, down);
        if (along * along + off * off < best) {
          best = along * along + off * off;
          nearestU = down < up ? -down : up;
          nearestV = side * off;
        }
      }
    }
  }
}
