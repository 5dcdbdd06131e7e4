package org.palpate.volume;

import java.util.Collections;
import java.util.List;

/**
 * Segments and their grids. Segments of one file share the volume's grid. Bodies of a scene that
 * come from other files have grids of their own.
 *
 * @param grid the sizes, the spacing and the position in the world
 * @param segments the segments, each with bits of the size of its grid
 * @param grids the grid of each segment, in their order
 */
public record SegmentedVolume(VoxelGrid grid, List<Segment> segments, List<VoxelGrid> grids) {
  /**
   * Copies the lists.
   *
   * @throws IllegalArgumentException if there is not one grid for each segment
   */
  public SegmentedVolume {
    segments = List.copyOf(segments);
    grids = List.copyOf(grids);
    if (grids.size() != segments.size()) {
      throw new IllegalArgumentException(
          "each segment has a grid: grids=" + grids.size() + ", segments=" + segments.size());
    }
  }

  /**
   * Creates a volume whose segments share its grid.
   *
   * @param grid the grid of the volume, which is that of each segment
   * @param segments the segments, in the order in which they are numbered; the list is copied
   */
  public SegmentedVolume(VoxelGrid grid, List<Segment> segments) {
    this(grid, segments, Collections.nCopies(segments.size(), grid));
  }

  /**
   * {@return the grid of a segment}
   *
   * @param segment the number of the segment, from 0
   */
  public VoxelGrid grid(int segment) {
    return grids.get(segment);
  }

  /**
   * {@return the grid of one of these segments}
   *
   * @param segment a segment of this volume, compared as {@link List#indexOf} does
   */
  public VoxelGrid gridOf(Segment segment) {
    return grids.get(segments.indexOf(segment));
  }

  /** {@return whether all segments share the volume's grid} */
  public boolean hasOneGrid() {
    return grids.stream().allMatch(grid::equals);
  }

  /** {@return the shortest voxel edge of all grids, mm} */
  public double shortestEdgeMm() {
    double shortest = grid.metric().shortestEdgeMm();
    for (VoxelGrid own : grids) {
      shortest = Math.min(shortest, own.metric().shortestEdgeMm());
    }
    return shortest;
  }
}
