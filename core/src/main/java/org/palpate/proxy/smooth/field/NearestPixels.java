package org.palpate.proxy.smooth.field;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * Finds the nearest solid or empty pixel for all columns of a tile at once.
 *
 * <p>Every pixel of the tile looks at its neighbours in the order of their distance: first at those
 * one pixel away, then at those along a diagonal, and so on. One step of the search handles one
 * distance for all pixels together: the neighbours that lie {@code off} rows above or below and
 * {@code along} pixels to the left or right. The step widens the bits of these rows by one more
 * pixel on either side; a pixel of the tile that a widened bit covers has found its nearest pixel.
 * The tile is one word, so that all its pixels are handled at once (SIMD within a register, SWAR).
 *
 * <pre>
 *   word   16 bits for each of four rows; column c of the tile is bit 6 + c of a row
 * </pre>
 */
final class NearestPixels {
  /**
   * The greatest distance along u or v that is searched. A bit that spreads so far reaches no
   * column of the tile in another row of the word.
   */
  static final int REACH = 6;

  private static final int ROW_BITS = 16;
  private static final long ROW = 0xFFFF;
  private static final int OFF = 0xF;
  private static final int ALONG = 4;

  private final Sought sought;
  private final PixelEdges edges;

  /** The steps in the order of distance: rows away in the low four bits, then pixels along. */
  private final byte[] steps;

  /** The distance to the outline before the pixels that each step reaches. */
  private final double[] distances;

  /**
   * For each distance in rows, the set bits of the two rows that lie so far above and below. The
   * steps so far have widened them.
   */
  private final long[] spread = new long[REACH + 1];

  /** The pixels that searches look for: those that are of a kind in a slice and in a second one. */
  static final class Sought {
    private final SliceBits bits;
    private int slice;
    private int other;
    private boolean solid;

    Sought(SliceBits bits) {
      this.bits = bits;
    }

    /**
     * Sets which pixels are sought from now on.
     *
     * @param other the slice in which the pixels have to be of the kind as well, or the same one
     * @param solid whether solid or empty pixels are sought
     */
    void set(int slice, int other, boolean solid) {
      this.slice = slice;
      this.other = other;
      this.solid = solid;
    }

    /** Makes both slices hold the bricks that lie up to {@code reach} bricks around a brick. */
    void cover(int brickU, int brickV, int reach) {
      bits.cover(brickU, brickV, slice, reach);
      bits.cover(brickU, brickV, other, reach);
    }

    /** Returns the pixels of row v that are sought, a bit each. Only covered pixels are valid. */
    long row(int v) {
      return bits.rowOfBoth(v, slice, other, solid);
    }
  }

  NearestPixels(Sought sought, PixelEdges edges) {
    this.sought = sought;
    this.edges = edges;
    List<Integer> inOrder = stepsInOrder();
    steps = new byte[inOrder.size()];
    distances = new double[inOrder.size()];
    for (int n = 0; n < steps.length; n++) {
      int step = inOrder.get(n);
      steps[n] = (byte) step;
      distances[n] = edges.toOutline(step >> ALONG, step & OFF);
    }
  }

  /** Returns the number of steps that reach pixels nearer than a squared distance. */
  int stepsBefore(double square) {
    int count = 0;
    while (count < steps.length
        && edges.square(steps[count] >> ALONG, steps[count] & OFF) < square) {
      count++;
    }
    return count;
  }

  /**
   * Returns the steps up to the distance from which on some pixels are out of reach. Among steps of
   * equal distance, the one with fewer rows comes first.
   */
  private List<Integer> stepsInOrder() {
    double endSquare = edges.nearestBeyond(REACH);
    List<Integer> inOrder = new ArrayList<>();
    for (int off = 0; off <= REACH; off++) {
      for (int along = 0; along <= REACH; along++) {
        if (off + along > 0 && edges.square(along, off) < endSquare) {
          inOrder.add(along << ALONG | off);
        }
      }
    }
    inOrder.sort(Comparator.comparingDouble(step -> edges.square(step >> ALONG, step & OFF)));
    return inOrder;
  }

  /**
   * Finds the nearest pixels that are sought around the tile of brick (u,v). Pixels that the steps
   * reach must be covered.
   *
   * @param columns the pixels of the tile for which a nearest pixel is sought, a bit each; none of
   *     them is one itself
   * @param end the steps of the search, see {@link #stepsBefore}
   * @param dest receives the distance to the outline for each pixel that is returned
   * @return the pixels of {@code columns} for which one was found
   */
  int find(int brickU, int brickV, int columns, int end, double[] dest) {
    int turn = 4 * brickU - REACH;
    int v = 4 * brickV;
    long up = 0;
    for (int n = 0; n < 4; n++) {
      up |= row(v + n, turn) << (ROW_BITS * n);
    }
    long down = up;
    spread[0] = up;
    long left = spaced(columns);
    for (int n = 0; n < end && left != 0; n++) {
      int off = steps[n] & OFF;
      int along = steps[n] >> ALONG;
      if (along == 0) {
        up = up >>> ROW_BITS | row(v + 3 + off, turn) << (3 * ROW_BITS);
        down = down << ROW_BITS | row(v - off, turn);
        spread[off] = up | down;
      } else {
        spread[off] |= spread[off] << 1 | spread[off] >>> 1;
      }
      long reached = left & spread[off];
      if (reached != 0) {
        left ^= reached;
        write(distances[n], reached, dest);
      }
    }
    return columns & ~gathered(left);
  }

  /** Returns the pixels of a row that are sought, with column 0 of the tile at bit REACH. */
  private long row(int v, int turn) {
    return Long.rotateRight(sought.row(v), turn) & ROW;
  }

  /** Returns the columns of a tile as bits of a word. */
  private static long spaced(int columns) {
    long rows = (columns | (long) columns << 24) & 0x0000_00FF_0000_00FFL;
    return ((rows | rows << 12) & 0x000F_000F_000F_000FL) << REACH;
  }

  /** Returns the bits of a word as columns of a tile. */
  private static int gathered(long word) {
    long rows = word >>> REACH;
    rows = (rows | rows >>> 12) & 0x0000_00FF_0000_00FFL;
    return (int) (rows | rows >>> 24) & 0xFFFF;
  }

  private static void write(double distance, long reached, double[] dest) {
    for (long left = reached; left != 0; left &= left - 1) {
      int bit = Long.numberOfTrailingZeros(left) - REACH;
      dest[((bit >> 2) & ~3) | (bit & 3)] = distance;
    }
  }
}
