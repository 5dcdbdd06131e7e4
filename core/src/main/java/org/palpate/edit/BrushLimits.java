package org.palpate.edit;

import java.util.Optional;
import org.palpate.volume.BitCube;

/**
 * Limits of a brush: the voxels that it leaves as they are. The cubes are not copied, and nothing
 * changes them.
 *
 * @param only the voxels that may change, a cube over the grid; if empty, all of them
 * @param kept the voxels that must not change, a cube over the grid; if empty, none
 * @param sparesTool whether a voxel stays empty if the tool would meet it; otherwise the frame sets
 *     the tool free
 */
public record BrushLimits(Optional<BitCube> only, Optional<BitCube> kept, boolean sparesTool) {
  /** No limits. */
  public static final BrushLimits NONE = new BrushLimits(Optional.empty(), Optional.empty(), false);

  /**
   * Makes a voxel of the grid solid or empty, unless it must stay. Haptic thread.
   *
   * @return whether it changed
   */
  boolean write(VoxelWriter out, int segment, int i, int j, int k, boolean solid) {
    boolean mayChange =
        (only.isEmpty() || only.get().get(i, j, k))
            && (kept.isEmpty() || !kept.get().get(i, j, k))
            && out.changes(segment, i, j, k, solid);
    return mayChange
        && !(solid && sparesTool && out.tool().meets(segment, i, j, k))
        && out.write(segment, i, j, k, solid);
  }
}
