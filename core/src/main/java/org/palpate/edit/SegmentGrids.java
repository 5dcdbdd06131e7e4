package org.palpate.edit;

import java.util.ArrayList;
import java.util.List;
import org.palpate.geometry.GridMetric;
import org.palpate.volume.VoxelGrid;

/** The grid of each segment of a scene, which an edit must fit. Immutable; any thread. */
final class SegmentGrids {
  private final List<VoxelGrid> grids;
  private final List<GridMetric> metrics;

  SegmentGrids(List<VoxelGrid> grids) {
    this.grids = List.copyOf(grids);
    metrics = new ArrayList<>();
    for (VoxelGrid grid : grids) {
      metrics.add(grid.metric());
    }
  }

  /** Returns the number of segments. */
  int count() {
    return grids.size();
  }

  /**
   * Returns the grid of a segment.
   *
   * @throws IllegalArgumentException if the scene has no such segment
   */
  VoxelGrid grid(int segment) {
    if (segment < 0 || segment >= count()) {
      throw new IllegalArgumentException(
          "no such segment: segment=" + segment + " segments=" + count());
    }
    return grids.get(segment);
  }

  /** Returns the metric of the grid of a segment that the scene has. */
  GridMetric metric(int segment) {
    return metrics.get(segment);
  }

  /**
   * Checks that a voxel lies in the grid of its segment.
   *
   * @throws IllegalArgumentException if it does not, or the scene has no such segment
   */
  void requireVoxel(int segment, int i, int j, int k) {
    if (!grid(segment).contains(i, j, k)) {
      throw new IllegalArgumentException(
          "voxel lies outside the grid: voxel=" + i + "," + j + "," + k);
    }
  }
}
