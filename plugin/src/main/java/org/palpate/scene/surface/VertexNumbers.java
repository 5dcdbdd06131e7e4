package org.palpate.scene.surface;

import java.util.Arrays;

/** Numbers vertices by their keys, in the order in which they come. One thread. */
final class VertexNumbers {
  private static final long FREE = -1;

  private final long[] keys;
  private final int[] numbers;
  private int count;

  /**
   * Creates an empty table with open addressing.
   *
   * @param most the largest number of vertices
   */
  VertexNumbers(int most) {
    int capacity = Integer.highestOneBit(Math.max(8, 2 * most)) << 1;
    keys = new long[capacity];
    numbers = new int[capacity];
    Arrays.fill(keys, FREE);
  }

  /** Returns the number of a vertex; a new one gets the {@link #count} before the call. */
  int number(long key) {
    int slot = Long.hashCode(key * 0x9E3779B97F4A7C15L) & (keys.length - 1);
    while (keys[slot] != key && keys[slot] != FREE) {
      slot = (slot + 1) & (keys.length - 1);
    }
    if (keys[slot] == FREE) {
      keys[slot] = key;
      numbers[slot] = count++;
    }
    return numbers[slot];
  }

  /** Returns the number of different vertices so far. */
  int count() {
    return count;
  }
}
