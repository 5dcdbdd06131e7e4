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
  private static final int LONGS = 2;
  private static final long LOW_INT = 0xFFFF_FFFFL;

  /** For each slot x and y in one word, z and the generation in the next. */
  private final long[] keys = new long[LONGS * SLOTS];

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
    int at = LONGS * slot;
    long first = (long) x << Integer.SIZE | (y & LOW_INT);
    long second = (long) z << Integer.SIZE | generation;
    boolean holds = keys[at] == first && keys[at + 1] == second;
    if (!holds) {
      keys[at] = first;
      keys[at + 1] = second;
    }
    return holds;
  }
}
