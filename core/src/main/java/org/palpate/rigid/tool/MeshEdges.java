package org.palpate.rigid.tool;

import java.util.ArrayDeque;
import java.util.Arrays;

/**
 * The edges of a mesh: whether its triangles bound a solid, and a repair of their directions. Edges
 * are found in a hash table with open addressing. One thread.
 */
final class MeshEdges {
  private final int[] corners;

  /** The number of the edge that begins at each corner. */
  private final int[] edgeOf;

  /** For each edge: uses in the direction of rising indices less uses in the other. */
  private final int[] balance;

  private final int[] uses;

  /** The triangles of the first two uses of each edge. */
  private final int[] firstTriangle;

  private final int[] secondTriangle;
  private final int[] component;
  private int count;

  /** Finds the edges of triangles; {@link #orient} writes into the array. */
  MeshEdges(int[] corners) {
    this.corners = corners;
    edgeOf = new int[corners.length];
    balance = new int[corners.length];
    uses = new int[corners.length];
    firstTriangle = new int[corners.length];
    secondTriangle = new int[corners.length];
    component = new int[corners.length / 3];
    findEdges();
  }

  private void findEdges() {
    long[] keys = new long[Integer.highestOneBit(corners.length) * 4];
    int[] numbers = new int[keys.length];
    Arrays.fill(keys, -1);
    for (int n = 0; n < corners.length; n++) {
      long key = key(n);
      int slot = (int) ((key * 0x9e3779b97f4a7c15L) >>> 32) & (keys.length - 1);
      while (keys[slot] >= 0 && keys[slot] != key) {
        slot = (slot + 1) & (keys.length - 1);
      }
      if (keys[slot] < 0) {
        keys[slot] = key;
        numbers[slot] = count++;
      }
      addUse(numbers[slot], n);
    }
  }

  private void addUse(int edge, int n) {
    edgeOf[n] = edge;
    balance[edge] += isRising(n) ? 1 : -1;
    if (uses[edge]++ == 0) {
      firstTriangle[edge] = n / 3;
    } else {
      secondTriangle[edge] = n / 3;
    }
  }

  /** Returns both vertices of the edge that begins at a corner, the lower one in the high bits. */
  private long key(int n) {
    long from = corners[n];
    long to = corners[next(n)];
    return (Math.min(from, to) << 32) | Math.max(from, to);
  }

  /** Returns the index of the corner that follows in the same triangle. */
  private static int next(int n) {
    return n % 3 == 2 ? n - 2 : n + 1;
  }

  private boolean isRising(int n) {
    return corners[n] < corners[next(n)];
  }

  /** Whether each edge is used as often in one direction as in the other. */
  boolean isBalanced() {
    for (int edge = 0; edge < count; edge++) {
      if (balance[edge] != 0) {
        return false;
      }
    }
    return true;
  }

  /**
   * Flips triangles such that adjacent ones use their common edge in opposite directions.
   *
   * @return whether each edge is used twice and all directions agree afterwards
   */
  boolean orient() {
    for (int edge = 0; edge < count; edge++) {
      if (uses[edge] != 2 || firstTriangle[edge] == secondTriangle[edge]) {
        return false;
      }
    }
    Arrays.fill(component, -1);
    for (int triangle = 0; triangle < component.length; triangle++) {
      if (component[triangle] < 0 && !orientComponent(triangle)) {
        return false;
      }
    }
    return true;
  }

  private boolean orientComponent(int start) {
    ArrayDeque<Integer> open = new ArrayDeque<>();
    component[start] = start;
    open.add(start);
    while (!open.isEmpty()) {
      int triangle = open.remove();
      for (int n = 3 * triangle; n < 3 * triangle + 3; n++) {
        int edge = edgeOf[n];
        int other = firstTriangle[edge] + secondTriangle[edge] - triangle;
        boolean agrees = isRisingIn(triangle, edge) != isRisingIn(other, edge);
        if (!agrees && component[other] >= 0) {
          return false; // one-sided, as a Moebius strip
        }
        if (!agrees) {
          flip(other);
        }
        if (component[other] < 0) {
          component[other] = start;
          open.add(other);
        }
      }
    }
    return true;
  }

  private boolean isRisingIn(int triangle, int edge) {
    for (int n = 3 * triangle; n < 3 * triangle + 3; n++) {
      if (edgeOf[n] == edge) {
        return isRising(n);
      }
    }
    throw new AssertionError("the triangle has no such edge");
  }

  /** Reverses a triangle: its first edge keeps its index, and the other two swap theirs. */
  void flip(int triangle) {
    int at = 3 * triangle;
    swap(corners, at, at + 1);
    swap(edgeOf, at + 1, at + 2);
  }

  private static void swap(int[] values, int a, int b) {
    int spare = values[a];
    values[a] = values[b];
    values[b] = spare;
  }

  /** Returns the number of the connected part that holds a triangle, after {@link #orient}. */
  int component(int triangle) {
    return component[triangle];
  }
}
