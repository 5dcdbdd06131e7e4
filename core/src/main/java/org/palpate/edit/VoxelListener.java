package org.palpate.edit;

/** Receives each voxel that changed. Haptic thread: an implementation allocates nothing. */
@FunctionalInterface
public interface VoxelListener {
  /** Ignores all changes. */
  VoxelListener NONE = (segment, i, j, k, solid) -> {};

  /**
   * Receives a change after it was made.
   *
   * @param segment index of the segment in the scene
   * @param i the voxel's number along x
   * @param j its number along y
   * @param k its number along z
   * @param solid whether voxel (i,j,k) is solid now
   */
  void changed(int segment, int i, int j, int k, boolean solid);
}
