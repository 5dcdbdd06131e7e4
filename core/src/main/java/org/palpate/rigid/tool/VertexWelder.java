package org.palpate.rigid.tool;

import java.util.Arrays;

/**
 * Finds vertices with the same coordinates by a hash table with open addressing. Formats such as
 * STL repeat each vertex in every triangle. One thread.
 */
final class VertexWelder {
  private final double[] unique;
  private final int[] indexOf;
  private int count;

  /**
   * Finds equal vertices.
   *
   * @param coordinates x, y and z of each vertex
   */
  VertexWelder(double[] coordinates) {
    int vertices = coordinates.length / 3;
    unique = new double[coordinates.length];
    indexOf = new int[vertices];
    int[] table = new int[Integer.highestOneBit(Math.max(4, vertices)) * 4];
    Arrays.fill(table, -1);
    for (int n = 0; n < vertices; n++) {
      indexOf[n] = find(table, coordinates[3 * n], coordinates[3 * n + 1], coordinates[3 * n + 2]);
    }
  }

  private int find(int[] table, double x, double y, double z) {
    double px = x + 0.0; // -0 becomes 0
    double py = y + 0.0;
    double pz = z + 0.0;
    long hash = Double.hashCode(px) * 0x9e3779b97f4a7c15L;
    hash = (hash ^ Double.hashCode(py)) * 0xc2b2ae3d27d4eb4fL;
    hash = (hash ^ Double.hashCode(pz)) * 0x165667b19e3779f9L;
    int slot = (int) (hash >>> 32) & (table.length - 1);
    while (table[slot] >= 0 && !isAt(table[slot], px, py, pz)) {
      slot = (slot + 1) & (table.length - 1);
    }
    if (table[slot] < 0) {
      table[slot] = count;
      unique[3 * count] = px;
      unique[3 * count + 1] = py;
      unique[3 * count + 2] = pz;
      count++;
    }
    return table[slot];
  }

  private boolean isAt(int index, double x, double y, double z) {
    return unique[3 * index] == x && unique[3 * index + 1] == y && unique[3 * index + 2] == z;
  }

  /** Returns the coordinates of the different vertices. */
  double[] coordinates() {
    return Arrays.copyOf(unique, 3 * count);
  }

  /** Returns triangles of different vertices, without those that have two equal vertices. */
  int[] weld(int[] corners) {
    int[] welded = new int[corners.length];
    int kept = 0;
    for (int n = 0; n + 2 < corners.length; n += 3) {
      int a = indexOf[corners[n]];
      int b = indexOf[corners[n + 1]];
      int c = indexOf[corners[n + 2]];
      if (a != b && b != c && c != a) {
        welded[kept] = a;
        welded[kept + 1] = b;
        welded[kept + 2] = c;
        kept += 3;
      }
    }
    return Arrays.copyOf(welded, kept);
  }
}
