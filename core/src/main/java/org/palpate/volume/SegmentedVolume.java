package org.palpate.volume;

import java.util.List;

/**
 * A grid and the segments that share it.
 *
 * @param grid the sizes, the spacing and the position in the world
 * @param segments the segments, each with bits of the size of the grid
 */
public record SegmentedVolume(VoxelGrid grid, List<Segment> segments) {
  /** Copies the list of segments. */
  public SegmentedVolume {
    segments = List.copyOf(segments);
  }
}
