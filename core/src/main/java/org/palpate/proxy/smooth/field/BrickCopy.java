package org.palpate.proxy.smooth.field;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.IntBox;

/**
 * A copy of 16x16x16 cells that starts at a multiple of 4, as rows of 16 bits. Windows that move by
 * a few cells find their bits in it. Cells are voxels, or thin slices of them, see {@link
 * ThinGrid}.
 *
 * <pre>
 *   word 4 z + w   bit  r r x x x x    layer z, row 4 w + r, cell x
 * </pre>
 */
final class BrickCopy {
  private static final int EDGE = 16;
  private static final int BRICKS = 4;
  private static final int BRICK_EDGE = 4;

  /** The number of bricks. */
  private static final int COUNT = BRICKS * BRICKS * BRICKS;

  /** The cells that are left on an axis beside a window. */
  static final int ROOM = EDGE - BinaryWindow.EDGE;

  /** For each offset along x, the bricks that another copy holds as well, see {@link #masks}. */
  private static final long[] MASK_X = masks(1, BRICKS);

  private static final long[] MASK_Y = masks(4, BRICKS);
  private static final long[] MASK_Z = masks(16, BRICKS);

  private final BrickSource source;

  /** The bricks, x fastest. */
  private long[] bricks = new long[COUNT];

  /** The bricks of the copy before this one. */
  private long[] bricksBefore = new long[COUNT];

  private final long[] words = new long[EDGE * BRICKS];
  private int lowX;
  private int lowY;
  private int lowZ;
  private boolean valid;
  private long reads;

  /** Creates a copy of the cells that a source gives. */
  BrickCopy(BrickSource source) {
    this.source = source;
  }

  /** Forgets the bits, and those of the source. */
  void forget() {
    valid = false;
    source.forget();
  }

  /**
   * Forgets the bits, and those of the source that changes reach.
   *
   * @param changed the voxels; receives the cells that they may change, see {@link
   *     BrickSource#forget(IntBox)}
   */
  void forget(IntBox changed) {
    valid = false;
    source.forget(changed);
  }

  /** Makes the copy hold the window from (x,y,z) on, by reading other bricks if it must. */
  void cover(CollisionScene scene, int x, int y, int z) {
    if (!holds(x, y, z)) {
      int fromX = centred(x);
      int fromY = centred(y);
      int fromZ = centred(z);
      int byX = (fromX - lowX) >> 2;
      int byY = (fromY - lowY) >> 2;
      int byZ = (fromZ - lowZ) >> 2;
      long kept = valid ? overlap(byX, byY, byZ) : 0;
      int offset = number(byX, byY, byZ);
      lowX = fromX;
      lowY = fromY;
      lowZ = fromZ;
      valid = true;
      reads++;
      read(scene, kept, offset);
    }
  }

  /**
   * Returns masks for a block of 4x4x4 elements, a bit each, beside a window. Each mask holds the
   * elements that lie in the window along one axis. Mask n is that of a block that begins n - 3
   * elements beyond the low end of the window.
   *
   * @param stride the distance of neighbours along the axis in the word of a block, bits
   * @param edge the elements of the window along the axis
   */
  static long[] masks(int stride, int edge) {
    long[] masks = new long[edge + 3];
    for (int n = 0; n < masks.length; n++) {
      for (int bit = 0; bit < Long.SIZE; bit++) {
        int at = n - 3 + (bit / stride & 3);
        masks[n] |= at >= 0 && at < edge ? 1L << bit : 0;
      }
    }
    return masks;
  }

  /** Returns the mask of a block that begins at an offset from the window, 0 if it is outside. */
  static long mask(long[] masks, int offset) {
    return offset >= -3 && offset + 3 < masks.length ? masks[offset + 3] : 0;
  }

  /**
   * Returns the bricks of a copy, a bit each, that another copy holds as well.
   *
   * @param x the bricks by which it begins beyond the other one, with y and z
   */
  static long overlap(int x, int y, int z) {
    return mask(MASK_X, x) & mask(MASK_Y, y) & mask(MASK_Z, z);
  }

  /**
   * Returns those bricks of a copy that another copy holds as well, by their numbers there.
   *
   * @param bricks the bricks of the first copy, a bit each
   * @param x the number of bricks by which the other copy begins beyond the first, along x
   * @param y the same along y
   * @param z the same along z
   */
  static long moved(long bricks, int x, int y, int z) {
    int offset = number(x, y, z);
    return overlap(x, y, z) & (offset >= 0 ? bricks >>> offset : bricks << -offset);
  }

  /** Returns the number of brick (x,y,z) of a copy; for an offset, the difference of numbers. */
  static int number(int x, int y, int z) {
    return 16 * z + 4 * y + x;
  }

  /** Returns a brick of the copy. */
  long brick(int number) {
    return bricks[number];
  }

  /**
   * Whether some cells of the brick beside one of the copy are all solid. If the copy lacks that
   * brick, the source answers.
   *
   * @param step 1 or -1 along the axis
   * @param cells the cells, in the order of the word of a brick
   */
  boolean areSolidBeside(CollisionScene scene, int number, int axis, int step, long cells) {
    int at = ((number >> (2 * axis)) & 3) + step;
    return (at & 3) == at
        ? (~bricks[number + (step << (2 * axis))] & cells) == 0
        : areSolidOutside(scene, number, axis, step, cells);
  }

  private boolean areSolidOutside(
      CollisionScene scene, int number, int axis, int step, long cells) {
    return source.areSolid(
        scene,
        (lowX >> 2) + (number & 3) + (axis == 0 ? step : 0),
        (lowY >> 2) + (number >> 2 & 3) + (axis == 1 ? step : 0),
        (lowZ >> 2) + (number >> 4) + (axis == 2 ? step : 0),
        cells);
  }

  private boolean holds(int x, int y, int z) {
    return valid
        && x >= lowX
        && x <= lowX + ROOM
        && y >= lowY
        && y <= lowY + ROOM
        && z >= lowZ
        && z <= lowZ + ROOM;
  }

  /** Returns a multiple of 4 that leaves the window about as much room on either side. */
  private static int centred(int low) {
    return low - 1 & ~3;
  }

  /** Returns the coordinate of the first cell along x. */
  int lowX() {
    return lowX;
  }

  /** Returns the coordinate of the first cell along y. */
  int lowY() {
    return lowY;
  }

  /** Returns the coordinate of the first cell along z. */
  int lowZ() {
    return lowZ;
  }

  /** Returns how often bits were read; it changes whenever the bits do. */
  long reads() {
    return reads;
  }

  /** Returns the bits, not to be changed. */
  long[] words() {
    return words;
  }

  /** Returns the word that holds row y of layer z, both counted within the copy. */
  static int wordOfRow(int y, int z) {
    return z * BRICKS + (y >> 2);
  }

  /**
   * Reads the bricks and writes their rows.
   *
   * @param kept the bricks that the copy before held as well, a bit each
   * @param offset how much greater their number was there
   */
  private void read(CollisionScene scene, long kept, int offset) {
    long[] before = bricks;
    bricks = bricksBefore;
    bricksBefore = before;
    for (int n = 0; n < bricks.length; n++) {
      bricks[n] =
          (kept >>> n & 1) != 0
              ? before[n + offset]
              : source.brick(
                  scene, (lowX >> 2) + (n & 3), (lowY >> 2) + (n >> 2 & 3), (lowZ >> 2) + (n >> 4));
    }
    for (int z = 0; z < BRICKS; z++) {
      for (int y = 0; y < BRICKS; y++) {
        writeRows(y, z);
      }
    }
  }

  /** Writes the rows of four bricks side by side along x. */
  private void writeRows(int y, int z) {
    int first = number(0, y, z);
    long a = bricks[first];
    long b = bricks[first + 1];
    long c = bricks[first + 2];
    long d = bricks[first + 3];
    boolean uniform = (a | b | c | d) == 0 || (a & b & c & d) == -1;
    for (int layer = 0; layer < BRICK_EDGE; layer++) {
      words[(BRICK_EDGE * z + layer) * BRICKS + y] =
          uniform ? a : rowsOfBricks(a, b, c, d, EDGE * layer);
    }
  }

  /**
   * Returns four rows of 16 voxels from one layer of four bricks side by side: a transposition of 4
   * by 4 nibbles.
   */
  private static long rowsOfBricks(long a, long b, long c, long d, int shift) {
    long bricks =
        (a >>> shift & 0xFFFF)
            | (b >>> shift & 0xFFFF) << 16
            | (c >>> shift & 0xFFFF) << 32
            | (d >>> shift) << 48;
    long swap = (bricks ^ bricks >>> 12) & 0x0000_F0F0_0000_F0F0L;
    bricks ^= swap ^ swap << 12;
    swap = (bricks ^ bricks >>> 24) & 0x0000_0000_FF00_FF00L;
    return bricks ^ swap ^ swap << 24;
  }

  /**
   * Makes the bricks of a window that the field does not need yet, a few in each frame. A window in
   * a new region may need hundreds of columns between slices, which would make a single frame long.
   *
   * <p>The source keeps the bricks that it makes, and answers are the same with and without them.
   * Belongs to the haptic thread; allocates nothing.
   */
  static final class Ahead {
    /** The columns after which a frame makes no more bricks: about 10 us of work. */
    private static final int MAX_COLUMNS = 8;

    /** The most bricks that a frame looks at. Most are made already, or have no surface. */
    private static final int MAX_BRICKS = 8;

    /** All bricks of a copy. */
    private static final long ALL = -1;

    private final BrickSource cells;

    /** The brick coordinates of the first brick of the copy that the window needs. */
    private int lowX;

    private int lowY;
    private int lowZ;

    /** The bricks of the copy that were not made yet, a bit each. */
    private long missing = ALL;

    Ahead(BrickSource cells) {
      this.cells = cells;
    }

    /** Begins anew, because the source has forgotten its bricks. */
    void forget() {
      missing = ALL;
    }

    /** Makes some bricks of the copy that holds the window around corner (x,y,z). */
    void make(CollisionScene scene, int x, int y, int z) {
      moveTo(brick(x), brick(y), brick(z));
      long end = cells.columns() + MAX_COLUMNS;
      for (int n = 0; n < MAX_BRICKS && missing != 0 && cells.columns() < end; n++) {
        int next = Long.numberOfTrailingZeros(missing);
        missing &= missing - 1;
        cells.brick(scene, lowX + (next & 3), lowY + (next >> 2 & 3), lowZ + (next >> 4));
      }
    }

    private static int brick(int corner) {
      return centred(corner - BinaryWindow.TO_MIDDLE) >> 2;
    }

    private void moveTo(int x, int y, int z) {
      if (x != lowX || y != lowY || z != lowZ) {
        missing = ~moved(~missing, x - lowX, y - lowY, z - lowZ);
        lowX = x;
        lowY = y;
        lowZ = z;
      }
    }
  }
}
