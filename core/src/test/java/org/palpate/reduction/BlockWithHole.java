package org.palpate.reduction;

import org.palpate.body.Body;
import org.palpate.body.Mobility;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/** A block of 16 voxels with a shaft of 4 by 4 voxels from its middle to its top. */
final class BlockWithHole {
  static final VoxelGrid GRID = VoxelGrid.ofUnitVoxels(16, 16, 16);

  /** A peg that fills the lower two thirds of the shaft. */
  static final BitCube PEG = PullSearchTest.box(6, 6, 4, 10, 10, 12);

  private BlockWithHole() {}

  /** Returns the block, which stands still. */
  static Body block() {
    return new Body("block", bits(), GRID, Mobility.FIXED);
  }

  /** Returns the peg in its place, which can move. */
  static Body peg() {
    return new Body("peg", PEG, GRID, Mobility.MOVABLE);
  }

  static BitCube bits() {
    BitCube bits = new BitCube(16, 16, 16);
    for (int k = 0; k < 16; k++) {
      for (int j = 0; j < 16; j++) {
        for (int i = 0; i < 16; i++) {
          boolean shaft = k >= 4 && i >= 6 && i < 10 && j >= 6 && j < 10;
          if (!shaft) {
            bits.set(i, j, k);
          }
        }
      }
    }
    return bits;
  }
}
