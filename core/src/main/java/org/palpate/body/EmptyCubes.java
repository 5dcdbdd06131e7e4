package org.palpate.body;

import java.util.Arrays;
import org.palpate.volume.BitCube;

/**
 * Finds empty cubes around points of a bit cube. The cube around a point follows from that around
 * the nearest grid corner, which is found by windows once and then cached. Many points of a tool
 * share a corner, and a tool that slides returns to corners that it has met.
 *
 * <p>The cache is a table of bricks of 4x4x4 corners. Bricks may share a place, which the last one
 * keeps. After an edit, {@link #forget} must be called. Haptic thread only; allocates nothing after
 * construction.
 */
public final class EmptyCubes {
  private static final int SHIFT = BitCube.BRICK_SHIFT;
  private static final int IN_BRICK = (1 << SHIFT) - 1;

  /** The binary logarithm of the most places of the table, of 40 bytes each. */
  private static final int MOST_PLACES_SHIFT = 14;

  /** The binary logarithm of about how many bricks share a place, in cubes that are not large. */
  private static final int BRICKS_PER_PLACE_SHIFT = 3;

  /** A brick has a long for its number and four for its 64 corners. */
  private static final int LONGS = 5;

  /** The bits for a corner: 0 if it is unknown, else 1 more than half the edge of its cube. */
  private static final int BITS = 4;

  private static final int CORNERS_PER_LONG = Long.SIZE / BITS;

  /** The largest half edge that is found, voxels. */
  static final int LARGEST_HALF_EDGE = 4;

  /** The 2x2x2 voxels in the middle of a window. */
  private static final long MIDDLE = 0x0000_0660_0660_0000L;

  /** All voxels of a window but those of its last column; below, of its last row and layer. */
  private static final long FIRST_COLUMNS = 0x7777_7777_7777_7777L;

  private static final long FIRST_ROWS = 0x0FFF_0FFF_0FFF_0FFFL;
  private static final long FIRST_LAYERS = 0xFFFF_FFFF_FFFFL;

  private final BitCube bits;
  private final BrickPlaces places;
  private final long[] table;

  /**
   * Creates an empty cache for a bit cube that the caller keeps.
   *
   * @param bits the voxels; after an edit, call {@link #forget}
   */
  public EmptyCubes(BitCube bits) {
    this.bits = bits;
    places = new BrickPlaces(bits, BRICKS_PER_PLACE_SHIFT, MOST_PLACES_SHIFT);
    table = new long[LONGS * places.count()];
  }

  /** Forgets all cubes, after voxels have changed. */
  public void forget() {
    if (places.forget()) {
      Arrays.fill(table, 0);
    }
  }

  /**
   * {@return half the edge of an empty cube around a point, voxels: 0 if none is found, else from
   * 0.5 to {@link #LARGEST_HALF_EDGE}}
   *
   * @param x the point along x, grid coordinates
   * @param y its y component
   * @param z its z component
   */
  public double around(double x, double y, double z) {
    if (!BitCube.hasWindow(x) || !BitCube.hasWindow(y) || !BitCube.hasWindow(z)) {
      return 0;
    }
    int i = nearest(x);
    int j = nearest(y);
    int k = nearest(z);
    int half = halfEdgeAt(i, j, k);
    if (half == 0) {
      return 0;
    }
    return half - Math.max(Math.abs(x - i), Math.max(Math.abs(y - j), Math.abs(z - k)));
  }

  /** Returns the corner nearest to a coordinate; faster than by {@link Math#floor}. */
  private static int nearest(double v) {
    double raised = v + 0.5;
    int whole = (int) raised;
    return raised < whole ? whole - 1 : whole;
  }

  private int halfEdgeAt(int i, int j, int k) {
    int x = i >> SHIFT;
    int y = j >> SHIFT;
    int z = k >> SHIFT;
    if (!places.contain(x, y, z)) {
      return halfEdge(bits, i, j, k);
    }
    long brick = places.index(x, y, z);
    long number = places.number(brick);
    int at = places.place(brick) * LONGS;
    if (table[at] != number) {
      table[at] = number;
      table[at + 1] = table[at + 2] = table[at + 3] = table[at + 4] = 0;
    }
    int corner = ((k & IN_BRICK) << SHIFT | (j & IN_BRICK)) << SHIFT | (i & IN_BRICK);
    int word = at + 1 + corner / CORNERS_PER_LONG;
    int shift = corner % CORNERS_PER_LONG * BITS;
    int known = (int) (table[word] >>> shift) & (1 << BITS) - 1;
    if (known != 0) {
      return known - 1;
    }
    int half = halfEdge(bits, i, j, k);
    table[word] |= (half + 1L) << shift;
    return half;
  }

  /**
   * Returns half the edge of an empty cube around a grid corner, voxels, from 0 to {@link
   * #LARGEST_HALF_EDGE}: the largest one whose voxels are all empty.
   */
  static int halfEdge(BitCube bits, int x, int y, int z) {
    long window = bits.window(x - 2, y - 2, z - 2);
    if (window != 0) {
      return (window & MIDDLE) == 0 ? 1 : 0;
    }
    long all = 0;
    for (int octant = 0; octant < 8; octant++) {
      int beyondX = octant & 1;
      int beyondY = octant >> 1 & 1;
      int beyondZ = octant >> 2;
      long voxels = bits.window(x - 4 + 4 * beyondX, y - 4 + 4 * beyondY, z - 4 + 4 * beyondZ);
      long near =
          (FIRST_COLUMNS << (1 - beyondX))
              & (FIRST_ROWS << (4 * (1 - beyondY)))
              & (FIRST_LAYERS << (16 * (1 - beyondZ)));
      if ((voxels & near) != 0) {
        return 2;
      }
      all |= voxels;
    }
    return all == 0 ? LARGEST_HALF_EDGE : 3;
  }
}
