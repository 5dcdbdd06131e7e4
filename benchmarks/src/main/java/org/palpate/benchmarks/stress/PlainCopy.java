package org.palpate.benchmarks.stress;

import java.util.BitSet;
import org.palpate.edit.VoxelListener;
import org.palpate.volume.BitCube;

/**
 * A plain copy of the voxels of the first segment. It follows each reported change, and counts
 * those of voxels that must stay. One thread.
 */
public final class PlainCopy implements VoxelListener {
  private final int sizeX;
  private final int sizeY;
  private final int sizeZ;
  private final BitSet solids = new BitSet();
  private final BitCube kept;
  private long changes;
  private long keptChanges;

  /**
   * Copies voxels.
   *
   * @param kept the voxels that must stay, a cube of the same sizes; not copied
   */
  public PlainCopy(BitCube bits, BitCube kept) {
    this.kept = kept;
    sizeX = bits.sizeX();
    sizeY = bits.sizeY();
    sizeZ = bits.sizeZ();
    for (int n = 0; n < sizeX * sizeY * sizeZ; n++) {
      solids.set(n, bits.get(n % sizeX, n / sizeX % sizeY, n / (sizeX * sizeY)));
    }
  }

  @Override
  public void changed(int segment, int i, int j, int k, boolean solid) {
    changes++;
    keptChanges += segment != 0 || kept.get(i, j, k) ? 1 : 0;
    if (segment == 0) {
      solids.set((k * sizeY + j) * sizeX + i, solid);
    }
  }

  /** Returns the number of reported changes. */
  public long changes() {
    return changes;
  }

  /** Returns the number of changes of voxels that must stay, or of other segments. */
  public long keptChanges() {
    return keptChanges;
  }

  /** Counts the bricks of all levels in which a cube differs from one that is made anew. */
  public long differentBricks(BitCube bits) {
    BitCube anew = new BitCube(sizeX, sizeY, sizeZ);
    for (int n = solids.nextSetBit(0); n >= 0; n = solids.nextSetBit(n + 1)) {
      anew.set(n % sizeX, n / sizeX % sizeY, n / (sizeX * sizeY));
    }
    return differentBricks(anew, bits);
  }

  /** Counts the bricks of all levels in which two cubes of the same sizes differ. */
  public static long differentBricks(BitCube a, BitCube b) {
    long count = a.solidCount() == b.solidCount() ? 0 : 1;
    for (int z = 0; z < a.bricksZ(); z++) {
      for (int y = 0; y < a.bricksY(); y++) {
        for (int x = 0; x < a.bricksX(); x++) {
          boolean same =
              a.brick(x, y, z) == b.brick(x, y, z)
                  && a.block(x >> 2, y >> 2, z >> 2) == b.block(x >> 2, y >> 2, z >> 2);
          count += same ? 0 : 1;
        }
      }
    }
    return count;
  }
}
