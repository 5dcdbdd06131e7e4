package org.palpate.scene.surface;

import org.palpate.volume.ScalarVolume;
import org.palpate.volume.ScalarVolume.Storage;
import org.palpate.volume.VoxelGrid;

/**
 * The range of grey values from which a segment was made.
 *
 * @param volume the values over the segment's grid; several threads read them
 * @param low the smallest value of the segment's voxels
 * @param high the largest value of the segment's voxels, infinite if there is no limit
 */
public record GreyRange(ScalarVolume volume, double low, double high) {
  /** Between two whole numbers the threshold lies in the middle. */
  private static final double HALF_STEP = 0.5;

  /** Returns the crossings of the surface. */
  EdgeCrossings crossings() {
    double margin = volume.storage() == Storage.FLOAT32 ? 0 : HALF_STEP;
    return new GreyEdgeCrossings(this::value, (float) (low - margin), (float) (high + margin));
  }

  private float value(int i, int j, int k) {
    VoxelGrid grid = volume.grid();
    return grid.contains(i, j, k) ? (float) volume.value(i, j, k) : Float.NaN;
  }
}
