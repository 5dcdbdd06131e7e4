package org.palpate.volume;

import java.util.Arrays;
import java.util.List;
import org.palpate.geometry.IntBox;

/**
 * Finds the space inside a segment, as the soft tissue between a skin and the bones below it.
 *
 * <p>A voxel looks along the six directions of the axes. It lies in the space if it is empty, sees
 * the outer segment in at least five directions, and does not see the inner one in all six. So a
 * skin with an opening, or one that the grid cuts off, still encloses its space; and the cavities
 * of a skull stay empty.
 *
 * <p>Any thread, on bits that no other thread changes. Cost: one visit of each voxel in the box of
 * the outer segment.
 */
public final class EnclosedSpace {
  private static final int DIRECTIONS = 6;

  /** The directions in which the outer segment is seen from inside. */
  private static final int OUTER_DIRECTIONS = 5;

  private final BitCube bits;

  /** For each axis and each line along it, the first solid voxel; none is beyond the last. */
  private final int[][] first = new int[3][];

  /** The last solid voxel of each line; none is before the first. */
  private final int[][] last = new int[3][];

  private EnclosedSpace(BitCube bits) {
    this.bits = bits;
    for (int axis = 0; axis < 3; axis++) {
      int lines = size((axis + 1) % 3) * size((axis + 2) % 3);
      first[axis] = new int[lines];
      last[axis] = new int[lines];
      Arrays.fill(first[axis], Integer.MAX_VALUE);
      Arrays.fill(last[axis], Integer.MIN_VALUE);
    }
    bits.forEachRimVoxel(this::include);
  }

  /**
   * {@return the empty voxels between the outside of one segment and another}
   *
   * @param outer the segment that encloses the space
   * @param inner the segment whose inside does not belong to it
   * @param solids all segments whose voxels are not empty, with cubes of the same size
   */
  public static BitCube between(BitCube outer, BitCube inner, List<BitCube> solids) {
    EnclosedSpace around = new EnclosedSpace(outer);
    EnclosedSpace within = new EnclosedSpace(inner);
    BitCube space = new BitCube(outer.sizeX(), outer.sizeY(), outer.sizeZ());
    IntBox box = outer.bounds(); // No other voxel sees it in five directions.
    for (int k = box.lowZ; k <= box.highZ; k++) {
      for (int j = box.lowY; j <= box.highY; j++) {
        for (int i = box.lowX; i <= box.highX; i++) {
          if (around.directions(i, j, k) >= OUTER_DIRECTIONS
              && within.directions(i, j, k) < DIRECTIONS
              && isEmpty(solids, i, j, k)) {
            space.set(i, j, k);
          }
        }
      }
    }
    return space;
  }

  private static boolean isEmpty(List<BitCube> solids, int i, int j, int k) {
    for (BitCube bits : solids) {
      if (bits.get(i, j, k)) {
        return false;
      }
    }
    return true;
  }

  private int size(int axis) {
    return axis == 0 ? bits.sizeX() : axis == 1 ? bits.sizeY() : bits.sizeZ();
  }

  /** Returns the number of the line along an axis through a voxel. */
  private int line(int axis, int i, int j, int k) {
    return switch (axis) {
      case 0 -> j + bits.sizeY() * k;
      case 1 -> k + bits.sizeZ() * i;
      default -> i + bits.sizeX() * j;
    };
  }

  private static int along(int axis, int i, int j, int k) {
    return axis == 0 ? i : axis == 1 ? j : k;
  }

  private void include(int i, int j, int k) {
    for (int axis = 0; axis < 3; axis++) {
      int line = line(axis, i, j, k);
      int at = along(axis, i, j, k);
      first[axis][line] = Math.min(first[axis][line], at);
      last[axis][line] = Math.max(last[axis][line], at);
    }
  }

  /** Returns the number of directions in which a voxel sees the segment. */
  private int directions(int i, int j, int k) {
    int seen = 0;
    for (int axis = 0; axis < 3; axis++) {
      int line = line(axis, i, j, k);
      int at = along(axis, i, j, k);
      seen += first[axis][line] < at ? 1 : 0;
      seen += last[axis][line] > at ? 1 : 0;
    }
    return seen;
  }
}
