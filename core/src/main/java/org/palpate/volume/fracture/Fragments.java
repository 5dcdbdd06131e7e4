package org.palpate.volume.fracture;

import java.util.ArrayList;
import java.util.List;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/**
 * The fragments of a bone at rest. In a synthetic fracture they rest where they belong in the whole
 * bone; from a scan, where the scan shows them. The first is the largest and the reference of all
 * others.
 *
 * @param grid the grid of all fragments
 * @param bits the voxels of each fragment, which no two share, the largest first
 * @param lostVoxels the number of voxels of the bone that are in no fragment
 */
public record Fragments(VoxelGrid grid, List<BitCube> bits, long lostVoxels) {
  private static final int[] COLOURS = {
    0xE8DCC0, 0x7FB2D9, 0xE0A45C, 0x8CC28A, 0xD98A94, 0xB59BD6, 0xD6CB6A, 0x7FC9C3
  };

  /** Copies the list. */
  public Fragments {
    bits = List.copyOf(bits);
  }

  /** {@return a segment for each fragment, named {@code fragment1} and so on} */
  public SegmentedVolume segments() {
    List<Segment> segments = new ArrayList<>();
    for (BitCube cube : bits) {
      int n = segments.size();
      segments.add(new Segment("fragment" + (n + 1), cube, COLOURS[n % COLOURS.length]));
    }
    return new SegmentedVolume(grid, segments);
  }
}
