package org.palpate.proxy.smooth.field;

import java.util.Arrays;
import org.palpate.collision.CollisionScene;
import org.palpate.volume.GreyQuantizer;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;

/**
 * The shares of solid of voxels by their grey values, a byte each, for windows that move by a voxel
 * or a few at a time: what came in is read, the rest is kept.
 *
 * <p>A voxel that is solid against its grey value has the whole share, one that is empty against it
 * none: {@link #forget} after any change of solids or values.
 *
 * <pre>
 *   a ring of 16 planes of 16 rows, each for the voxels that agree with it in four bits of j and k
 *   row    two words: two octets that lie side by side, the even one first
 *   octet  8 voxels from a multiple of 8 on, the first in the lowest byte
 * </pre>
 */
final class GreyOccupancyCache {
  /** What stands for a share of 1. */
  static final int WHOLE = 255;

  /** Rows along an edge of what is read at once, and voxels of each. */
  static final int EDGE = ScalarVolume.LEVELS;

  private static final int RING = 16;
  private static final int IN_RING = RING - 1;
  private static final int WORDS = 2;
  private static final int NO_PLANE = Integer.MIN_VALUE;

  /** The top bits of bytes, and what brings them together in the topmost byte. */
  private static final long TOP_BITS = 0x8080_8080_8080_8080L;

  private static final long ONE_A_BYTE = 0x0101_0101_0101_0101L;
  private static final long OWN_BITS = 0x8040_2010_0804_0201L;
  private static final long GATHER = 0x0002_0408_1020_4081L;

  private final GreyIsosurfaceSource live;
  private final VoxelGrid grid;
  private final long[] ring = new long[RING * RING * WORDS];

  /**
   * What each plane of the ring holds: its k, the lower octet, the rows from low to before high.
   */
  private final int[] planes = new int[RING];

  private final int[] octets = new int[RING];
  private final int[] lows = new int[RING];
  private final int[] highs = new int[RING];
  private GreyIsosurface grey;
  private ScalarVolume volume;
  private GreyQuantizer scale;

  /** Which bricks of bits are kept, for even octets at 0 and for odd ones at 2: their octet. */
  private final int[] brickX = new int[3];

  private final int[] brickY = new int[3];
  private final int[] brickZ = new int[3];
  private final long[] bricks = new long[4];

  GreyOccupancyCache(GreyIsosurfaceSource live) {
    this.live = live;
    grid = live.grid();
    forget();
  }

  /** Forgets all shares, and takes the surface's values as they are now. */
  void forget() {
    GreyIsosurface now = live.now();
    if (!now.equals(grey)) { // else a frame after an edit would allocate
      grey = now;
      volume = now.volume();
      scale = new GreyQuantizer(now.threshold(), 0.5 * WHOLE / now.contrast());
    }
    Arrays.fill(planes, NO_PLANE);
    Arrays.fill(brickX, Integer.MIN_VALUE);
  }

  /**
   * Writes the shares of the 8x8x8 voxels from (x,y,z) on, a row a word, voxel x in the lowest
   * byte; y fastest.
   *
   * @param obstacles the same ones since {@link #forget}
   */
  void read(CollisionScene obstacles, int x, int y, int z, long[] dest) {
    int octet = x >> 3;
    int shift = (x & 7) << 3;
    int lower = octet & 1;
    int to = 0;
    for (int k = z; k < z + EDGE; k++) {
      int plane = k & IN_RING;
      if (planes[plane] != k
          || octets[plane] != octet
          || lows[plane] > y
          || highs[plane] < y + EDGE) {
        fill(plane, octet, y, k, obstacles);
      }
      for (int j = y; j < y + EDGE; j++) {
        int row = (plane * RING | (j & IN_RING)) * WORDS;
        // The upper octet goes up by 64 where the shift is 0.
        dest[to++] = ring[row + lower] >>> shift | ring[row + 1 - lower] << 1 << (63 - shift);
      }
    }
  }

  /** Makes a plane hold two octets of the rows from y on, of what it holds already as they are. */
  private void fill(int plane, int octet, int y, int k, CollisionScene obstacles) {
    boolean joins = planes[plane] == k && lows[plane] <= y + EDGE && highs[plane] >= y;
    int beyond = octet - octets[plane];
    if (!joins || Math.abs(beyond) > 1) {
      lows[plane] = y;
      highs[plane] = y;
    } else if (beyond != 0) {
      lows[plane] = Math.max(lows[plane], y);
      highs[plane] = Math.min(highs[plane], y + EDGE);
      for (int j = lows[plane]; j < highs[plane]; j++) {
        read(plane, beyond > 0 ? octet + 1 : octet, j, k, obstacles);
      }
    }
    planes[plane] = k;
    octets[plane] = octet;
    for (int j = highs[plane]; j < y + EDGE; j++) {
      readBoth(plane, octet, j, k, obstacles);
    }
    for (int j = y; j < lows[plane]; j++) {
      readBoth(plane, octet, j, k, obstacles);
    }
    keepRows(plane, Math.min(y, lows[plane]), Math.max(y + EDGE, highs[plane]), y);
  }

  /** Rows that have gone round the ring are lost: those that are farther from y. */
  private void keepRows(int plane, int low, int high, int y) {
    boolean grewUp = high > highs[plane];
    lows[plane] = grewUp ? Math.max(low, high - RING) : low;
    highs[plane] = grewUp ? high : Math.min(high, low + RING);
    assert lows[plane] <= y && highs[plane] >= y + EDGE : "rows of a window are kept: y=" + y;
  }

  private void readBoth(int plane, int octet, int j, int k, CollisionScene obstacles) {
    read(plane, octet, j, k, obstacles);
    read(plane, octet + 1, j, k, obstacles);
  }

  private void read(int plane, int octet, int j, int k, CollisionScene obstacles) {
    ring[(plane * RING | (j & IN_RING)) * WORDS | (octet & 1)] = shares(octet, j, k, obstacles);
  }

  private long shares(int octet, int j, int k, CollisionScene obstacles) {
    long shares = levels(octet << 3, j, k);
    int solid = solid(octet, j, k, obstacles);
    int above = (int) (((shares & TOP_BITS) * GATHER) >>> 56);
    return above == solid ? shares : corrected(shares, solid, above ^ solid);
  }

  /** The solid ones of an octet, a bit each; keeps two bricks for each octet of a row. */
  private int solid(int octet, int j, int k, CollisionScene obstacles) {
    int at = (octet & 1) << 1;
    if (brickX[at] != octet || brickY[at] != j >> 2 || brickZ[at] != k >> 2) {
      brickX[at] = octet;
      brickY[at] = j >> 2;
      brickZ[at] = k >> 2;
      bricks[at] = obstacles.brick(octet << 1, j >> 2, k >> 2);
      bricks[at + 1] = obstacles.brick(octet << 1 | 1, j >> 2, k >> 2);
    }
    int shift = (k & 3) << 4 | (j & 3) << 2;
    return (int) ((bricks[at] >>> shift & 0xF) | (bricks[at + 1] >>> shift & 0xF) << 4);
  }

  private long levels(int from, int j, int k) {
    if (grid.contains(from, j, k) && grid.contains(from + EDGE - 1, j, k)) {
      return volume.levels(from, j, k, scale);
    }
    long levels = 0;
    for (int n = 0; n < EDGE; n++) {
      if (grid.contains(from + n, j, k)) {
        levels |= (long) scale.of(volume.value(from + n, j, k)) << (8 * n);
      }
    }
    return levels;
  }

  private static long corrected(long shares, int solid, int wrong) {
    long ones = bytesOf(wrong);
    return (shares & ~ones) | (ones & bytesOf(solid));
  }

  /** Eight bytes that are all ones where a bit is set, else 0; the lowest bit's is the lowest. */
  static long bytesOf(int bits) {
    long own = bits * ONE_A_BYTE & OWN_BITS;
    long top = (own | (own & ~TOP_BITS) + ~TOP_BITS) & TOP_BITS; // where any bit of a byte is set
    return (top >>> 7) * 0xFF;
  }
}
