package org.palpate.proxy.smooth.field;

import java.util.Arrays;
import org.palpate.collision.CollisionScene;
import org.palpate.volume.ScalarVolume;

/**
 * A cache of the occupancies of cells, a byte each. Windows that move by a few cells read only the
 * cells that came in. Call {@link #forget} after any change of solids or grey values.
 *
 * <pre>
 *   ring buffer of 16 planes of 16 rows; row j of plane k is kept at (k mod 16, j mod 16)
 *   row    two words that lie side by side along x, the one of even number first
 *   word n voxels 8 n to 8 n + 7, the first in the lowest byte
 * </pre>
 */
abstract class GreyOccupancyCache {
  /** The byte that stands for occupancy 1. */
  static final int WHOLE = 255;

  /** The edge of what is read at once, in cells. */
  static final int EDGE = ScalarVolume.LEVELS;

  private static final int RING = 16;
  private static final int RING_MASK = RING - 1;
  private static final int WORDS = 2;
  private static final int NONE = Integer.MIN_VALUE;

  private static final long TOP_BITS = 0x8080_8080_8080_8080L;
  private static final long ONE_A_BYTE = 0x0101_0101_0101_0101L;

  /** Bit n of byte n. */
  private static final long DIAGONAL = 0x8040_2010_0804_0201L;

  private final long[] ring = new long[RING * RING * WORDS];

  /** The k that each plane of the ring holds. */
  private final int[] planeK = new int[RING];

  /** The number of the lower of the two words that each plane holds. */
  private final int[] planeWord = new int[RING];

  /** The first row that each plane holds. */
  private final int[] firstRow = new int[RING];

  /** The row behind the last one that each plane holds. */
  private final int[] endRow = new int[RING];

  GreyOccupancyCache() {
    Arrays.fill(planeK, NONE);
  }

  /**
   * Returns the occupancies of the cells from (8 word, j, k) on along x, a byte each, the first in
   * the lowest byte.
   *
   * @param scene the same one since {@link #forget}
   */
  abstract long occupancies(CollisionScene scene, int word, int j, int k);

  /** Forgets all occupancies and takes the present grey values. */
  void forget() {
    Arrays.fill(planeK, NONE);
  }

  /**
   * Writes the occupancies of the 8x8x8 cells from (x,y,z) on, a row in a word, cell x in the
   * lowest byte; y fastest.
   *
   * @param scene the same one since {@link #forget}
   */
  void read(CollisionScene scene, int x, int y, int z, long[] dest) {
    int word = x >> 3;
    int shift = (x & 7) << 3;
    int lower = word & 1;
    for (int k = z; k < z + EDGE; k++) {
      if (!holds(k & RING_MASK, word, y, k)) {
        fetchRows(k & RING_MASK, word, y, k);
      }
    }
    int to = 0;
    for (int k = z; k < z + EDGE; k++) {
      int plane = k & RING_MASK;
      if (!holds(plane, word, y, k)) {
        fill(plane, word, y, k, scene);
      }
      for (int j = y; j < y + EDGE; j++) {
        int row = (plane * RING | (j & RING_MASK)) * WORDS;
        // In two shifts, because the upper word has to move by 64 bits where the shift is 0.
        dest[to++] = ring[row + lower] >>> shift | ring[row + 1 - lower] << 1 << (63 - shift);
      }
    }
  }

  /** Whether a plane holds two words of the rows from y on. */
  private boolean holds(int plane, int word, int y, int k) {
    return planeK[plane] == k
        && planeWord[plane] == word
        && firstRow[plane] <= y
        && endRow[plane] >= y + EDGE;
  }

  /** Fetches what {@link #fill} will read. */
  private void fetchRows(int plane, int word, int y, int k) {
    boolean holdsSome = planeK[plane] == k && planeWord[plane] == word;
    for (int j = y; j < y + EDGE; j++) {
      if (!holdsSome || j < firstRow[plane] || j >= endRow[plane]) {
        fetch(word, j, k);
      }
    }
  }

  /**
   * Fetches a value of a row that will be read soon, if it lies far away in memory. The memory then
   * brings the values of several rows at the same time.
   */
  void fetch(int word, int j, int k) {}

  /** Makes a plane hold two words of the rows from y on; keeps the rows that it holds already. */
  private void fill(int plane, int word, int y, int k, CollisionScene scene) {
    boolean overlaps = planeK[plane] == k && firstRow[plane] <= y + EDGE && endRow[plane] >= y;
    int wordsAhead = word - planeWord[plane];
    if (!overlaps || Math.abs(wordsAhead) > 1) {
      firstRow[plane] = y;
      endRow[plane] = y;
    } else if (wordsAhead != 0) {
      firstRow[plane] = Math.max(firstRow[plane], y);
      endRow[plane] = Math.min(endRow[plane], y + EDGE);
      for (int j = firstRow[plane]; j < endRow[plane]; j++) {
        readWord(plane, wordsAhead > 0 ? word + 1 : word, j, k, scene);
      }
    }
    planeK[plane] = k;
    planeWord[plane] = word;
    for (int j = endRow[plane]; j < y + EDGE; j++) {
      readRow(plane, word, j, k, scene);
    }
    for (int j = y; j < firstRow[plane]; j++) {
      readRow(plane, word, j, k, scene);
    }
    setRows(plane, Math.min(y, firstRow[plane]), Math.max(y + EDGE, endRow[plane]), y);
  }

  /** Notes which rows a plane holds; rows that the ring buffer has overwritten drop out. */
  private void setRows(int plane, int first, int end, int y) {
    boolean grewUp = end > endRow[plane];
    firstRow[plane] = grewUp ? Math.max(first, end - RING) : first;
    endRow[plane] = grewUp ? end : Math.min(end, first + RING);
    assert firstRow[plane] <= y && endRow[plane] >= y + EDGE : "the plane lacks rows: y=" + y;
  }

  private void readRow(int plane, int word, int j, int k, CollisionScene scene) {
    readWord(plane, word, j, k, scene);
    readWord(plane, word + 1, j, k, scene);
  }

  private void readWord(int plane, int word, int j, int k, CollisionScene scene) {
    ring[(plane * RING | (j & RING_MASK)) * WORDS | (word & 1)] = occupancies(scene, word, j, k);
  }

  /** Returns eight bytes, each of ones if its bit is set and else 0; the lowest bit's is lowest. */
  static long bytesOf(int bits) {
    long own = bits * ONE_A_BYTE & DIAGONAL;
    long top = (own | (own & ~TOP_BITS) + ~TOP_BITS) & TOP_BITS; // set if any bit of a byte is
    return (top >>> 7) * 0xFF;
  }
}
