package org.palpate.proxy.smooth.field;

import org.palpate.collision.CollisionScene;

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

  /** The cells that are left on an axis beside a window. */
  private static final int ROOM = EDGE - BinaryWindow.EDGE;

  private final BrickSource source;
  private final long[] words = new long[EDGE * BRICKS];
  private int lowX;
  private int lowY;
  private int lowZ;
  private boolean valid;

  /** Creates a copy of the cells that a source gives. */
  BrickCopy(BrickSource source) {
    this.source = source;
  }

  /** Forgets the bits, and those of the source. */
  void forget() {
    valid = false;
    source.forget();
  }

  /** Makes the copy hold the window from (x,y,z) on, by reading other bricks if it must. */
  void cover(CollisionScene scene, int x, int y, int z) {
    if (!holds(x, y, z)) {
      lowX = centred(x);
      lowY = centred(y);
      lowZ = centred(z);
      valid = true;
      read(scene);
    }
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

  /** Returns the bits, not to be changed. */
  long[] words() {
    return words;
  }

  /** Returns the word that holds row y of layer z, both counted within the copy. */
  static int wordOfRow(int y, int z) {
    return z * BRICKS + (y >> 2);
  }

  private void read(CollisionScene scene) {
    for (int z = 0; z < BRICKS; z++) {
      for (int y = 0; y < BRICKS; y++) {
        readRowOfBricks(scene, y, z);
      }
    }
  }

  private void readRowOfBricks(CollisionScene scene, int y, int z) {
    int brickX = lowX >> 2;
    int brickY = (lowY >> 2) + y;
    int brickZ = (lowZ >> 2) + z;
    long a = source.brick(scene, brickX, brickY, brickZ);
    long b = source.brick(scene, brickX + 1, brickY, brickZ);
    long c = source.brick(scene, brickX + 2, brickY, brickZ);
    long d = source.brick(scene, brickX + 3, brickY, brickZ);
    boolean empty = (a | b | c | d) == 0;
    for (int layer = 0; layer < BRICK_EDGE; layer++) {
      words[(BRICK_EDGE * z + layer) * BRICKS + y] =
          empty ? 0 : rowsOfBricks(a, b, c, d, EDGE * layer);
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
}
