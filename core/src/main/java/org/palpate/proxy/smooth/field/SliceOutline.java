package org.palpate.proxy.smooth.field;

import java.util.Arrays;

/**
 * Measures distances within a slice from the middle of a pixel to the outline between solid and
 * empty pixels, in shortest voxel edges. The outline lies half a pixel before the nearest pixel of
 * the other kind.
 *
 * <p>Most outlines are near. All columns of a tile look for them at once, see {@link
 * NearestPixels}. Only columns without one search farther, one by one. Bricks around the tile are
 * read in rings, from near to far, while some column has not found its outline.
 *
 * <p>Pixels farther than the reach are not searched. References: shape-based interpolation by
 * distances to the outline, Raya and Udupa 1990; Herman, Zheng and Bucholtz 1992.
 */
final class SliceOutline {
  /** The bricks around a tile in which {@link NearestPixels} searches. */
  private static final int NEAR_BRICKS = (NearestPixels.REACH + 3) / 4;

  /** The bricks around a tile that are read at first, next and so on, before all within reach. */
  private static final int[] RINGS = {1, NEAR_BRICKS, 4};

  /** The most columns of a tile that are searched one by one, which takes less time then. */
  private static final int FEW_COLUMNS = 4;

  /** The most pixels along a row that a search for the nearest one returns. */
  private static final int FARTHEST = 64;

  /** The bit of the pixel from which is searched in a row that was turned. */
  private static final int MIDDLE = SliceBits.EDGE / 2;

  /** The margin of a bound against rounding. */
  private static final double ROUNDING = 1e-4;

  private final SliceBits bits;
  private final NearestPixels.Sought sought;
  private final NearestPixels nearest;
  private final PixelEdges edges;
  private final int reach;

  /** The pixels within reach along u. */
  private final int reachU;

  /** The pixels within reach along v. */
  private final int reachV;

  private final int reachBricks;

  /** From this on squared distances count as out of reach. */
  private final double endSquare;

  /** From this on {@link NearestPixels} may miss pixels: a squared distance. */
  private final double endOfNear;

  /** For each ring, how many bricks around a tile are read; the last one reads all in reach. */
  private final int[] ringBricks;

  /** For each ring, the squared distance from which on its bricks may lack pixels. */
  private final double[] ringEnds;

  /** For each ring, the steps of {@link NearestPixels} for which its bricks suffice. */
  private final int[] nearSteps;

  /** The squared lengths of offsets along u, in pixels up to {@link #FARTHEST}. */
  private final double[] squaresU = new double[FARTHEST + 1];

  /** The same along v. */
  private final double[] squaresV = new double[FARTHEST + 1];

  /** The distances to the outline before a pixel, for each offset within reach; u fastest. */
  private final double[] distances;

  /** The farthest that rounding moves a pixel on a straight line. */
  private final double mostRounded;

  /** The pixels along u to the nearest pixel that was found last. */
  private int nearestAlong;

  /** The rows to it. */
  private int nearestOff;

  /**
   * Creates distances over the bits of slices.
   *
   * @param reach in shortest voxel edges, a multiple of 4, at most 24
   */
  SliceOutline(SliceBits bits, PixelEdges edges, int reach) {
    this.bits = bits;
    this.edges = edges;
    this.reach = reach;
    sought = new NearestPixels.Sought(bits);
    nearest = new NearestPixels(sought, edges);
    endOfNear = edges.nearestBeyond(NearestPixels.REACH);
    endSquare = (reach + 1) * (reach + 1);
    reachU = pixels(edges.u());
    reachV = pixels(edges.v());
    reachBricks = (Math.max(reachU, reachV) + 3) / 4;
    ringBricks = ringsWithin(reachBricks);
    ringEnds = new double[ringBricks.length];
    nearSteps = new int[ringBricks.length];
    for (int ring = 0; ring < ringBricks.length; ring++) {
      ringEnds[ring] = endOfRing(ringBricks[ring]);
      nearSteps[ring] = nearest.stepsBefore(ringEnds[ring]);
    }
    mostRounded = edges.halfDiagonal() + ROUNDING;
    Arrays.setAll(squaresU, along -> edges.square(along, 0));
    Arrays.setAll(squaresV, off -> edges.square(0, off));
    distances = new double[(reachU + 1) * (reachV + 1)];
    Arrays.setAll(distances, n -> edges.toOutline(n % (reachU + 1), n / (reachU + 1)));
  }

  /** Returns the rings with fewer bricks than are within reach, and then all of these. */
  private static int[] ringsWithin(int reachBricks) {
    int count = 0;
    while (count < RINGS.length && RINGS[count] < reachBricks) {
      count++;
    }
    int[] rings = Arrays.copyOf(RINGS, count + 1);
    rings[count] = reachBricks;
    return rings;
  }

  /** Returns the squared distance from which on a ring of bricks may lack pixels. */
  private double endOfRing(int bricks) {
    if (bricks == reachBricks) {
      return endSquare;
    }
    int pixels = bricks <= NEAR_BRICKS ? Math.min(4 * bricks, NearestPixels.REACH) : 4 * bricks;
    return Math.min(endSquare, edges.nearestBeyond(pixels));
  }

  /** Returns the most pixels that a search reads to one side of a pixel, given their edge. */
  private int pixels(double edge) {
    int searched = (int) Math.ceil((reach + 1) / edge) - 1;
    int lookedAt = (int) ((reach - 1) / edge + 0.5);
    return Math.max(searched, lookedAt);
  }

  /** Returns how many bricks beside that of a pixel are read, at most, for its distances. */
  int reachBricks() {
    return reachBricks;
  }

  /** Returns the longer edge of a pixel. */
  double longestPixelEdge() {
    return Math.max(edges.u(), edges.v());
  }

  /** Reads all pixels of a slice within reach of the tile of brick (u,v). */
  void coverAll(int brickU, int brickV, int slice) {
    bits.cover(brickU, brickV, slice, reachBricks);
  }

  /**
   * Writes the distances from pixels of a tile to the outline around the pixels of a kind, at most
   * the reach.
   *
   * @param other the slice in which the pixels have to be of the kind as well, or the same one
   * @param solid whether the nearest solid or the nearest empty pixel is sought
   * @param columns the pixels, a bit each
   * @param dest receives a distance for each of them
   */
  void measure(
      int brickU, int brickV, int slice, int other, boolean solid, int columns, double[] dest) {
    sought.set(slice, other, solid);
    int left = columns;
    for (int ring = 0; left != 0 && ring < ringBricks.length; ring++) {
      sought.cover(brickU, brickV, ringBricks[ring]);
      left &= ~measureWithin(ring, brickU, brickV, left, dest);
    }
    for (; left != 0; left &= left - 1) {
      dest[Integer.numberOfTrailingZeros(left)] = reach;
    }
  }

  /** Measures the columns whose outline lies within the bricks of a ring; returns them. */
  private int measureWithin(int ring, int brickU, int brickV, int columns, double[] dest) {
    boolean isNear = ringEnds[ring] <= endOfNear;
    boolean areFew = Integer.bitCount(columns) <= FEW_COLUMNS;
    if (isNear && areFew) {
      return measureEach(ringEnds[ring], brickU, brickV, columns, dest);
    }
    int along = 4 * ringBricks[ring];
    if (!isAnyWithin(Math.min(along, reachU), Math.min(along, reachV), brickU, brickV)) {
      return 0;
    }
    return isNear
        ? nearest.find(brickU, brickV, columns, nearSteps[ring], dest)
        : measureEach(ringEnds[ring], brickU, brickV, columns, dest);
  }

  /**
   * Measures columns one by one.
   *
   * @param end the squared distance from which on pixels do not count
   * @return those for which a pixel was found
   */
  private int measureEach(double end, int brickU, int brickV, int columns, double[] dest) {
    int found = 0;
    for (int left = columns; left != 0; left &= left - 1) {
      int column = Integer.numberOfTrailingZeros(left);
      int u = 4 * brickU + (column & 3);
      int v = 4 * brickV + (column >> 2);
      if (findNearest(u, v, end)) {
        dest[column] = Math.min(reach, distanceToNearest());
        found |= 1 << column;
      }
    }
    return found;
  }

  /** Whether a rectangle around the pixels of a tile holds any pixel that is sought. */
  private boolean isAnyWithin(int alongU, int alongV, int brickU, int brickV) {
    long columns = Long.rotateLeft(-1L >>> (SliceBits.EDGE - 4 - 2 * alongU), 4 * brickU - alongU);
    long any = 0;
    for (int v = 4 * brickV - alongV; v < 4 * brickV + 4 + alongV; v++) {
      any |= sought.row(v);
    }
    return (any & columns) != 0;
  }

  /**
   * Returns the distance from pixel (u,v) to the outline around the pixels of a kind, at most the
   * reach. Call {@link #coverAll} before, for both slices.
   *
   * @param other the slice in which the pixels have to be of the kind as well, or the same one
   * @param solid whether the nearest solid or the nearest empty pixel is sought
   */
  double distance(int u, int v, int slice, int other, boolean solid) {
    sought.set(slice, other, solid);
    boolean found = findNearest(u, v, endSquare);
    return found ? Math.min(reach, distanceToNearest()) : reach;
  }

  /**
   * Finds the nearest pixel that is sought. Among equally near pixels, it takes the one the fewest
   * rows away.
   *
   * @param end the squared distance from which on pixels do not count
   * @return false if there is none
   */
  private boolean findNearest(int u, int v, double end) {
    double best = end;
    for (int off = 0; off <= reachV && squaresV[off] < best; off++) {
      long rows = sought.row(v + off) | sought.row(v - off);
      int along = pixelsAlong(Long.rotateRight(rows, u - MIDDLE));
      double square = squaresU[along] + squaresV[off];
      if (square < best) {
        best = square;
        nearestAlong = along;
        nearestOff = off;
      }
    }
    return best < end;
  }

  /** Returns the distance to the outline before the nearest pixel that was found last. */
  private double distanceToNearest() {
    return distances[nearestOff * (reachU + 1) + nearestAlong];
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
   * that leads away from the nearest pixel of a kind. Among equally near pixels, it takes the one
   * the fewest rows away, then the one of low v, then the one of high u. Call {@link #coverAll}
   * before.
   *
   * @param solid the kind of pixels outside; one of them is within reach
   */
  double distanceOpposite(int u, int v, int slice, boolean solid) {
    sought.set(slice, slice, solid);
    boolean found = findNearest(u, v, endSquare);
    assert found : "no pixel within reach of u=" + u + " v=" + v;
    long flip = solid ? 0 : -1;
    long rowBelow = Long.rotateRight(bits.row(v - nearestOff, slice) ^ flip, u - MIDDLE);
    boolean isBelow = pixelsAlong(rowBelow) == nearestAlong;
    long row =
        isBelow ? rowBelow : Long.rotateRight(bits.row(v + nearestOff, slice) ^ flip, u - MIDDLE);
    int towardsU = pixelsUp(row) == nearestAlong ? nearestAlong : -nearestAlong;
    int towardsV = isBelow ? -nearestOff : nearestOff;
    double length = Math.sqrt(edges.square(nearestAlong, nearestOff));
    double scale = 1 / length;
    int steps = Math.max(1, (int) (length - mostRounded)); // no pixel of the kind is nearer
    while (steps < reach
        && !isKind(
            u - rounded(steps * scale * towardsU),
            v - rounded(steps * scale * towardsV),
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
}
