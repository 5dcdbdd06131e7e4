package org.palpate.rigid;

import java.util.Arrays;

/**
 * Bounding spheres over a tool's points, in a binary tree in preorder. Each node stores the node
 * that follows if it is ruled out, so that a traversal needs no stack. Reorders the points so that
 * those of a leaf are contiguous. Immutable once built.
 *
 * <p>Splits at the median of the longest side. Reference: Quinlan, Efficient distance computation
 * between non-convex objects, 1994.
 */
final class SphereTree {
  /** The largest number of points in a leaf. */
  static final int LEAF_POINTS = 24;

  /** The factor by which radii grow, so that spheres cover their points despite rounding. */
  private static final double ROUNDED_UP = 1 + 1e-12;

  /** Centre and radius of each node, mm in the tool frame. */
  final double[] x;

  final double[] y;
  final double[] z;
  final double[] radius;

  /** The node that follows if this one is ruled out; for a leaf, the next node. */
  final int[] skip;

  /**
   * The index of a leaf's first point; negative for inner nodes. {@link #end} is the index after
   * its last point.
   */
  final int[] first;

  final int[] end;

  /** The number of a leaf in traversal order; negative for inner nodes. */
  final int[] leaf;

  /** The number of the leaf that holds a point. */
  final int[] leafOfPoint;

  final int nodes;
  final int leaves;

  /** Builds the tree over points and reorders them. */
  SphereTree(double[] px, double[] py, double[] pz) {
    Builder builder = new Builder(px, py, pz);
    builder.build(0, px.length);
    nodes = builder.nodes;
    leaves = builder.leaves;
    x = Arrays.copyOf(builder.x, nodes);
    y = Arrays.copyOf(builder.y, nodes);
    z = Arrays.copyOf(builder.z, nodes);
    radius = Arrays.copyOf(builder.radius, nodes);
    skip = Arrays.copyOf(builder.skip, nodes);
    first = Arrays.copyOf(builder.first, nodes);
    end = Arrays.copyOf(builder.end, nodes);
    leaf = Arrays.copyOf(builder.leaf, nodes);
    leafOfPoint = new int[px.length];
    for (int node = 0; node < nodes; node++) {
      if (first[node] >= 0) {
        Arrays.fill(leafOfPoint, first[node], end[node], leaf[node]);
      }
    }
  }

  /** The arrays of the tree while it is built. */
  private static final class Builder {
    private final double[] px;
    private final double[] py;
    private final double[] pz;
    private final long[] keys;
    private final double[] copy;
    private final double[] x;
    private final double[] y;
    private final double[] z;
    private final double[] radius;
    private final int[] skip;
    private final int[] first;
    private final int[] end;
    private final int[] leaf;
    private int nodes;
    private int leaves;

    Builder(double[] px, double[] py, double[] pz) {
      this.px = px;
      this.py = py;
      this.pz = pz;
      keys = new long[px.length];
      copy = new double[px.length];
      int most = 2 * Math.max(1, Integer.highestOneBit(px.length) / (LEAF_POINTS / 4)) + 16;
      x = new double[most];
      y = new double[most];
      z = new double[most];
      radius = new double[most];
      skip = new int[most];
      first = new int[most];
      end = new int[most];
      leaf = new int[most];
    }

    void build(int from, int to) {
      int node = nodes++;
      double sizeX = bound(px, from, to, x, node);
      double sizeY = bound(py, from, to, y, node);
      double sizeZ = bound(pz, from, to, z, node);
      radius[node] = radius(node, from, to);
      if (to - from <= LEAF_POINTS) {
        first[node] = from;
        end[node] = to;
        leaf[node] = leaves++;
      } else {
        first[node] = -1;
        leaf[node] = -1;
        sort(sizeX >= sizeY && sizeX >= sizeZ ? px : sizeY >= sizeZ ? py : pz, from, to);
        int middle = (from + to) >>> 1;
        build(from, middle);
        build(middle, to);
      }
      skip[node] = nodes;
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

    private double radius(int node, int from, int to) {
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
