package org.palpate.proxy;

import java.util.Arrays;

/**
 * Which of a voxel's 26 neighbours are solid, as bits of one word, kept for the voxels last asked
 * for: a point that slides asks for the same few again and again.
 *
 * <pre>
 *   bit   16 (z + 1) + 4 (y + 1) + (x + 1)     of the neighbour at offset x, y, z, each -1 to 1; others mean nothing
 * </pre>
 *
 * <p>Must be told to forget where a solid changed. Haptic thread only. Cost: a few nanoseconds
 * where the voxel is known; else a {@link Obstacles#window}.
 */
final class Neighbourhoods {
  /** The bit of the voxel itself; the steps below lead from it to its neighbours. */
  static final int CENTRE = 21;

  static final int STEP_X = 1;
  static final int STEP_Y = 4;
  static final int STEP_Z = 16;

  /** The point's voxel, and those that it climbs to and slides on to from there. */
  private static final int KEPT = 16;

  /** No voxel's coordinate: its neighbours have none. */
  private static final int NOWHERE = Integer.MIN_VALUE;

  private final int[] x = new int[KEPT];
  private final int[] y = new int[KEPT];
  private final int[] z = new int[KEPT];

  private final long[] solid = new long[KEPT];

  private final boolean keeps;
  private long asked;
  private long looked;

  /**
   * Knows nothing yet.
   *
   * @param keeps whether anything is kept, or looked at each time, to see what that is worth
   */
  Neighbourhoods(boolean keeps) {
    this.keeps = keeps;
    forget();
  }

  /** How often a neighbourhood was known. */
  long known() {
    return asked - looked;
  }

  /** The step along an axis: 0 is x, 1 is y, 2 is z. */
  static int step(int axis) {
    return axis == 0 ? STEP_X : axis == 1 ? STEP_Y : STEP_Z;
  }

  /** Forgets all. */
  void forget() {
    Arrays.fill(x, NOWHERE);
    Arrays.fill(solid, 0); // so far out that a cell number is cut to this one, nothing is solid
  }

  /** The solid voxels among (i,j,k) and its neighbours. */
  long around(Obstacles obstacles, int i, int j, int k) {
    int at = (i + 5 * j + 3 * k) & (KEPT - 1);
    asked++;
    if (x[at] != i || y[at] != j || z[at] != k || !keeps) {
      looked++;
      solid[at] = obstacles.window(i - 1, j - 1, k - 1);
      x[at] = i;
      y[at] = j;
      z[at] = k;
    }
    return solid[at];
  }
}
