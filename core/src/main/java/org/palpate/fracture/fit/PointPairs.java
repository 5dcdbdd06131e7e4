package org.palpate.fracture.fit;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.palpate.geometry.Vec3;

/**
 * Random pairs of surface points, ordered by their distance and by the angles between their normals
 * and the line through them. A pair of another surface fits to one of these if it has the same
 * distance and angles with its normals reversed. One thread an instance.
 *
 * <p>Reference: Drost et al. 2010, "Model globally, match locally".
 */
final class PointPairs {
  private static final double LEAST_EDGES = 4;
  private static final double MOST_EDGES = 12;

  /** The number of pairs that are drawn for each point. */
  private static final int PARTNERS = 40;

  /** The number of draws that a pair may take. */
  private static final int DRAWS = 8;

  /** The number of bins of each feature. */
  private static final int BINS = 12;

  private static final int FEATURES = 4;

  /** Half the edge of the box of features in which a fitting pair is sought, bins. */
  private static final double REACH_BINS = 0.5;

  private final double edgeMm;

  /** The first point of each pair, ordered by bin. */
  private final int[] first;

  /** The second point of each pair. */
  private final int[] second;

  /** The index of the first pair of each bin. */
  private final int[] begin = new int[(int) Math.pow(BINS, FEATURES) + 1];

  /** The features of a pair, bins. */
  private final double[] features = new double[FEATURES];

  private final Vec3 across = new Vec3();

  /** Receives pairs that are found. */
  interface Sink {
    /**
     * Receives a pair.
     *
     * @param one the index of its first point
     * @param other the index of its second point
     */
    void take(int one, int other);
  }

  /**
   * Draws pairs.
   *
   * @param points the indices of the points to draw from
   * @param edgeMm the edge of a voxel, mm
   */
  PointPairs(FragmentSurface surface, int[] points, double edgeMm, SplittableRandom random) {
    this.edgeMm = edgeMm;
    int[] ones = new int[PARTNERS * points.length];
    int[] others = new int[ones.length];
    int[] bins = new int[ones.length];
    int count = 0;
    for (int n = 0; n < DRAWS * ones.length && count < ones.length; n++) {
      int one = points[random.nextInt(points.length)];
      int other = points[random.nextInt(points.length)];
      if (isPair(surface, one, other, edgeMm)) {
        describe(surface, one, other, 1);
        ones[count] = one;
        others[count] = other;
        bins[count++] = bin(0, 0);
      }
    }
    for (int n = 0; n < count; n++) {
      begin[bins[n] + 1]++;
    }
    Arrays.parallelPrefix(begin, Integer::sum);
    int[] next = begin.clone();
    first = new int[count];
    second = new int[count];
    for (int n = 0; n < count; n++) {
      int at = next[bins[n]]++;
      first[at] = ones[n];
      second[at] = others[n];
    }
  }

  /**
   * Whether two points are as far apart as those of a pair.
   *
   * @param one the index of a point
   * @param other the index of another
   * @param edgeMm the edge of a voxel, mm
   */
  static boolean isPair(FragmentSurface surface, int one, int other, double edgeMm) {
    Vec3 p = surface.points().get(one);
    Vec3 q = surface.points().get(other);
    double square = square(p.x - q.x) + square(p.y - q.y) + square(p.z - q.z);
    return square >= square(LEAST_EDGES * edgeMm) && square <= square(MOST_EDGES * edgeMm);
  }

  private static double square(double x) {
    return x * x;
  }

  /**
   * Finds the pairs that may fit to a pair of another surface.
   *
   * @param other the other surface
   * @param one the index of a point of that surface
   * @param two the index of the second point of the pair
   * @param sink receives the pairs that are found
   */
  void findFitting(FragmentSurface other, int one, int two, Sink sink) {
    describe(other, one, two, -1);
    for (int corner = 0; corner < 1 << FEATURES; corner++) {
      int bin = bin(corner, REACH_BINS);
      for (int n = bin < 0 ? 0 : begin[bin]; bin >= 0 && n < begin[bin + 1]; n++) {
        sink.take(first[n], second[n]);
      }
    }
  }

  /** Computes the features of a pair; a sign of -1 reverses the normals. */
  private void describe(FragmentSurface of, int one, int two, int sign) {
    of.points().get(two).sub(of.points().get(one), across);
    double length = across.length();
    Vec3 n = of.normals().get(one);
    Vec3 m = of.normals().get(two);
    features[0] = BINS * (length / edgeMm - LEAST_EDGES) / (MOST_EDGES - LEAST_EDGES);
    features[1] = angleBins(sign * n.dot(across) / length);
    features[2] = angleBins(sign * m.dot(across) / length);
    features[3] = angleBins(n.dot(m));
  }

  private static double angleBins(double cosine) {
    return BINS * StrictMath.acos(Math.max(-1, Math.min(1, cosine))) / Math.PI;
  }

  /** Returns the bin in which a corner of a box around the features lies; -1 if in none. */
  private int bin(int corner, double reach) {
    int bin = 0;
    for (int n = 0; n < FEATURES; n++) {
      double shift = (corner >> n & 1) == 0 ? -reach : reach;
      int part = (int) Math.floor(Math.min(features[n], Math.nextDown((double) BINS)) + shift);
      if (part < 0 || part >= BINS) {
        return -1;
      }
      bin = BINS * bin + part;
    }
    return bin;
  }
}
