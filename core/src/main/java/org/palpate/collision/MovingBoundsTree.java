package org.palpate.collision;

import java.util.Arrays;
import org.palpate.geometry.WorldBox;

/**
 * A bounding-volume tree over boxes that move; {@link BoundingVolumeTree} is for boxes that do not.
 * Finds the boxes that a query box meets. Nodes that the query does not meet are left out with all
 * that they contain. The tree is not balanced: in the worst case, the time for a query or a motion
 * grows with the number of boxes.
 *
 * <p>The tree holds each box with some slack around it. A box that moves within its slack leaves
 * the tree as it is. One that leaves it is taken out and inserted where it enlarges the other nodes
 * least, and the nodes above are refitted. What a query finds depends on the boxes alone and not on
 * the slack or on earlier motions.
 *
 * <p>Reference: E. Catto, "Dynamic Bounding Volume Hierarchies", Game Developers Conference 2019.
 * Allocates nothing after its creation. Keeps scratch: one thread.
 */
public final class MovingBoundsTree {
  private static final int NONE = -1;

  private final int capacity;
  private final double slackMm;

  /** The boxes as they were put, by item. */
  private final WorldBox[] boxes;

  /** The bounds of the nodes. The first are the leaves, whose number is that of their item. */
  private final WorldBox[] bounds;

  private final int[] parent;
  private final int[] left;
  private final int[] right;

  /** Inner nodes that are not in the tree, linked by {@link #parent}. */
  private int free;

  private int root = NONE;
  private final int[] stack;
  private final WorldBox joined = new WorldBox();

  /**
   * Creates an empty tree.
   *
   * @param capacity the number of items
   * @param slackMm the distance that a box may move before it is inserted anew
   */
  public MovingBoundsTree(int capacity, double slackMm) {
    this.capacity = capacity;
    this.slackMm = slackMm;
    boxes = new WorldBox[capacity];
    Arrays.setAll(boxes, n -> new WorldBox());
    bounds = new WorldBox[2 * capacity];
    Arrays.setAll(bounds, n -> new WorldBox());
    parent = new int[2 * capacity];
    left = new int[2 * capacity];
    right = new int[2 * capacity];
    stack = new int[capacity + 1];
    Arrays.fill(parent, NONE);
    for (int node = capacity; node < 2 * capacity; node++) {
      parent[node] = node + 1;
    }
    free = capacity;
  }

  /**
   * Sets the box of an item.
   *
   * @param item the number of the item, from 0
   * @param box its box, world mm, not empty; copied
   */
  public void put(int item, WorldBox box) {
    boxes[item].set(box);
    if (!bounds[item].contains(box)) {
      remove(item);
      bounds[item].set(box).grow(slackMm);
      insert(item);
    }
  }

  /**
   * Finds the items whose boxes meet a box.
   *
   * @param query the box, world mm
   * @param found the bit of each item that is found is set: item 64 m + n has bit n of word m
   */
  public void find(WorldBox query, long[] found) {
    int top = 0;
    if (root != NONE) {
      stack[top++] = root;
    }
    while (top > 0) {
      int node = stack[--top];
      if (node < capacity) {
        if (boxes[node].meets(query)) {
          found[node >> 6] |= 1L << node;
        }
      } else if (bounds[node].meets(query)) {
        stack[top++] = left[node];
        stack[top++] = right[node];
      }
    }
  }

  private void insert(int leaf) {
    if (root == NONE) {
      root = leaf;
      parent[leaf] = NONE;
      return;
    }
    int sibling = sibling(bounds[leaf]);
    int node = free;
    free = parent[node];
    int above = parent[sibling];
    parent[node] = above;
    replaceChild(above, sibling, node);
    left[node] = sibling;
    right[node] = leaf;
    parent[sibling] = node;
    parent[leaf] = node;
    refit(node);
  }

  /** Returns the node beside which a box enlarges the tree least, along one path from the root. */
  private int sibling(WorldBox box) {
    int node = root;
    while (node >= capacity) {
      double edges = bounds[node].edgesMm();
      double withBox = joined.setUnion(bounds[node], box).edgesMm();
      double inherited = withBox - edges;
      double toLeft = inherited + growth(left[node], box);
      double toRight = inherited + growth(right[node], box);
      if (withBox < Math.min(toLeft, toRight)) {
        return node;
      }
      node = toLeft <= toRight ? left[node] : right[node];
    }
    return node;
  }

  /** Returns what a box costs in or beside a node: the edges of new nodes and of enlarged ones. */
  private double growth(int node, WorldBox box) {
    double withBox = joined.setUnion(bounds[node], box).edgesMm();
    return node < capacity ? withBox : withBox - bounds[node].edgesMm();
  }

  private void remove(int leaf) {
    int node = parent[leaf];
    if (node == NONE) {
      root = root == leaf ? NONE : root;
      return;
    }
    int sibling = left[node] == leaf ? right[node] : left[node];
    int above = parent[node];
    parent[sibling] = above;
    replaceChild(above, node, sibling);
    parent[node] = free;
    free = node;
    refit(above);
  }

  private void replaceChild(int above, int old, int node) {
    if (above == NONE) {
      root = node;
    } else if (left[above] == old) {
      left[above] = node;
    } else {
      right[above] = node;
    }
  }

  private void refit(int from) {
    for (int node = from; node != NONE; node = parent[node]) {
      bounds[node].setUnion(bounds[left[node]], bounds[right[node]]);
    }
  }
}
