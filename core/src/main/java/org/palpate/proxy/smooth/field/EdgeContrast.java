package org.palpate.proxy.smooth.field;

import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;

/** How far the values of neighbours differ that a threshold parts. */
final class EdgeContrast {
  private final ScalarVolume volume;
  private final double threshold;
  private double sum;
  private long pairs;

  EdgeContrast(ScalarVolume volume, double threshold) {
    this.volume = volume;
    this.threshold = threshold;
  }

  /** The mean over all pairs along the axes; 0 where there is none. */
  double meanDifference() {
    VoxelGrid grid = volume.grid();
    for (int k = 0; k < grid.sizeZ(); k++) {
      for (int j = 0; j < grid.sizeY(); j++) {
        for (int i = 0; i < grid.sizeX(); i++) {
          double value = volume.value(i, j, k);
          if (i > 0) {
            add(value, volume.value(i - 1, j, k));
          }
          if (j > 0) {
            add(value, volume.value(i, j - 1, k));
          }
          if (k > 0) {
            add(value, volume.value(i, j, k - 1));
          }
        }
      }
    }
    return pairs == 0 ? 0 : sum / pairs;
  }

  private void add(double value, double neighbour) {
    if (value >= threshold != neighbour >= threshold && Double.isFinite(value - neighbour)) {
      sum += Math.abs(value - neighbour);
      pairs++;
    }
  }
}
