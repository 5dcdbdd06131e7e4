package org.palpate.proxy.smooth.field;

import java.util.Arrays;
import java.util.List;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.IntBox;

/**
 * Corrections of a window of bits: the occupancy of each cell less its bit, summed up over each row
 * along x. A cell may be solid in part, see {@link ThinSlices} and {@link Terraces}.
 */
final class CellCorrections {
  /** The unit of corrections, as a fraction of a cell: 1 / 32. */
  static final int FRACTIONS = 32;

  private static final int EDGE = BinaryWindow.EDGE;

  /** The cells of a brick that lie in a window along each axis, by its offset from the window. */
  private static final long[] MASK_X = BrickCopy.masks(1, EDGE);

  private static final long[] MASK_Y = BrickCopy.masks(4, EDGE);
  private static final long[] MASK_Z = BrickCopy.masks(16, EDGE);

  /** The cells beside a window along x that may belong to a brick of it. */
  private static final int BESIDE = 3;

  private final Source[] sources;
  private final BinaryWindow window;

  /** The bits from which the window is loaded. */
  private final BrickCopy copy;

  /**
   * For each cell along x, the packed taps with which it adds to the three sums of its row. Before
   * and behind them are those of {@link #BESIDE} cells beside the window, which are 0.
   */
  private final long[] weights;

  /** The packed sums of each row, y fastest. */
  private final long[] rows = new long[EDGE * EDGE];

  /** Whether the seed reaches all empty cells of the window, so that all corrections count. */
  private boolean isAllReached;

  /** The layers that hold a correction, a bit each. */
  private int layers;

  /** For each source, the bricks of the copy that hold a correction, a bit each. */
  private final long[] correctedBricks;

  /** The number of {@link BrickCopy#reads} after which those were found. */
  private long knownReads;

  /** The brick coordinates of the copy's first brick at that time. */
  private int knownX;

  private int knownY;
  private int knownZ;

  /** Whether those bricks were found since {@link #forget}. */
  private boolean isKnown;

  /** Corrections of cells, in bricks of 4x4x4. */
  interface Source {
    /**
     * Returns the bricks of a copy that was read anew of which {@link #find} must be asked. The
     * others hold no correction, or are known.
     *
     * @param kept the bricks that were in the copy at the last call, a bit each
     * @param offset how much greater their number was there
     */
    default long toFind(long kept, int offset) {
      return ~kept;
    }

    /**
     * Returns more bricks of the same copy of which {@link #find} must be asked before a window is
     * corrected.
     */
    default long toFindInWindow(CollisionScene scene, BinaryWindow window) {
      return 0;
    }

    /**
     * Finds the corrections of a brick that comes into the copy.
     *
     * @param number the brick's number in the copy
     * @param x its brick coordinates, with y and z
     * @return whether there is any
     */
    boolean find(CollisionScene scene, int number, int x, int y, int z);

    /** Returns the slot in {@link #slots} of a brick of the copy that has corrections. */
    int slotOf(CollisionScene scene, int x, int y, int z);

    /** Returns the corrections that were found, always the same object. */
    Slots slots();

    /**
     * Whether a correction counts in a window where the seed does not reach all empty cells.
     *
     * @param x the corrected cell, counted from the low end of the window, as y and z
     */
    boolean counts(BinaryWindow window, int x, int y, int z);

    /** Returns how many columns were interpolated so far, for corrections or for bits. */
    long columns();

    /** Forgets all corrections. */
    void forget();

    /**
     * Forgets at least the corrections that depend on changed cells.
     *
     * @param cells a box around these cells, not to be changed
     */
    void forgetAround(IntBox cells);
  }

  /** The corrections of some bricks, each in a slot. */
  static final class Slots {
    private static final int CELLS = 64;

    /** For each slot the corrected cells, a bit each. */
    private final long[] corrected;

    /** For each slot and cell the correction, 0 where the cell is not {@link #corrected}. */
    private final byte[] corrections;

    Slots(int count) {
      corrected = new long[count];
      corrections = new byte[CELLS * count];
    }

    /** Removes the corrections of a brick. */
    void clear(int slot) {
      if (corrected[slot] != 0) {
        corrected[slot] = 0;
        Arrays.fill(corrections, CELLS * slot, CELLS * (slot + 1), (byte) 0);
      }
    }

    /** Returns the cells of a brick whose occupancy differs from their bit, a bit each. */
    long corrected(int slot) {
      return corrected[slot];
    }

    /**
     * Returns by how much the occupancy of a cell differs from its bit, in {@link #FRACTIONS}.
     *
     * @param bit the cell's place in the brick's word
     */
    int correction(int slot, int bit) {
      return corrections[CELLS * slot + bit];
    }

    /**
     * Returns the corrections of four cells side by side along x, each times its weight.
     *
     * @param bit the place of the first one in the brick's word
     * @param first its weight is element {@code first} of {@code weights}
     */
    long weighedRow(int slot, int bit, long[] weights, int first) {
      int at = CELLS * slot + bit;
      return corrections[at] * weights[first]
          + corrections[at + 1] * weights[first + 1]
          + corrections[at + 2] * weights[first + 2]
          + corrections[at + 3] * weights[first + 3];
    }

    /** Adds to the correction of a cell; the sum must fit into a byte. */
    void add(int slot, int bit, int correction) {
      corrections[CELLS * slot + bit] += (byte) correction;
      corrected[slot] |= 1L << bit;
    }
  }

  /**
   * Creates the sum of the corrections of some sources.
   *
   * @param weights for each cell along x its packed taps
   */
  CellCorrections(List<Source> sources, BinaryWindow window, long[] weights) {
    this.sources = sources.toArray(new Source[0]);
    this.window = window;
    this.weights = new long[EDGE + 2 * BESIDE];
    System.arraycopy(weights, 0, this.weights, BESIDE, EDGE);
    copy = window.copy();
    correctedBricks = new long[sources.size()];
  }

  /** Returns a difference of occupancies in {@link #FRACTIONS}, rounded. */
  static int inFractions(double difference) {
    return (int) Math.floor(FRACTIONS * difference + 0.5);
  }

  /** Forgets all corrections. */
  void forget() {
    isKnown = false;
    for (Source source : sources) {
      source.forget();
    }
  }

  /** Returns how many columns the sources have interpolated so far. */
  long columns() {
    long columns = 0;
    for (Source source : sources) {
      columns += source.columns();
    }
    return columns;
  }

  /**
   * Forgets at least the corrections that depend on changed cells.
   *
   * @param cells a box around these cells
   */
  void forget(IntBox cells) {
    isKnown = false;
    for (Source source : sources) {
      source.forgetAround(cells);
    }
  }

  /** Reads the corrections of the cells of the window as it was loaded last. */
  void read(CollisionScene scene) {
    if (layers != 0) {
      Arrays.fill(rows, 0);
      layers = 0;
    }
    if (!isKnown || knownReads != copy.reads()) {
      findCorrectedBricks(scene);
    }
    isAllReached = !window.anyUnreached();
    for (int n = 0; n < sources.length; n++) {
      long toFind = sources[n].toFindInWindow(scene, window);
      if (toFind != 0) {
        correctedBricks[n] |= find(scene, sources[n], toFind);
      }
      for (long left = correctedBricks[n]; left != 0; left &= left - 1) {
        readBrick(scene, sources[n], Long.numberOfTrailingZeros(left));
      }
    }
  }

  /**
   * Finds the bricks of the copy that hold corrections, so that windows look at no others. Those of
   * bricks that the copy before held are known.
   */
  private void findCorrectedBricks(CollisionScene scene) {
    int x = copy.lowX() >> 2;
    int y = copy.lowY() >> 2;
    int z = copy.lowZ() >> 2;
    int byX = x - knownX;
    int byY = y - knownY;
    int byZ = z - knownZ;
    long kept = isKnown ? BrickCopy.overlap(byX, byY, byZ) : 0;
    knownReads = copy.reads();
    knownX = x;
    knownY = y;
    knownZ = z;
    isKnown = true;
    for (int n = 0; n < sources.length; n++) {
      long found = kept & BrickCopy.moved(correctedBricks[n], byX, byY, byZ);
      long toFind = sources[n].toFind(kept, BrickCopy.number(byX, byY, byZ));
      correctedBricks[n] = found | find(scene, sources[n], toFind);
    }
  }

  /** Returns those of some bricks of the copy that hold corrections. */
  private long find(CollisionScene scene, Source source, long bricks) {
    long found = 0;
    for (long left = bricks; left != 0; left &= left - 1) {
      int n = Long.numberOfTrailingZeros(left);
      boolean any =
          source.find(scene, n, knownX + (n & 3), knownY + (n >> 2 & 3), knownZ + (n >> 4));
      found |= any ? 1L << n : 0;
    }
    return found;
  }

  private void readBrick(CollisionScene scene, Source source, int brick) {
    int x = copy.lowX() - window.lowX() + 4 * (brick & 3);
    int y = copy.lowY() - window.lowY() + 4 * (brick >> 2 & 3);
    int z = copy.lowZ() - window.lowZ() + 4 * (brick >> 4);
    long inside = BrickCopy.mask(MASK_X, x) & BrickCopy.mask(MASK_Y, y) & BrickCopy.mask(MASK_Z, z);
    if (inside != 0) {
      int slot =
          source.slotOf(
              scene, knownX + (brick & 3), knownY + (brick >> 2 & 3), knownZ + (brick >> 4));
      long cells = source.slots().corrected(slot) & inside;
      if (isAllReached) {
        addRows(source.slots(), slot, cells, x, y, z);
      } else {
        addReached(source, slot, cells, x, y, z);
      }
    }
  }

  /**
   * Adds the corrections of some cells of a brick that begins at a cell of the window: all those of
   * the brick that lie in the window.
   */
  private void addRows(Slots found, int slot, long cells, int brickX, int brickY, int brickZ) {
    long left = cells;
    while (left != 0) {
      int bit = Long.numberOfTrailingZeros(left) & ~3;
      int y = brickY + (bit >> 2 & 3);
      int z = brickZ + (bit >> 4);
      rows[EDGE * z + y] += found.weighedRow(slot, bit, weights, BESIDE + brickX);
      layers |= 1 << z;
      left &= ~(0xFL << bit);
    }
  }

  /** Adds the corrections of the given cells of a brick, as far as they count in this window. */
  private void addReached(Source source, int slot, long cells, int brickX, int brickY, int brickZ) {
    Slots found = source.slots();
    for (long left = cells; left != 0; left &= left - 1) {
      int bit = Long.numberOfTrailingZeros(left);
      int x = brickX + (bit & 3);
      int y = brickY + (bit >> 2 & 3);
      int z = brickZ + (bit >> 4);
      if (source.counts(window, x, y, z)) {
        rows[EDGE * z + y] += found.correction(slot, bit) * weights[BESIDE + x];
        layers |= 1 << z;
      }
    }
  }

  /** Whether any cell of a layer is corrected. */
  boolean anyInLayer(int z) {
    return (layers >>> z & 1) != 0;
  }

  /** Returns what the cells of each row add to its three packed sums, y fastest. */
  long[] ofRows() {
    return rows;
  }
}
