package org.palpate.proxy.smooth.field;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.IntBox;
import org.palpate.volume.ScalarVolume;

/**
 * A cache of the occupancies of cells, a byte each. A window finds what earlier ones have read, so
 * that a cell is filled once and not for each window. Call {@link #forget} after any change of
 * solids or grey values.
 *
 * <pre>
 *   block   8x8x8 cells that begin at multiples of 8, in 64 words
 *   word    bit 8 (k mod 8) + (j mod 8) of a block: eight cells along x, the first in the lowest
 *           byte
 * </pre>
 *
 * <p>A block gets a word when a window needs it.
 */
final class GreyOccupancyCache {
  /** The byte that stands for occupancy 1. */
  static final int WHOLE = 255;

  /** The edge of what is read at once, and of a block, in cells. */
  static final int EDGE = ScalarVolume.LEVELS;

  private static final int SHIFT = 3;
  private static final int MASK = EDGE - 1;

  /** The words of a block. */
  private static final int WORDS = EDGE * EDGE;

  /** The cached blocks along each axis: 128 cells. */
  private static final int BLOCKS = 16;

  private static final long TOP_BITS = 0x8080_8080_8080_8080L;
  private static final long ONE_A_BYTE = 0x0101_0101_0101_0101L;

  /** Bit n of byte n. */
  private static final long DIAGONAL = 0x8040_2010_0804_0201L;

  private final Source source;
  private final CacheKeys keys = new CacheKeys(BLOCKS);

  /** The words of each block. */
  private final long[] words = new long[WORDS * keys.slots()];

  /** The words that each block has, a bit each. */
  private final long[] known = new long[keys.slots()];

  /** Blocks that changes reach: scratch. */
  private final IntBox reached = new IntBox();

  /** Gives the occupancies of cells. */
  interface Source {
    /**
     * Returns the occupancies of the cells from (8 word, j, k) on along x, a byte each, the first
     * in the lowest byte.
     *
     * @param scene the same one since {@link #forget}
     */
    long occupancies(CollisionScene scene, int word, int j, int k);

    /**
     * Fetches a value of a row that will be asked for soon, if it lies far away in memory. The
     * memory then brings the values of several rows at the same time.
     */
    default void fetch(int word, int j, int k) {}

    /** Forgets all occupancies and takes the present grey values. */
    void forget();

    /**
     * Forgets what depends on voxels whose solids changed.
     *
     * @param changed a box around these voxels; receives a box around the cells whose occupancies
     *     they may change
     */
    void forget(IntBox changed);
  }

  GreyOccupancyCache(Source source) {
    this.source = source;
  }

  /** Forgets all occupancies; the source takes the present grey values. */
  void forget() {
    source.forget();
    keys.forget();
  }

  /**
   * Forgets at least what depends on voxels whose solids changed.
   *
   * @param changed a box around these voxels; receives cells, see {@link Source#forget(IntBox)}
   */
  void forget(IntBox changed) {
    source.forget(changed);
    for (int axis = 0; axis < 3; axis++) {
      reached.setRange(axis, changed.low(axis) >> SHIFT, changed.high(axis) >> SHIFT);
    }
    if (CacheKeys.isLarge(reached)) {
      keys.forget();
      return;
    }
    for (int blockZ = reached.lowZ; blockZ <= reached.highZ; blockZ++) {
      for (int blockY = reached.lowY; blockY <= reached.highY; blockY++) {
        long inBox = wordsIn(blockY, blockZ, changed);
        for (int word = reached.lowX; word <= reached.highX; word++) {
          forgetWords(word, blockY, blockZ, inBox);
        }
      }
    }
  }

  /** Returns the words of a block whose rows lie in a box of cells, a bit each. */
  private static long wordsIn(int blockY, int blockZ, IntBox cells) {
    int y = EDGE * blockY;
    int z = EDGE * blockZ;
    return bits(
        Math.max(cells.lowY - y, 0),
        Math.min(cells.highY - y, MASK),
        Math.max(cells.lowZ - z, 0),
        Math.min(cells.highZ - z, MASK));
  }

  private void forgetWords(int word, int blockY, int blockZ, long changed) {
    int slot = keys.slot(word, blockY, blockZ);
    if (keys.holds(slot, word, blockY, blockZ)) {
      known[slot] &= ~changed;
    }
  }

  /**
   * Writes the occupancies of the 8x8x8 cells from (x,y,z) on, a row in a word, cell x in the
   * lowest byte; y fastest.
   *
   * @param scene the same one since {@link #forget}
   */
  void read(CollisionScene scene, int x, int y, int z, long[] dest) {
    for (int blockZ = z >> SHIFT; EDGE * blockZ < z + EDGE; blockZ++) {
      for (int blockY = y >> SHIFT; EDGE * blockY < y + EDGE; blockY++) {
        readRows(scene, x, y, z, blockY, blockZ, dest);
      }
    }
  }

  /** Writes those rows that lie in the blocks of one y and z. */
  private void readRows(
      CollisionScene scene, int x, int y, int z, int blockY, int blockZ, long[] dest) {
    int word = x >> SHIFT;
    int shift = Byte.SIZE * (x & MASK);
    int fromJ = Math.max(y, EDGE * blockY);
    int endJ = Math.min(y + EDGE, EDGE * (blockY + 1));
    int fromK = Math.max(z, EDGE * blockZ);
    int endK = Math.min(z + EDGE, EDGE * (blockZ + 1));
    long needed = bits(fromJ & MASK, (endJ - 1) & MASK, fromK & MASK, (endK - 1) & MASK);
    int lower = WORDS * slot(scene, word, blockY, blockZ, needed);
    int upper = shift == 0 ? lower : WORDS * slot(scene, word + 1, blockY, blockZ, needed);
    for (int k = fromK; k < endK; k++) {
      int row = EDGE * (k & MASK);
      int to = EDGE * (k - z) - y;
      for (int j = fromJ; j < endJ; j++) {
        int at = row | (j & MASK);
        // In two shifts, because the upper word has to move by 64 bits where the shift is 0.
        dest[to + j] = words[lower + at] >>> shift | words[upper + at] << 1 << (63 - shift);
      }
    }
  }

  /** Returns the words of a block from one row and layer to another, a bit each. */
  private static long bits(int firstJ, int lastJ, int firstK, int lastK) {
    long rows = (2L << lastJ) - (1L << firstJ);
    long layers = (-1L >>> (EDGE * (MASK - lastK))) & (-1L << (EDGE * firstK));
    return rows * ONE_A_BYTE & layers;
  }

  /** Returns the slot that holds a block with at least some words, a bit each. */
  private int slot(CollisionScene scene, int word, int blockY, int blockZ, long needed) {
    int slot = keys.slot(word, blockY, blockZ);
    if (!keys.holdsElseSet(slot, word, blockY, blockZ)) {
      known[slot] = 0;
    }
    long missing = needed & ~known[slot];
    if (missing != 0) {
      known[slot] |= missing;
      fill(scene, slot, word, EDGE * blockY, EDGE * blockZ, missing);
    }
    return slot;
  }

  /** Fills some words of the block from (8 word, y, z) on, a bit each. */
  private void fill(CollisionScene scene, int slot, int word, int y, int z, long missing) {
    for (long left = missing; left != 0; left &= left - 1) {
      int bit = Long.numberOfTrailingZeros(left);
      source.fetch(word, y + (bit & MASK), z + (bit >> SHIFT));
    }
    for (long left = missing; left != 0; left &= left - 1) {
      int bit = Long.numberOfTrailingZeros(left);
      words[WORDS * slot + bit] =
          source.occupancies(scene, word, y + (bit & MASK), z + (bit >> SHIFT));
    }
  }

  /** Returns eight bytes, each of ones if its bit is set and else 0; the lowest bit's is lowest. */
  static long bytesOf(int bits) {
    long own = bits * ONE_A_BYTE & DIAGONAL;
    long top = (own | (own & ~TOP_BITS) + ~TOP_BITS) & TOP_BITS; // set if any bit of a byte is
    return (top >>> 7) * 0xFF;
  }
}
