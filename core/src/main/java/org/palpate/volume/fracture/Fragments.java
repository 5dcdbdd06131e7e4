package org.palpate.volume.fracture;

import java.util.ArrayList;
import java.util.List;
import org.palpate.geometry.Pose;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/**
 * The fragments of a bone where they belong: the truth of a synthetic fracture. The first is the
 * largest and the reference of all others.
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

  /** Returns a segment for each fragment, named {@code fragment1} and so on. */
  public SegmentedVolume segments() {
    return new SegmentedVolume(grid, segments(bits));
  }

  /**
   * Returns the fragments at poses as segments of a grid; see {@link PosedBits#resample}.
   *
   * @param poses the pose of each fragment, from rest to present, world mm
   */
  public SegmentedVolume segmentsAt(List<Pose> poses, VoxelGrid target) {
    List<PosedBits> posed = new ArrayList<>();
    for (int n = 0; n < bits.size(); n++) {
      posed.add(new PosedBits(bits.get(n), grid, poses.get(n)));
    }
    return new SegmentedVolume(target, segments(PosedBits.resample(posed, target)));
  }

  private static List<Segment> segments(List<BitCube> cubes) {
    List<Segment> segments = new ArrayList<>();
    for (BitCube cube : cubes) {
      int n = segments.size();
      segments.add(new Segment("fragment" + (n + 1), cube, COLOURS[n % COLOURS.length]));
    }
    return segments;
  }
}
