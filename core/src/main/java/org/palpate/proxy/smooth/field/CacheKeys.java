package org.palpate.proxy.smooth.field;

import java.util.Arrays;
import org.palpate.geometry.IntBox;

/**
 * The keys of a direct-mapped cache over three integer coordinates. Positions that share a slot
 * take it from each other: the one that was set last holds it.
 *
 * <p>Positions that lie less than a quarter of the cache's edge apart along each axis have
 * different slots. Blocks as large as the cache are turned against each other. Otherwise both sides
 * of a solid that is as wide as such a block would take all their slots from each other.
 */
final class CacheKeys {
  private static final int LONGS = 2;
  private static final long LOW_INT = 0xFFFF_FFFFL;

  /** The largest box whose keys are forgotten one by one. */
  private static final int MOST_FORGOTTEN = 4096;

  /** The number of bits that hold a coordinate within the cache. */
  private final int shift;

  private final int mask;

  /** By how many slots a block is turned against the next one, along one axis. */
  private final int turn;

  /** For each slot x and y in one word, z and the generation in the next. */
  private final long[] keys;

  /** Counts from 1 how often all keys were forgotten; 0 marks a key that was forgotten alone. */
  private int generation = 1;

  /**
   * Creates keys without a position.
   *
   * @param edge the slots along each axis, a power of two
   */
  CacheKeys(int edge) {
    shift = Integer.numberOfTrailingZeros(edge);
    mask = edge - 1;
    turn = 3 * edge / 8 + 1;
    keys = new long[LONGS * edge * edge * edge];
  }

  /** Returns the number of slots. */
  int slots() {
    return keys.length / LONGS;
  }

  /** Forgets all keys. */
  void forget() {
    if (generation == Integer.MAX_VALUE) {
      Arrays.fill(keys, 0);
      generation = 0;
    }
    generation++;
  }

  /**
   * Forgets at least the keys of a box; all keys if the box is large. Cost: at most {@link
   * #MOST_FORGOTTEN} writes.
   *
   * @param box the positions, not empty
   */
  void forget(IntBox box) {
    if (isLarge(box)) {
      forget();
      return;
    }
    for (int z = box.lowZ; z <= box.highZ; z++) {
      for (int y = box.lowY; y <= box.highY; y++) {
        for (int x = box.lowX; x <= box.highX; x++) {
          forget(slot(x, y, z));
        }
      }
    }
  }

  /** Forgets the key of a slot. */
  void forget(int slot) {
    keys[LONGS * slot + 1] = 0;
  }

  /** Whether a box has too many positions to look at each. */
  static boolean isLarge(IntBox box) {
    return (box.highX - box.lowX + 1.0)
            * (box.highY - box.lowY + 1.0)
            * (box.highZ - box.lowZ + 1.0)
        > MOST_FORGOTTEN;
  }

  /** Returns the slot for a position. */
  int slot(int x, int y, int z) {
    int atX = x + turn * (y >> shift) & mask;
    int atY = y + turn * (z >> shift) & mask;
    int atZ = z + turn * (x >> shift) & mask;
    return (atZ << shift | atY) << shift | atX;
  }

  /** Whether a slot holds a position. */
  boolean holds(int slot, int x, int y, int z) {
    return keys[LONGS * slot] == first(x, y) && keys[LONGS * slot + 1] == second(z);
  }

  /** Whether a slot holds a position; otherwise it does from now on. */
  boolean holdsElseSet(int slot, int x, int y, int z) {
    boolean holds = holds(slot, x, y, z);
    if (!holds) {
      keys[LONGS * slot] = first(x, y);
      keys[LONGS * slot + 1] = second(z);
    }
    return holds;
  }

  private static long first(int x, int y) {
    return (long) x << Integer.SIZE | (y & LOW_INT);
  }

  private long second(int z) {
    return (long) z << Integer.SIZE | generation;
  }
}
