package org.palpate.volume.phantom;

import org.palpate.volume.BitCube;

/** Writes the bricks of a phantom into bit cubes or into a layer of four slices. */
final class PhantomBrickWriter {
  private static final int BRICKS_A_ROW = 4;

  private final BrickSource bricks;
  private final int edge;
  private final int edgeBricks;
  private final int[] voxels = new int[64];

  PhantomBrickWriter(BrickSource bricks, int edge) {
    this.bricks = bricks;
    this.edge = edge;
    edgeBricks = (edge + 3) / 4;
  }

  /** Sets the bits of label n+1 in cube n; the cubes must be empty. */
  void writeLabels(BitCube[] cubes) {
    for (int z = 0; z < edgeBricks; z++) {
      for (int y = 0; y < edgeBricks; y++) {
        writeRow(cubes, y, z);
      }
    }
  }

  private void writeRow(BitCube[] cubes, int y, int z) {
    for (int x = 0; x < edgeBricks; x++) {
      if (x % BRICKS_A_ROW == 0) {
        bricks.enterRow(x, y, z);
      }
      int label = bricks.labels(x, y, z, voxels);
      if (label != 0) {
        for (int n = 0; n < cubes.length; n++) {
          writeBrick(cubes[n], n + 1, label, x, y, z);
        }
      }
    }
  }

  private void writeBrick(BitCube cube, int wanted, int label, int x, int y, int z) {
    long word = label == BrickSource.MIXED ? bitsOf(wanted) : label == wanted ? -1L : 0;
    word &= insideMask(x, y, z);
    if (word != 0) {
      cube.setBrick(x, y, z, word);
    }
  }

  private long bitsOf(int wanted) {
    long word = 0;
    for (int bit = 0; bit < 64; bit++) {
      word |= (voxels[bit] == wanted ? 1L : 0L) << bit;
    }
    return word;
  }

  private long insideMask(int x, int y, int z) {
    if (4 * x + 4 <= edge && 4 * y + 4 <= edge && 4 * z + 4 <= edge) {
      return -1L;
    }
    long mask = 0;
    for (int bit = 0; bit < 64; bit++) {
      boolean inside =
          4 * x + (bit & 3) < edge && 4 * y + (bit >> 2 & 3) < edge && 4 * z + (bit >> 4) < edge;
      mask |= (inside ? 1L : 0L) << bit;
    }
    return mask;
  }

  /**
   * Writes the four slices from {@code 4 * brickZ} on, x fastest.
   *
   * @param layer receives 4 * edge * edge values; those of slices beyond the edge are undefined
   */
  void writeLayer(int brickZ, boolean grey, short[] layer) {
    for (int y = 0; y < edgeBricks; y++) {
      for (int x = 0; x < edgeBricks; x++) {
        if (x % BRICKS_A_ROW == 0) {
          bricks.enterRow(x, y, brickZ);
        }
        int value = grey ? bricks.greys(x, y, brickZ, voxels) : bricks.labels(x, y, brickZ, voxels);
        fill(layer, x, y, value);
      }
    }
  }

  private void fill(short[] layer, int x, int y, int value) {
    for (int bit = 0; bit < 64; bit++) {
      int i = 4 * x + (bit & 3);
      int j = 4 * y + (bit >> 2 & 3);
      if (i < edge && j < edge) {
        layer[((bit >> 4) * edge + j) * edge + i] =
            (short) (value == BrickSource.MIXED ? voxels[bit] : value);
      }
    }
  }
}
