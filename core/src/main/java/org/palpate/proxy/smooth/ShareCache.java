package org.palpate.proxy.smooth;

import java.util.Arrays;

/**
 * The shares of the voxels that were asked for last, for windows that move by a voxel at a time:
 * 16x16x16 places, each for the voxels that agree with it in the last four bits of i, j and k.
 */
final class ShareCache {
  private static final int EDGE_BITS = 4;
  private static final int LAST_BITS = (1 << EDGE_BITS) - 1;

  /** Bits for each index of a voxel in a key: grids are shorter than 2^21. */
  private static final int INDEX_BITS = 21;

  private final LiveGrey live;
  private GreySurface grey;
  private final double[] shares = new double[1 << (3 * EDGE_BITS)];
  private final long[] keys = new long[1 << (3 * EDGE_BITS)];

  ShareCache(LiveGrey live) {
    this.live = live;
    forget();
  }

  /** Forgets the shares of values that are no longer those of the surface. */
  void forget() {
    GreySurface now = live.now();
    if (!now.equals(grey)) {
      grey = now;
      Arrays.fill(keys, -1);
    }
  }

  /** The share of voxel (i,j,k), which lies in the grid, by its grey value. */
  double share(int i, int j, int k) {
    int place = (k & LAST_BITS) << (2 * EDGE_BITS) | (j & LAST_BITS) << EDGE_BITS | (i & LAST_BITS);
    long key = (long) k << (2 * INDEX_BITS) | (long) j << INDEX_BITS | i;
    if (keys[place] != key) {
      keys[place] = key;
      shares[place] = grey.share(grey.volume().value(i, j, k));
    }
    return shares[place];
  }
}
