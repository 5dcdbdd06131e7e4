package org.palpate.proxy.smooth.field;

import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;

/**
 * Measures the contrast of edges: the mean difference between neighbouring grey values on different
 * sides of a threshold.
 */
final class EdgeContrast {
  private final ScalarVolume volume;
  private final double threshold;
  private double sum;
  private long pairs;

  EdgeContrast(ScalarVolume volume, double threshold) {
    this.volume = volume;
    this.threshold = threshold;
  }

  /** Returns the mean over all such pairs along the axes, or 0 if there is none. */
  double meanDifference() {
    VoxelGrid grid = volume.grid();
    for (int k = 0; k < grid.sizeZ(); k++) {
      for (int j = 0; j < grid.sizeY(); j++) {
        for (int i = 0; i < grid.sizeX(); i++) {
          double value = volume.value(i, j, k);
          if (i > 0) {
            addPair(value, volume.value(i - 1, j, k));
          }
          if (j > 0) {
            addPair(value, volume.value(i, j - 1, k));
          }
          if (k > 0) {
            addPair(value, volume.value(i, j, k - 1));
          }
        }
      }
    }
    return pairs == 0 ? 0 : sum / pairs;
  }

  /** Adds a pair if the threshold lies between its values. */
  private void addPair(double value, double neighbour) {
    if (value >= threshold != neighbour >= threshold && Double.isFinite(value - neighbour)) {
      sum += Math.abs(value - neighbour);
      pairs++;
    }
  }
}
