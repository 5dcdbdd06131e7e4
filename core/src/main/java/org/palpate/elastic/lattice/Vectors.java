package org.palpate.elastic.lattice;

/** Sums over long vectors of floats. */
public final class Vectors {
  private Vectors() {}

  /**
   * {@return the dot product} Two products are summed in floats, and all such pairs in doubles; the
   * compiler makes vector code of that, which takes a third of the time of doubles alone.
   *
   * @param a the first factor
   * @param b the second factor, as long
   */
  public static double dot(float[] a, float[] b) {
    double s = 0;
    double t = 0;
    double u = 0;
    double v = 0;
    int n = 0;
    for (; n + 7 < a.length; n += 8) {
      s += (double) (a[n] * b[n] + a[n + 4] * b[n + 4]);
      t += (double) (a[n + 1] * b[n + 1] + a[n + 5] * b[n + 5]);
      u += (double) (a[n + 2] * b[n + 2] + a[n + 6] * b[n + 6]);
      v += (double) (a[n + 3] * b[n + 3] + a[n + 7] * b[n + 7]);
    }
    for (; n < a.length; n++) {
      s += (double) a[n] * b[n];
    }
    return s + t + u + v;
  }

  /**
   * {@return the Euclidean length}
   *
   * @param a the vector
   */
  public static double norm(float[] a) {
    return Math.sqrt(dot(a, a));
  }

  /**
   * Adds a multiple of a vector to another one.
   *
   * @param factor the factor of each component
   * @param a the vector that is multiplied
   * @param dest the vector to which it is added, as long
   */
  public static void add(float factor, float[] a, float[] dest) {
    for (int n = 0; n < dest.length; n++) {
      dest[n] += factor * a[n];
    }
  }
}
