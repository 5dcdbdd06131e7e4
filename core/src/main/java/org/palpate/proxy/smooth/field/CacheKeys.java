package org.palpate.proxy.smooth.field;

/**
 * The keys of a direct-mapped cache over three integer coordinates. Coordinates that are equal
 * modulo 16 share a slot; the one that was set last holds it.
 */
final class CacheKeys {
  /** The slots along each axis. */
  private static final int EDGE = 16;

  /** All slots. */
  static final int SLOTS = EDGE * EDGE * EDGE;

  private static final int MASK = EDGE - 1;
  private static final int INTS = 4;

  private final int[] keys = new int[INTS * SLOTS];
  private int generation = 1;

  /** Forgets all keys. */
  void forget() {
    generation++;
  }

  /** Returns the slot for a position. */
  static int slot(int x, int y, int z) {
    return ((z & MASK) * EDGE + (y & MASK)) * EDGE + (x & MASK);
  }

  /** Whether a slot holds a position; otherwise it does from now on. */
  boolean holdsElseSet(int slot, int x, int y, int z) {
    int at = INTS * slot;
    boolean holds =
        keys[at] == generation && keys[at + 1] == x && keys[at + 2] == y && keys[at + 3] == z;
    if (!holds) {
      keys[at] = generation;
      keys[at + 1] = x;
      keys[at + 2] = y;
      keys[at + 3] = z;
    }
    return holds;
  }
}
