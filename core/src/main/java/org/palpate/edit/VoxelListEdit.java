package org.palpate.edit;

import java.util.List;
import org.palpate.geometry.IntBox;

/**
 * Makes listed voxels of any segments solid or empty, in their order and in one frame. Only replays
 * use it, because a long list may exceed the time of a live frame.
 */
final class VoxelListEdit extends Edit {
  /** A box around several voxels is reported if it holds no more than this. */
  private static final long MOST_IN_BOX = 512;

  private final List<VoxelChange> changes;
  private final IntBox box = new IntBox();
  private final IntBox grown = new IntBox();

  /**
   * Makes an edit.
   *
   * @param changes at least one; their frames do not matter
   */
  VoxelListEdit(List<VoxelChange> changes) {
    super(changes.get(0).segment());
    this.changes = List.copyOf(changes);
  }

  @Override
  void prepare(SegmentGrids grids) {
    for (VoxelChange change : changes) {
      grids.requireVoxel(change.segment(), change.i(), change.j(), change.k());
    }
  }

  @Override
  int apply(VoxelWriter out, int maxVoxels) {
    int segment = segment();
    box.clear();
    for (VoxelChange change : changes) {
      grown.set(box).include(change.i(), change.j(), change.k());
      if (change.segment() != segment || cells(grown) > MOST_IN_BOX) {
        out.applied(segment, box);
        segment = change.segment();
        box.clear();
      }
      out.write(change.segment(), change.i(), change.j(), change.k(), change.solid());
      box.include(change.i(), change.j(), change.k());
    }
    out.applied(segment, box);
    finish();
    return changes.size();
  }

  private static long cells(IntBox box) {
    return (box.highX - box.lowX + 1L) * (box.highY - box.lowY + 1L) * (box.highZ - box.lowZ + 1L);
  }
}
