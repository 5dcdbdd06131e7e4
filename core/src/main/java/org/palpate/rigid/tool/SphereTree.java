package org.palpate.rigid.tool;

import java.util.Arrays;

/**
 * A binary tree of bounding spheres over the points of a tool. Nodes are numbered in preorder. Each
 * node knows the node that follows if its subtree is culled, so that a traversal needs no stack.
 * The points of a leaf are contiguous.
 *
 * <p>Nodes are split at the median of their longest side. Reference: Quinlan, Efficient distance
 * computation between non-convex objects, 1994.
 *
 * <p>Frame: the tool frame, mm. Immutable; any thread.
 */
public final class SphereTree {
  /** The largest number of points in a leaf. */
  static final int LEAF_POINTS = 24;

  /** The factor by which radii grow, so that spheres contain their points despite rounding. */
  private static final double ROUNDED_UP = 1 + 1e-12;

  private final double[] x;
  private final double[] y;
  private final double[] z;
  private final double[] halfX;
  private final double[] halfY;
  private final double[] halfZ;
  private final double[] radius;
  private final int[] skip;
  private final int[] first;
  private final int[] end;
  private final int[] leaf;
  private final int[] leafOfPoint;
  private final int nodes;
  private final int leaves;

  /** Builds the tree over points, and reorders them so that those of a leaf are contiguous. */
  SphereTree(double[] px, double[] py, double[] pz) {
    nodes = nodesOver(px.length);
    x = new double[nodes];
    y = new double[nodes];
    z = new double[nodes];
    halfX = new double[nodes];
    halfY = new double[nodes];
    halfZ = new double[nodes];
    radius = new double[nodes];
    skip = new int[nodes];
    first = new int[nodes];
    end = new int[nodes];
    leaf = new int[nodes];
    leafOfPoint = new int[px.length];
    Builder builder = new Builder(px, py, pz);
    builder.build(0, px.length);
    leaves = builder.leavesBuilt;
  }

  /** Returns the number of nodes of a tree over some points. */
  private static int nodesOver(int points) {
    int half = points / 2;
    return points <= LEAF_POINTS ? 1 : 1 + nodesOver(half) + nodesOver(points - half);
  }

  /** {@return the number of nodes; the root is node 0} */
  public int nodes() {
    return nodes;
  }

  /** {@return the number of leaves} */
  public int leaves() {
    return leaves;
  }

  /**
   * {@return the x coordinate of the centre of a node's sphere, mm}
   *
   * @param node the number of the node, from 0 to {@link #nodes} - 1
   */
  public double x(int node) {
    return x[node];
  }

  /**
   * {@return the y coordinate of the centre of a node's sphere, mm}
   *
   * @param node the number of the node, from 0 to {@link #nodes} - 1
   */
  public double y(int node) {
    return y[node];
  }

  /**
   * {@return the z coordinate of the centre of a node's sphere, mm}
   *
   * @param node the number of the node, from 0 to {@link #nodes} - 1
   */
  public double z(int node) {
    return z[node];
  }

  /**
   * {@return the radius of a node's sphere, mm}
   *
   * @param node the number of the node, from 0 to {@link #nodes} - 1
   */
  public double radius(int node) {
    return radius[node];
  }

  /**
   * {@return half the extent along x of the box around a node's points, mm; see {@link #x}}
   *
   * @param node the number of the node, from 0 to {@link #nodes} - 1
   */
  public double halfX(int node) {
    return halfX[node];
  }

  /**
   * {@return half the extent along y of that box, mm}
   *
   * @param node the number of the node, from 0 to {@link #nodes} - 1
   */
  public double halfY(int node) {
    return halfY[node];
  }

  /**
   * {@return half the extent along z of that box, mm}
   *
   * @param node the number of the node, from 0 to {@link #nodes} - 1
   */
  public double halfZ(int node) {
    return halfZ[node];
  }

  /**
   * {@return the node that follows the subtree of a node; {@link #nodes} after the last one}
   *
   * @param node the number of the node, from 0 to {@link #nodes} - 1
   */
  public int skip(int node) {
    return skip[node];
  }

  /**
   * {@return whether the node is a leaf}
   *
   * @param node the number of the node, from 0 to {@link #nodes} - 1
   */
  public boolean isLeaf(int node) {
    return first[node] >= 0;
  }

  /**
   * {@return the index of the first point of a leaf; negative for an inner node}
   *
   * @param node the number of the node, from 0 to {@link #nodes} - 1
   */
  public int first(int node) {
    return first[node];
  }

  /**
   * {@return the index after the last point of a leaf}
   *
   * @param node the number of a leaf's node
   */
  public int end(int node) {
    return end[node];
  }

  /**
   * {@return the number of a leaf in preorder; negative for an inner node}
   *
   * @param node the number of the node, from 0 to {@link #nodes} - 1
   */
  public int leaf(int node) {
    return leaf[node];
  }

  /**
   * {@return the number of the leaf that holds a point}
   *
   * @param point the index of the point
   */
  public int leafOfPoint(int point) {
    return leafOfPoint[point];
  }

  /** Fills the arrays of the tree. */
  private final class Builder {
    private final double[] px;
    private final double[] py;
    private final double[] pz;
    private final long[] keys;
    private final double[] copy;
    private int nodesBuilt;
    private int leavesBuilt;

    Builder(double[] px, double[] py, double[] pz) {
      this.px = px;
      this.py = py;
      this.pz = pz;
      keys = new long[px.length];
      copy = new double[px.length];
    }

    void build(int from, int to) {
      int node = nodesBuilt++;
      double sizeX = bound(px, from, to, x, node);
      double sizeY = bound(py, from, to, y, node);
      double sizeZ = bound(pz, from, to, z, node);
      halfX[node] = 0.5 * sizeX * ROUNDED_UP;
      halfY[node] = 0.5 * sizeY * ROUNDED_UP;
      halfZ[node] = 0.5 * sizeZ * ROUNDED_UP;
      radius[node] = farthest(node, from, to);
      if (to - from <= LEAF_POINTS) {
        first[node] = from;
        end[node] = to;
        leaf[node] = leavesBuilt++;
        Arrays.fill(leafOfPoint, from, to, leaf[node]);
      } else {
        first[node] = -1;
        leaf[node] = -1;
        sort(sizeX >= sizeY && sizeX >= sizeZ ? px : sizeY >= sizeZ ? py : pz, from, to);
        int middle = (from + to) >>> 1;
        build(from, middle);
        build(middle, to);
      }
      skip[node] = nodesBuilt;
    }

    /** Writes the middle of the points along an axis and returns their extent. */
    private static double bound(double[] p, int from, int to, double[] middle, int node) {
      double low = Double.POSITIVE_INFINITY;
      double high = Double.NEGATIVE_INFINITY;
      for (int n = from; n < to; n++) {
        low = Math.min(low, p[n]);
        high = Math.max(high, p[n]);
      }
      middle[node] = low + (high - low) / 2;
      return high - low;
    }

    /** Returns the distance of the farthest point of a range from the centre of a node. */
    private double farthest(int node, int from, int to) {
      double square = 0;
      for (int n = from; n < to; n++) {
        double dx = px[n] - x[node];
        double dy = py[n] - y[node];
        double dz = pz[n] - z[node];
        square = Math.max(square, dx * dx + dy * dy + dz * dz);
      }
      return Math.sqrt(square) * ROUNDED_UP;
    }

    /** Sorts the points of a range along an axis; equal coordinates keep their order. */
    private void sort(double[] along, int from, int to) {
      for (int n = from; n < to; n++) {
        keys[n] = (long) sortable((float) along[n]) << 32 | n;
      }
      Arrays.sort(keys, from, to);
      permute(px, from, to);
      permute(py, from, to);
      permute(pz, from, to);
    }

    private static int sortable(float value) {
      int bits = Float.floatToIntBits(value);
      return bits >= 0 ? bits : bits ^ 0x7fffffff;
    }

    private void permute(double[] p, int from, int to) {
      for (int n = from; n < to; n++) {
        copy[n] = p[(int) keys[n]];
      }
      System.arraycopy(copy, from, p, from, to - from);
    }
  }
}
