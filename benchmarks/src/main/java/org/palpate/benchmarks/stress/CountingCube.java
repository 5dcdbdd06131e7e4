package org.palpate.benchmarks.stress;

import org.palpate.volume.BitCube;

/** A bit cube that counts the words that are read of it. */
final class CountingCube extends BitCube {
  /** A window is put together from so many bricks, or a few less at the rim. */
  private static final int WORDS_A_WINDOW = 8;

  private long words;

  /** The same voxels as another. */
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

  /** Words read so far. */
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
    long after = words + WORDS_A_WINDOW;
    long window = super.window(i, j, k);
    words = after; // however it reads them
    return window;
  }

  @Override
  public long block(int blockX, int blockY, int blockZ) {
    words++;
    return super.block(blockX, blockY, blockZ);
  }
}
