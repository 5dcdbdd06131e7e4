package org.palpate.benchmarks.stress;

import org.palpate.volume.BitCube;

/** A bit cube that counts the words read from it. */
final class CountingCube extends BitCube {
  /** A window is made of this many bricks, or fewer at the margin of the grid. */
  private static final int WORDS_PER_WINDOW = 8;

  private long words;

  /** Copies the voxels of another cube. */
  CountingCube(BitCube like) {
    super(like.sizeX(), like.sizeY(), like.sizeZ());
    for (int z = 0; z < like.bricksZ(); z++) {
      for (int y = 0; y < like.bricksY(); y++) {
        for (int x = 0; x < like.bricksX(); x++) {
          setBrick(x, y, z, like.brick(x, y, z));
        }
      }
    }
  }

  /** Returns the number of words read so far. */
  long words() {
    return words;
  }

  @Override
  public long brick(int brickX, int brickY, int brickZ) {
    words++;
    return super.brick(brickX, brickY, brickZ);
  }

  @Override
  public long window(int i, int j, int k) {
    long after = words + WORDS_PER_WINDOW;
    long window = super.window(i, j, k);
    words = after; // a window counts the same, however it is read
    return window;
  }

  @Override
  public long block(int blockX, int blockY, int blockZ) {
    words++;
    return super.block(blockX, blockY, blockZ);
  }
}
