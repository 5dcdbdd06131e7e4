package org.palpate.fracture.fit;

import java.util.Arrays;
import org.palpate.geometry.Vec3;

/**
 * All pairs of rim points of a surface that are neither near nor far from each other, ordered by
 * what a motion does not change: their distance, and the angles of their frames with the line
 * through them and with each other. A pair of another surface fits to one of these if all this is
 * alike with the outward directions reversed. One thread an instance.
 *
 * <p>Reference: Drost et al. 2010, "Model globally, match locally".
 */
final class RimPairs {
  private static final double LEAST_EDGES = 8;
  private static final double MOST_EDGES = 30;
  private static final int FEATURES = 6;

  /** The number of bins of the distance, of the angles of tangents, and of outward directions. */
  private static final int[] BINS = {22, 9, 9, 9, 3, 3};

  private static final int ALL_BINS = Arrays.stream(BINS).reduce(1, (n, m) -> n * m);

  private final double edgeMm;

  /** The indices of both points of each pair, ordered by bin. */
  private final int[] first;

  private final int[] second;

  /** The index of the first pair of each bin. */
  private final int[] begin = new int[ALL_BINS + 1];

  /** The features of a pair, bins. */
  private final double[] features = new double[FEATURES];

  private final Vec3 line = new Vec3();

  /** Receives pairs that are found. */
  interface Sink {
    /**
     * Receives a pair.
     *
     * @param one the index of its first rim point
     * @param other the index of its second rim point
     * @return whether it wants another one
     */
    boolean take(int one, int other);
  }

  /**
   * Orders all pairs of some rim points.
   *
   * @param size the number of points, the first ones
   * @param edgeMm the edge of a voxel, mm
   */
  RimPairs(RimPoints rim, int size, double edgeMm) {
    this.edgeMm = edgeMm;
    int[] bins = new int[size * size];
    for (int n = 0; n < bins.length; n++) {
      boolean isPair = describe(rim.frame(n / size), rim.frame(n % size), 1);
      bins[n] = isPair ? bin(0) : -1;
      if (isPair) {
        begin[bins[n] + 1]++;
      }
    }
    Arrays.parallelPrefix(begin, Integer::sum);
    int[] next = begin.clone();
    first = new int[begin[ALL_BINS]];
    second = new int[first.length];
    for (int n = 0; n < bins.length; n++) {
      if (bins[n] >= 0) {
        int at = next[bins[n]]++;
        first[at] = n / size;
        second[at] = n % size;
      }
    }
  }

  /**
   * Finds the pairs that may fit to a pair of another surface.
   *
   * @param sink receives the pairs that are found; none if the two points are too near or far
   */
  void findFitting(RimPoints.Frame one, RimPoints.Frame two, Sink sink) {
    if (!describe(one, two, -1)) {
      return;
    }
    for (int corner = 0; corner < 1 << FEATURES; corner++) {
      int bin = bin(corner);
      int end = bin < 0 ? 0 : begin[bin + 1];
      for (int n = bin < 0 ? 0 : begin[bin]; n < end; n++) {
        if (!sink.take(first[n], second[n])) {
          return;
        }
      }
    }
  }

  /** Computes the features of a pair. Returns whether its points are neither near nor far. */
  private boolean describe(RimPoints.Frame one, RimPoints.Frame two, int sign) {
    two.point().sub(one.point(), line);
    double edges = line.length() / edgeMm;
    if (edges < LEAST_EDGES || edges >= MOST_EDGES) {
      return false;
    }
    line.mul(1 / line.length(), line);
    features[0] = BINS[0] * (edges - LEAST_EDGES) / (MOST_EDGES - LEAST_EDGES);
    features[1] = BINS[1] * angle(one.tangent().dot(line));
    features[2] = BINS[2] * angle(two.tangent().dot(line));
    features[3] = BINS[3] * angle(one.tangent().dot(two.tangent()));
    features[4] = BINS[4] * (1 + sign * one.outward().dot(line)) / 2;
    features[5] = BINS[5] * (1 + sign * two.outward().dot(line)) / 2;
    return true;
  }

  /** Returns the angle between two lines, as a part of a right angle. */
  private static double angle(double cosine) {
    return StrictMath.acos(Math.min(1, Math.abs(cosine))) / (Math.PI / 2);
  }

  /**
   * Returns one of the bins whose middles are next to the features; -1 if there is none.
   *
   * @param corner a bit for each feature: 0 for the bin that it lies in, 1 for the nearest other
   */
  private int bin(int corner) {
    int bin = 0;
    for (int n = 0; n < FEATURES; n++) {
      int own = (int) Math.min(BINS[n] - 1.0, Math.max(0, features[n]));
      int other = features[n] - own < 0.5 ? own - 1 : own + 1;
      int part = (corner >> n & 1) == 0 ? own : other;
      if (part < 0 || part >= BINS[n]) {
        return -1;
      }
      bin = BINS[n] * bin + part;
    }
    return bin;
  }
}
