package org.palpate.scene;

import java.util.ArrayList;
import java.util.List;
import org.palpate.geometry.IntBox;

/** Collects the voxels that changed since their surfaces were built. One thread. */
public final class ChangedVoxels {
  private final List<IntBox> boxes = new ArrayList<>();
  private final long[] removed;

  /** Rebuilds surfaces. */
  @FunctionalInterface
  public interface Remesher {
    /**
     * Rebuilds the surface of a segment around the voxels in a box. An implementation must not keep
     * the box.
     *
     * @param segment index of the segment
     */
    void remesh(int segment, IntBox voxels);
  }

  /** Creates an empty collection for a number of segments. */
  public ChangedVoxels(int segments) {
    for (int n = 0; n < segments; n++) {
      boxes.add(new IntBox());
    }
    removed = new long[segments];
  }

  /** Notes that voxel (i,j,k) of a segment became solid or empty. */
  public void note(int segment, int i, int j, int k, boolean solid) {
    boxes.get(segment).include(i, j, k);
    removed[segment] += solid ? -1 : 1;
  }

  /**
   * Rebuilds the surfaces around what was noted since the last call.
   *
   * @return whether anything was noted
   */
  public boolean remesh(Remesher remesher) {
    boolean any = false;
    for (int segment = 0; segment < boxes.size(); segment++) {
      IntBox box = boxes.get(segment);
      if (!box.isEmpty()) {
        any = true;
        remesher.remesh(segment, new IntBox().set(box));
        box.clear();
      }
    }
    return any;
  }

  /**
   * Returns the number of voxels of a segment that were removed, minus those that were added, since
   * this object was made.
   */
  public long removed(int segment) {
    return removed[segment];
  }
}
