package org.palpate.edit;

import org.palpate.geometry.IntBox;

/**
 * Receives the box of voxels that an edit may have changed, for code that caches voxels. Haptic
 * thread: an implementation allocates nothing.
 */
@FunctionalInterface
public interface EditListener {
  /** Ignores all edits. */
  EditListener NONE = (segment, voxels) -> {};

  /**
   * Receives an edit, or a part of one, after its writes.
   *
   * @param segment index of the segment in the scene
   * @param voxels a box around the voxels that may have changed; empty if only grey values did. It
   *     belongs to the edit.
   */
  void applied(int segment, IntBox voxels);
}
