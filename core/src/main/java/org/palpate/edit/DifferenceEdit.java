package org.palpate.edit;

import java.util.Arrays;
import org.palpate.geometry.IntBox;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * Makes those voxels solid or empty in which two cubes differ, for corrections that another thread
 * has computed from a copy of the voxels. It takes as many frames as it needs.
 */
public final class DifferenceEdit extends Edit {
  /** The coordinates of the bricks that differ, three numbers each. */
  private int[] bricks = new int[3 * 64];

  /** For each of these bricks the bits that differ, and their values. */
  private long[] words = new long[2 * 64];

  private int count;
  private int next;
  private final BrushLimits limits;
  private final IntBox changed = new IntBox();

  /**
   * Makes an edit. It keeps neither of the cubes.
   *
   * @param segment index of the segment in the scene
   * @param before the voxels from which {@code after} was computed, a cube of the scene's sizes
   * @param after the voxels as they should be, a cube of the same sizes
   * @param limits the voxels that it leaves as they are
   */
  public DifferenceEdit(int segment, BitCube before, BitCube after, BrushLimits limits) {
    super(segment);
    this.limits = limits;
    for (int z = 0; z < after.bricksZ(); z++) {
      for (int y = 0; y < after.bricksY(); y++) {
        for (int x = 0; x < after.bricksX(); x++) {
          long differs = before.brick(x, y, z) ^ after.brick(x, y, z);
          if (differs != 0) {
            add(x, y, z, differs, after.brick(x, y, z));
          }
        }
      }
    }
  }

  private void add(int x, int y, int z, long differs, long word) {
    if (3 * count == bricks.length) {
      bricks = Arrays.copyOf(bricks, 2 * bricks.length);
      words = Arrays.copyOf(words, 2 * words.length);
    }
    bricks[3 * count] = x;
    bricks[3 * count + 1] = y;
    bricks[3 * count + 2] = z;
    words[2 * count] = differs;
    words[2 * count + 1] = word;
    count++;
  }

  /** {@return whether the cubes are equal, so that the edit changes nothing} */
  public boolean isEmpty() {
    return count == 0;
  }

  @Override
  void prepare(SegmentGrids grids) {
    VoxelGrid grid = grids.grid(segment());
    for (int n = 0; n < count; n++) {
      if (!grid.contains(4 * bricks[3 * n], 4 * bricks[3 * n + 1], 4 * bricks[3 * n + 2])) {
        throw new IllegalArgumentException("cubes must have the grid's sizes");
      }
    }
  }

  @Override
  int apply(VoxelWriter out, int maxVoxels) {
    int most = Math.max(1, maxVoxels / HistoryEdit.VOXELS_A_BRICK);
    for (int n = 0; n < most && next < count; n++) {
      writeBrick(out, next++);
    }
    if (next == count) {
      finish();
    }
    return Math.max(1, Math.min(maxVoxels, most * HistoryEdit.VOXELS_A_BRICK));
  }

  /** Writes the voxels of a brick that differ. */
  private void writeBrick(VoxelWriter out, int brick) {
    long word = words[2 * brick + 1];
    changed.clear();
    for (long rest = words[2 * brick]; rest != 0; rest &= rest - 1) {
      int bit = Long.numberOfTrailingZeros(rest);
      int i = (bricks[3 * brick] << BitCube.BRICK_SHIFT) + (bit & 3);
      int j = (bricks[3 * brick + 1] << BitCube.BRICK_SHIFT) + (bit >> 2 & 3);
      int k = (bricks[3 * brick + 2] << BitCube.BRICK_SHIFT) + (bit >> 4);
      if (limits.write(out, segment(), i, j, k, (word >>> bit & 1) != 0)) {
        changed.include(i, j, k);
      }
    }
    out.applied(segment(), changed);
  }
}
