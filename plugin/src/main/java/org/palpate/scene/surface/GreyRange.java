package org.palpate.scene.surface;

import org.palpate.volume.ScalarVolume;
import org.palpate.volume.ScalarVolume.Storage;
import org.palpate.volume.VoxelGrid;

/**
 * The grey values that a segment was made of: where between its voxels the surface runs.
 *
 * @param volume over the segment's grid; read by several threads, not changed
 * @param low the least value of a voxel of the segment
 * @param high the greatest, infinite where there is none
 */
public record GreyRange(ScalarVolume volume, double low, double high) {
  /** Whole numbers pass from one to the next half way. */
  private static final double HALF_STEP = 0.5;

  /** Where between solid and empty voxels the surface runs. */
  EdgeCrossings crossings() {
    double margin = volume.storage() == Storage.FLOAT32 ? 0 : HALF_STEP;
    return new GreyEdgeCrossings(this::value, (float) (low - margin), (float) (high + margin));
  }

  private float value(int i, int j, int k) {
    VoxelGrid grid = volume.grid();
    return grid.contains(i, j, k) ? (float) volume.value(i, j, k) : Float.NaN;
  }
}
