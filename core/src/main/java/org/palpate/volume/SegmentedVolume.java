package org.palpate.volume;

import java.util.List;

/**
 * A grid and the segments that share it.
 *
 * @param grid sizes, spacing, place in the world
 * @param segments each with bits of the grid's size
 */
public record SegmentedVolume(VoxelGrid grid, List<Segment> segments) {
  public SegmentedVolume {
    segments = List.copyOf(segments);
  }
}
