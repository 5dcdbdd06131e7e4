package org.palpate.proxy.smooth.field;

/**
 * Finds an open face of a window. A face is open if, from every free voxel of the window, a
 * straight column of free voxels leads to it. Beside a single surface, which is the usual case,
 * there is such a face. Finding it costs a fraction of a flood fill.
 *
 * <p>Layout as in {@link BinaryWindow}.
 */
final class OpenFaceFinder {
  private static final int EDGE = BinaryWindow.EDGE;
  private static final int WORDS = BinaryWindow.WORDS;
  private static final int LAST = (EDGE - 1) * WORDS;
  private static final int FACES = 6;

  /** Voxel 0 of each row of a word. */
  private static final long FIRST_OF_ROWS = 0x0001_0001_0001_0001L;

  /** All voxels of each row but the last. */
  private static final long BUT_LAST_OF_ROWS = 0x07FF_07FF_07FF_07FFL;

  /** All voxels of each row but the first. */
  private static final long BUT_FIRST_OF_ROWS = 0x0FFE_0FFE_0FFE_0FFEL;

  private static final long FIRST_ROW = 0x0FFF;

  private static final long LAST_ROW = 0x0FFFL << 48;

  /** A factor that gathers bits 0, 16, 32 and 48 into four bits from {@link #GATHERED} on. */
  private static final long GATHER = 1L << 45 | 1L << 30 | 1L << 15 | 1;

  private static final int GATHERED = 45;

  private final long[] free;
  private int lastFace = FACES - 1;

  /**
   * Creates a finder for one window.
   *
   * @param free the free voxels of the window, and room for a layer behind them
   */
  OpenFaceFinder(long[] free) {
    this.free = free;
  }

  /**
   * Looks for an open face, first at the one that was found last, and writes its free voxels as a
   * layer.
   *
   * @param dest the first word of the layer
   * @return false if there is none
   */
  boolean findOpenFace(int dest) {
    for (int n = 0; n < FACES; n++) {
      int face = lastFace + n < FACES ? lastFace + n : lastFace + n - FACES;
      if (isOpen(face)) {
        lastFace = face;
        copyFace(face, dest);
        return true;
      }
    }
    return false;
  }

  /** Whether a face is open: 0 and 1 for low and high x, 2 and 3 for y, 4 and 5 for z. */
  private boolean isOpen(int face) {
    return switch (face) {
      case 0 -> isOpenToLowX();
      case 1 -> isOpenToHighX();
      case 2 -> isOpenToLowY();
      case 3 -> isOpenToHighY();
      case 4 -> isOpenAlongZ(WORDS, 0);
      default -> isOpenAlongZ(0, WORDS);
    };
  }

  private boolean isOpenToLowX() {
    long closed = 0;
    for (int layer = 0; layer < EDGE * WORDS && closed == 0; layer += WORDS) {
      long a = free[layer];
      long b = free[layer + 1];
      long c = free[layer + 2];
      closed = ((a & ~(a << 1)) | (b & ~(b << 1)) | (c & ~(c << 1))) & BUT_FIRST_OF_ROWS;
    }
    return closed == 0;
  }

  private boolean isOpenToHighX() {
    long closed = 0;
    for (int layer = 0; layer < EDGE * WORDS && closed == 0; layer += WORDS) {
      long a = free[layer];
      long b = free[layer + 1];
      long c = free[layer + 2];
      closed = ((a & ~(a >>> 1)) | (b & ~(b >>> 1)) | (c & ~(c >>> 1))) & BUT_LAST_OF_ROWS;
    }
    return closed == 0;
  }

  private boolean isOpenToLowY() {
    long closed = 0;
    for (int layer = 0; layer < EDGE * WORDS && closed == 0; layer += WORDS) {
      long a = free[layer];
      long b = free[layer + 1];
      long c = free[layer + 2];
      closed |= a & ~(a << 16) & ~FIRST_ROW;
      closed |= b & ~(b << 16 | a >>> 48);
      closed |= c & ~(c << 16 | b >>> 48);
    }
    return closed == 0;
  }

  private boolean isOpenToHighY() {
    long closed = 0;
    for (int layer = 0; layer < EDGE * WORDS && closed == 0; layer += WORDS) {
      long a = free[layer];
      long b = free[layer + 1];
      long c = free[layer + 2];
      closed |= a & ~(a >>> 16 | b << 48);
      closed |= b & ~(b >>> 16 | c << 48);
      closed |= c & ~(c >>> 16) & ~LAST_ROW;
    }
    return closed == 0;
  }

  /**
   * Whether each free voxel of a layer is followed by one in the layer beside it, over all layers.
   *
   * @param from the offset in words of the layer that is looked at
   * @param to the offset of the one beside it, in the direction of the face
   */
  private boolean isOpenAlongZ(int from, int to) {
    long closed = 0;
    for (int layer = 0; layer < LAST && closed == 0; layer += WORDS) {
      closed = free[layer + from] & ~free[layer + to];
      closed |= free[layer + 1 + from] & ~free[layer + 1 + to];
      closed |= free[layer + 2 + from] & ~free[layer + 2 + to];
    }
    return closed == 0;
  }

  private void copyFace(int face, int dest) {
    if (face >= 4) {
      int layer = face == 4 ? 0 : LAST;
      free[dest] = free[layer];
      free[dest + 1] = free[layer + 1];
      free[dest + 2] = free[layer + 2];
      return;
    }
    for (int word = 0; word < WORDS; word++) {
      long rows = 0;
      for (int row = 0; row < 4; row++) {
        int layer = (4 * word + row) * WORDS;
        long ofFace = face < 2 ? column(layer, face * (EDGE - 1)) : row(layer, face);
        rows |= ofFace << (16 * row);
      }
      free[dest + word] = rows;
    }
  }

  /** Returns the voxels of a layer at one x, as a row. */
  private long column(int layer, int x) {
    return gather(free[layer], x)
        | gather(free[layer + 1], x) << 4
        | gather(free[layer + 2], x) << 8;
  }

  /** Returns voxel x of the four rows of a word, as four bits. */
  private static long gather(long word, int x) {
    long bits = word >>> x & FIRST_OF_ROWS;
    return (bits * GATHER) >>> GATHERED & 0xF;
  }

  /** Returns the first or the last row of a layer. */
  private long row(int layer, int face) {
    return face == 2 ? free[layer] & FIRST_ROW : free[layer + 2] >>> 48;
  }
}
