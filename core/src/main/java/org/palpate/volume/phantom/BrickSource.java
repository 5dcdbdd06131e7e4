package org.palpate.volume.phantom;

/** Generates the voxels of a phantom brick by brick. Keeps scratch: one thread. */
interface BrickSource {
  /** The result for a brick with several labels or grey values; {@code dest} then holds them. */
  int MIXED = -1;

  /**
   * Enters the row of four bricks from {@code brickX} on along x. Call this before asking for a
   * brick of the row.
   */
  void enterRow(int brickX, int brickY, int brickZ);

  /**
   * Returns the label of all voxels of a brick of the entered row. If they differ, returns {@link
   * #MIXED} and writes the label of each voxel into {@code dest}, in the bit order of a brick word.
   */
  int labels(int brickX, int brickY, int brickZ, int[] dest);

  /** Returns grey values, by the same rule by which {@link #labels} returns labels. */
  int greys(int brickX, int brickY, int brickZ, int[] dest);
}
