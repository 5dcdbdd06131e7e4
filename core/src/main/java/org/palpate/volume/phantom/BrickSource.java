package org.palpate.volume.phantom;

/** Where the voxels of a phantom come from, brick by brick. Keeps scratch: one thread. */
interface BrickSource {
  /** The brick is not of one kind: the answer stands in the array. */
  int MIXED = -1;

  /** Turns to the four bricks from {@code brickX} on along x, before bricks of theirs are asked. */
  void enterRow(int brickX, int brickY, int brickZ);

  /**
   * The label of all voxels of a brick of the entered row, or {@link #MIXED} and each voxel's label
   * in {@code dest}, in the order of the bits of a brick word.
   */
  int labels(int brickX, int brickY, int brickZ, int[] dest);

  /** As {@link #labels}, with grey values. */
  int greys(int brickX, int brickY, int brickZ, int[] dest);
}
