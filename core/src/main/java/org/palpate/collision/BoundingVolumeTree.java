package org.palpate.collision;

import java.util.Arrays;
import java.util.Comparator;
import org.palpate.geometry.IntBox;

/**
 * A bounding-volume tree over integer boxes. Finds the boxes that a query box meets, in a time that
 * grows with the logarithm of their number.
 *
 * <p>Each node splits its boxes in two halves along the longest side of the bounds of their
 * centres. An empty box is never found. The tree is built once and stays as it is; a query
 * allocates nothing. Keeps scratch: one thread.
 */
final class BoundingVolumeTree {
  private static final int BOXES_PER_LEAF = 4;
  private static final int MAX_DEPTH = 64;

  private final IntBox[] boxes;

  /** The indices of the boxes, in an order in which the boxes of each node are contiguous. */
  private final Integer[] order;

  /** The bounds of the nodes of a complete tree: the children of n are 2 n + 1 and 2 n + 2. */
  private final IntBox[] nodes;

  private final int[] stack = new int[3 * MAX_DEPTH];

  /** Builds the tree; the caller must not change the boxes afterwards. */
  BoundingVolumeTree(IntBox[] boxes) {
    this.boxes = boxes;
    order = new Integer[boxes.length];
    Arrays.setAll(order, n -> n);
    int leaves = Integer.highestOneBit(Math.max(1, boxes.length / BOXES_PER_LEAF)) * 2;
    nodes = new IntBox[2 * leaves - 1];
    build(0, 0, boxes.length);
  }

  private void build(int node, int from, int to) {
    if (node >= nodes.length) {
      return;
    }
    nodes[node] = new IntBox();
    double[] low = {Double.MAX_VALUE, Double.MAX_VALUE, Double.MAX_VALUE};
    double[] high = {-Double.MAX_VALUE, -Double.MAX_VALUE, -Double.MAX_VALUE};
    for (int n = from; n < to; n++) {
      IntBox box = boxes[order[n]];
      nodes[node].include(box);
      for (int axis = 0; axis < 3; axis++) {
        low[axis] = Math.min(low[axis], doubleCentre(box, axis));
        high[axis] = Math.max(high[axis], doubleCentre(box, axis));
      }
    }
    int axis = longest(low, high);
    Arrays.sort(order, from, to, Comparator.comparingDouble(n -> doubleCentre(boxes[n], axis)));
    int half = (from + to) >>> 1;
    build(2 * node + 1, from, half);
    build(2 * node + 2, half, to);
  }

  private static int longest(double[] low, double[] high) {
    int axis = high[1] - low[1] > high[0] - low[0] ? 1 : 0;
    return high[2] - low[2] > high[axis] - low[axis] ? 2 : axis;
  }

  /** Returns twice the centre of a box along an axis; 0 for an empty box. */
  private static double doubleCentre(IntBox box, int axis) {
    if (box.isEmpty()) {
      return 0;
    }
    return switch (axis) {
      case 0 -> (double) box.lowX + box.highX;
      case 1 -> (double) box.lowY + box.highY;
      default -> (double) box.lowZ + box.highZ;
    };
  }

  /**
   * Finds the boxes that have a cell in common with {@code query}.
   *
   * @param dest receives the indices of the boxes, in no particular order
   * @return the number of boxes found
   */
  int find(IntBox query, int[] dest) {
    int found = 0;
    int top = push(0, 0, 0, boxes.length);
    while (top > 0) {
      int to = stack[--top];
      int from = stack[--top];
      int node = stack[--top];
      if (!nodes[node].meets(query)) {
        continue;
      }
      if (2 * node + 1 >= nodes.length) {
        found = findInLeaf(query, from, to, dest, found);
      } else {
        int half = (from + to) >>> 1;
        top = push(top, 2 * node + 1, from, half);
        top = push(top, 2 * node + 2, half, to);
      }
    }
    return found;
  }

  private int push(int top, int node, int from, int to) {
    stack[top] = node;
    stack[top + 1] = from;
    stack[top + 2] = to;
    return top + 3;
  }

  private int findInLeaf(IntBox query, int from, int to, int[] dest, int foundBefore) {
    int found = foundBefore;
    for (int n = from; n < to; n++) {
      if (boxes[order[n]].meets(query)) {
        dest[found++] = order[n];
      }
    }
    return found;
  }
}
