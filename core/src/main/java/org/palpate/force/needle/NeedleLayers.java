package org.palpate.force.needle;

import java.util.Arrays;

/**
 * The layers that a needle has passed along its track. A layer begins at a depth and ends where the
 * next one begins. If there are too many, the last one goes on. Allocates nothing after it was
 * made.
 */
final class NeedleLayers {
  /** The most layers. */
  static final int MOST = 256;

  private final int[] tissues = new int[MOST];
  private final double[] fromMm = new double[MOST];
  private int count;

  /** Forgets all layers. */
  void clear() {
    count = 0;
  }

  /**
   * Adds a layer.
   *
   * @param tissue its index; -1 for a gap
   * @param depthMm where it begins, not before the last one
   */
  void add(int tissue, double depthMm) {
    if (count < MOST) {
      tissues[count] = tissue;
      fromMm[count++] = depthMm;
    }
  }

  /**
   * Returns the friction of a shaft, N.
   *
   * @param lowMm the depth of its upper end
   * @param highMm the depth of the tip
   */
  double frictionNewton(NeedleTissue[] of, double lowMm, double highMm) {
    double newton = 0;
    for (int n = 0; n < count; n++) {
      double end = n + 1 < count ? fromMm[n + 1] : highMm;
      double length = Math.min(end, highMm) - Math.max(fromMm[n], lowMm);
      if (tissues[n] >= 0 && length > 0) {
        newton += length * of[tissues[n]].shaftNewtonPerMm();
      }
    }
    return newton;
  }

  /** Returns by how much the friction grows for each mm that the tip goes on at a depth, N/mm. */
  double newtonPerMm(NeedleTissue[] of, double depthMm) {
    int layer = count - 1;
    while (layer > 0 && fromMm[layer] > depthMm) {
      layer--;
    }
    return layer >= 0 && tissues[layer] >= 0 ? of[tissues[layer]].shaftNewtonPerMm() : 0;
  }

  @Override
  public String toString() {
    return Arrays.toString(Arrays.copyOf(tissues, count))
        + " from "
        + Arrays.toString(Arrays.copyOf(fromMm, count));
  }
}
