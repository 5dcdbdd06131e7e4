package org.palpate.volume.phantom;

import java.util.ArrayDeque;
import org.palpate.volume.BitCube;

/** Flood fills and neighbour tests for phantoms: slow and obviously correct. */
final class FloodFill {
  private static final int[][] SIDES = {
    {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}
  };

  private FloodFill() {}

  /** Receives voxels. */
  interface Voxels {
    void at(int i, int j, int k);
  }

  static void forEachSolid(BitCube bits, Voxels voxels) {
    for (int k = 0; k < bits.sizeZ(); k++) {
      for (int j = 0; j < bits.sizeY(); j++) {
        for (int i = 0; i < bits.sizeX(); i++) {
          if (bits.get(i, j, k)) {
            voxels.at(i, j, k);
          }
        }
      }
    }
  }

  /** Returns the empty voxels that a path through faces reaches from an empty voxel. */
  static BitCube throughFaces(BitCube solid, int i, int j, int k) {
    BitCube reached = new BitCube(solid.sizeX(), solid.sizeY(), solid.sizeZ());
    ArrayDeque<int[]> open = new ArrayDeque<>();
    visit(solid, reached, open, i, j, k);
    while (!open.isEmpty()) {
      int[] at = open.pop();
      for (int[] side : SIDES) {
        visit(solid, reached, open, at[0] + side[0], at[1] + side[1], at[2] + side[2]);
      }
    }
    return reached;
  }

  private static void visit(
      BitCube solid, BitCube reached, ArrayDeque<int[]> open, int i, int j, int k) {
    boolean inside =
        i >= 0 && i < solid.sizeX() && j >= 0 && j < solid.sizeY() && k >= 0 && k < solid.sizeZ();
    if (inside && !solid.get(i, j, k) && !reached.get(i, j, k)) {
      reached.set(i, j, k);
      open.push(new int[] {i, j, k});
    }
  }

  static boolean hasFaceNeighbour(BitCube bits, int i, int j, int k) {
    for (int[] side : SIDES) {
      if (bits.get(i + side[0], j + side[1], k + side[2])) {
        return true;
      }
    }
    return false;
  }

  /** Whether any of the 26 neighbours is set. */
  static boolean hasNeighbour(BitCube bits, int i, int j, int k) {
    for (int n = 0; n < 27; n++) {
      if (n != 13 && bits.get(i + n % 3 - 1, j + n / 3 % 3 - 1, k + n / 9 - 1)) {
        return true;
      }
    }
    return false;
  }

  /** Counts solid voxels between a voxel of {@code a} and one of {@code b} on opposite faces. */
  static long countThinBetween(BitCube solid, BitCube a, BitCube b) {
    long[] count = new long[1];
    forEachSolid(
        solid,
        (i, j, k) -> {
          for (int[] side : SIDES) {
            boolean before = a.get(i - side[0], j - side[1], k - side[2]);
            if (before && b.get(i + side[0], j + side[1], k + side[2])) {
              count[0]++;
            }
          }
        });
    return count[0];
  }
}
