package org.palpate.proxy.exact;

import java.util.Arrays;
import org.palpate.collision.CollisionScene;

/**
 * Which of a voxel's 26 neighbours are solid, as bits of one word. Windows of 4x4x4 voxels that
 * start at even numbers are kept, each with the neighbours of 2x2x2 voxels: a point that slides
 * asks for the same few again and again.
 *
 * <pre>
 *   bit   16 (z + 1) + 4 (y + 1) + (x + 1)     of the neighbour at offset x, y, z, each -1 to 1; others mean nothing
 * </pre>
 *
 * <p>Must be told to forget where a solid changed. Haptic thread only. Cost: a few nanoseconds
 * where the window is known; else a {@link CollisionScene#window}.
 */
final class NeighbourhoodCache {
  /** The bit of the voxel itself; the steps below lead from it to its neighbours. */
  static final int CENTRE = 21;

  static final int STEP_X = 1;
  static final int STEP_Y = 4;
  static final int STEP_Z = 16;

  /** Those around the point, and around where it climbs to and slides on to from there. */
  private static final int KEPT = 16;

  /** Odd: no window starts there. */
  private static final int NOWHERE = 1;

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
  NeighbourhoodCache(boolean keeps) {
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
  }

  /** The solid voxels among (i,j,k) and its neighbours. */
  long around(CollisionScene obstacles, int i, int j, int k) {
    int fromX = (i - 1) & ~1;
    int fromY = (j - 1) & ~1;
    int fromZ = (k - 1) & ~1;
    int at = ((fromX >> 1) + 5 * (fromY >> 1) + 3 * (fromZ >> 1)) & (KEPT - 1);
    asked++;
    if (x[at] != fromX || y[at] != fromY || z[at] != fromZ || !keeps) {
      looked++;
      solid[at] = obstacles.window(fromX, fromY, fromZ);
      x[at] = fromX;
      y[at] = fromY;
      z[at] = fromZ;
    }
    return solid[at] >>> ((i - 1 & 1) * STEP_X + (j - 1 & 1) * STEP_Y + (k - 1 & 1) * STEP_Z);
  }
}
