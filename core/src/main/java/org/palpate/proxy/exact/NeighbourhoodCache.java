package org.palpate.proxy.exact;

import java.util.Arrays;
import org.palpate.collision.CollisionScene;

/**
 * A cache of the solid voxels among the 26 neighbours of a voxel, as bits of one word. It keeps
 * windows of 4x4x4 voxels that start at even numbers. Each window holds the neighbourhoods of 2x2x2
 * voxels, and a point that slides asks for the same few again and again.
 *
 * <pre>
 *   bit   16 (z + 1) + 4 (y + 1) + (x + 1)     the neighbour at offset x, y, z, each -1 to 1; other bits are undefined
 * </pre>
 *
 * <p>Invariant: the cache is true only if {@link #forget} is called after every change of the
 * solids. Haptic thread only. Cost: a few nanoseconds for a cached window, else one {@link
 * CollisionScene#window}.
 */
final class NeighbourhoodCache {
  /** The bit of the voxel itself; the steps below lead from it to its neighbours. */
  static final int CENTRE = 21;

  static final int STEP_X = 1;
  static final int STEP_Y = 4;
  static final int STEP_Z = 16;

  /** The windows around the proxy, around the top of a step, and around the slide from there. */
  private static final int CAPACITY = 16;

  /** An odd number, at which no window starts. */
  private static final int NOWHERE = 1;

  private final int[] x = new int[CAPACITY];
  private final int[] y = new int[CAPACITY];
  private final int[] z = new int[CAPACITY];

  private final long[] solid = new long[CAPACITY];

  private final boolean keeps;
  private long queries;
  private long misses;

  /**
   * Creates an empty cache.
   *
   * @param keeps whether windows are kept; if not, each query reads the scene
   */
  NeighbourhoodCache(boolean keeps) {
    this.keeps = keeps;
    forget();
  }

  /** Returns the number of queries that the cache answered. */
  long hits() {
    return queries - misses;
  }

  /** Returns the step along an axis: 0 is x, 1 is y, 2 is z. */
  static int step(int axis) {
    return axis == 0 ? STEP_X : axis == 1 ? STEP_Y : STEP_Z;
  }

  /** Removes all windows. */
  void forget() {
    Arrays.fill(x, NOWHERE);
  }

  /** Returns the solid voxels among (i,j,k) and its neighbours. */
  long around(CollisionScene scene, int i, int j, int k) {
    int fromX = (i - 1) & ~1;
    int fromY = (j - 1) & ~1;
    int fromZ = (k - 1) & ~1;
    int at = ((fromX >> 1) + 5 * (fromY >> 1) + 3 * (fromZ >> 1)) & (CAPACITY - 1);
    queries++;
    if (x[at] != fromX || y[at] != fromY || z[at] != fromZ || !keeps) {
      misses++;
      solid[at] = scene.window(fromX, fromY, fromZ);
      x[at] = fromX;
      y[at] = fromY;
      z[at] = fromZ;
    }
    return solid[at] >>> ((i - 1 & 1) * STEP_X + (j - 1 & 1) * STEP_Y + (k - 1 & 1) * STEP_Z);
  }
}
