package org.palpate.proxy.smooth.field;

import java.util.Arrays;

/**
 * Flood fill by faces of the empty voxels of a window.
 *
 * <p>Layout as in {@link BinaryWindow}. All voxels of a word spread at once: a run of free voxels
 * that holds a reached one is filled by a carry or by shifts of doubling length.
 */
final class FloodFill {
  private static final int EDGE = BinaryWindow.EDGE;
  private static final int WORDS = BinaryWindow.WORDS;
  private static final int AXES = 3;

  private final long[] free;
  private final long[] reached;

  /**
   * Creates a fill over two arrays of words.
   *
   * @param free the empty voxels of a window, and of a face behind it
   * @param reached receives the voxels that are reached, in the same layout
   */
  FloodFill(long[] free, long[] reached) {
    this.free = free;
    this.reached = reached;
  }

  /**
   * Writes the voxels that the empty voxel (x,y,z) reaches by faces. It fills runs along one axis
   * after the other, until two axes in succession add nothing.
   */
  void floodFrom(int x, int y, int z) {
    Arrays.fill(reached, 0);
    reached[z * WORDS + (y >> 2)] = 1L << ((y & 3) << 4 | x);
    int settledAxes = 0;
    for (int axis = 0; settledAxes < AXES; axis = axis == 2 ? 0 : axis + 1) {
      long added = spreadAlong(axis);
      settledAxes = added != 0 ? 1 : settledAxes + 1;
    }
  }

  /** Spreads along z, y or x for axis 0, 1 or 2; returns 0 if that adds no voxel. */
  private long spreadAlong(int axis) {
    return axis == 0 ? spreadAlongZ() : axis == 1 ? spreadAlongY() : spreadAlongX();
  }

  private long spreadAlongX() {
    long added = 0;
    for (int word = 0; word < EDGE * WORDS; word++) {
      long before = reached[word];
      long after = spreadRows(before, free[word]);
      added |= before ^ after;
      reached[word] = after;
    }
    return added;
  }

  private long spreadAlongY() {
    long added = 0;
    for (int layer = 0; layer < EDGE * WORDS; layer += WORDS) {
      long freeA = free[layer];
      long freeB = free[layer + 1];
      long freeC = free[layer + 2];
      long a = spreadUp(reached[layer], freeA);
      long b = spreadUp(reached[layer + 1] | (freeB & a >>> 48), freeB);
      long c = spreadDown(spreadUp(reached[layer + 2] | (freeC & b >>> 48), freeC), freeC);
      b = spreadDown(b | (freeB & c << 48), freeB);
      a = spreadDown(a | (freeA & b << 48), freeA);
      added |= (a ^ reached[layer]) | (b ^ reached[layer + 1]) | (c ^ reached[layer + 2]);
      reached[layer] = a;
      reached[layer + 1] = b;
      reached[layer + 2] = c;
    }
    return added;
  }

  private long spreadAlongZ() {
    long added = 0;
    long a = 0;
    long b = 0;
    long c = 0;
    for (int layer = 0; layer < EDGE * WORDS; layer += WORDS) {
      long addA = a & free[layer] & ~reached[layer];
      long addB = b & free[layer + 1] & ~reached[layer + 1];
      long addC = c & free[layer + 2] & ~reached[layer + 2];
      added |= addA | addB | addC;
      reached[layer] = a = reached[layer] | addA;
      reached[layer + 1] = b = reached[layer + 1] | addB;
      reached[layer + 2] = c = reached[layer + 2] | addC;
    }
    for (int layer = (EDGE - 2) * WORDS; layer >= 0; layer -= WORDS) {
      long addA = a & free[layer] & ~reached[layer];
      long addB = b & free[layer + 1] & ~reached[layer + 1];
      long addC = c & free[layer + 2] & ~reached[layer + 2];
      added |= addA | addB | addC;
      reached[layer] = a = reached[layer] | addA;
      reached[layer + 1] = b = reached[layer + 1] | addB;
      reached[layer + 2] = c = reached[layer + 2] | addC;
    }
    return added;
  }

  /**
   * Whether the empty voxels of one layer are connected within it. Overwrites the layer's reached
   * voxels.
   *
   * @param layer the first word of the layer
   */
  boolean isLayerConnected(int layer) {
    long freeA = free[layer];
    long freeB = free[layer + 1];
    long freeC = free[layer + 2];
    long a = Long.lowestOneBit(freeA);
    long b = freeA == 0 ? Long.lowestOneBit(freeB) : 0;
    long c = (freeA | freeB) == 0 ? Long.lowestOneBit(freeC) : 0;
    boolean all = a == freeA && b == freeB && c == freeC;
    boolean settled = all;
    while (!settled) {
      long nextA = spreadColumns(spreadRows(a | b << 48, freeA), freeA);
      long nextB = spreadColumns(spreadRows(b | nextA >>> 48 | c << 48, freeB), freeB);
      long nextC = spreadColumns(spreadRows(c | nextB >>> 48, freeC), freeC);
      all = nextA == freeA && nextB == freeB && nextC == freeC;
      settled = all || (nextA == a && nextB == b && nextC == c);
      a = nextA;
      b = nextB;
      c = nextC;
    }
    return all;
  }

  /** Fills the runs of free voxels that hold a seed, along y both ways, inside a word. */
  private static long spreadColumns(long seeds, long free) {
    return spreadDown(spreadUp(seeds, free), free);
  }

  private static long spreadUp(long seeds, long free) {
    long up = seeds | (free & seeds << 16);
    return up | (free & free << 16 & up << 32);
  }

  private static long spreadDown(long seeds, long free) {
    long down = seeds | (free & seeds >>> 16);
    return down | (free & free >>> 16 & down >>> 32);
  }

  /** Fills the runs of free voxels that hold a seed, along x both ways. */
  private static long spreadRows(long seeds, long free) {
    long up = seeds & free;
    // A sum carries from the lowest seed of a run to its upper end; rows end in clear bits.
    long run = (((free + up) ^ free) | up) & free;
    run |= free & run >>> 1;
    long pairs = free & free >>> 1;
    run |= pairs & run >>> 2;
    long fours = pairs & pairs >>> 2;
    run |= fours & run >>> 4;
    long eights = fours & fours >>> 4;
    return run | (eights & run >>> 8);
  }
}
