package org.palpate.proxy.smooth.field;

import java.util.Arrays;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.IntBox;
import org.palpate.volume.GreyQuantizer;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;

/**
 * The occupancies of voxels as their grey values give them.
 *
 * <p>Where an edit changed bits, the bits count: an added voxel has full occupancy, and a removed
 * one has none.
 */
final class GreyVoxels implements GreyOccupancyCache.Source {
  private static final int NONE = Integer.MIN_VALUE;
  private static final long TOP_BITS = 0x8080_8080_8080_8080L;

  /** A factor that gathers the top bits of all bytes in the topmost byte. */
  private static final long GATHER = 0x0002_0408_1020_4081L;

  private final GreyIsosurfaceSource source;
  private final VoxelGrid grid;
  private ScalarVolume volume;
  private GreyQuantizer quantizer;

  /** The bricks of bits read last: two for words of even number at 0, two for odd ones at 2. */
  private final long[] bricks = new long[4];

  /** The word number of those bricks, at 0 and 2. */
  private final int[] brickWord = new int[3];

  private final int[] brickY = new int[3];
  private final int[] brickZ = new int[3];

  /** The sum of all values that were fetched, without which the JIT would leave them out. */
  double fetched;

  GreyVoxels(GreyIsosurfaceSource source) {
    this.source = source;
    grid = source.grid();
    forget();
  }

  /** Forgets the bricks, and takes the present values of the source. */
  @Override
  public void forget() {
    GreyIsosurface now = source.now();
    volume = now.volume();
    quantizer = now.quantizer();
    Arrays.fill(brickWord, NONE);
  }

  @Override
  public void forget(IntBox changed) {
    Arrays.fill(brickWord, NONE);
  }

  @Override
  public void fetch(int word, int j, int k) {
    int i = word << 3;
    if (grid.contains(i, j, k)) {
      fetched += volume.value(i, j, k);
    }
  }

  @Override
  public long occupancies(CollisionScene scene, int word, int j, int k) {
    long fromGrey = levels(word << 3, j, k);
    int solid = solidVoxels(word, j, k, scene);
    int above = (int) (((fromGrey & TOP_BITS) * GATHER) >>> 56);
    return above == solid ? fromGrey : corrected(fromGrey, solid, above ^ solid);
  }

  /** Returns the solid voxels of a word, a bit each. */
  private int solidVoxels(int word, int j, int k, CollisionScene scene) {
    int at = (word & 1) << 1;
    if (brickWord[at] != word || brickY[at] != j >> 2 || brickZ[at] != k >> 2) {
      brickWord[at] = word;
      brickY[at] = j >> 2;
      brickZ[at] = k >> 2;
      bricks[at] = scene.brick(word << 1, j >> 2, k >> 2);
      bricks[at + 1] = scene.brick(word << 1 | 1, j >> 2, k >> 2);
    }
    int shift = (k & 3) << 4 | (j & 3) << 2;
    return (int) ((bricks[at] >>> shift & 0xF) | (bricks[at + 1] >>> shift & 0xF) << 4);
  }

  /** Returns the occupancies of the 8 voxels from i on by their grey values; 0 outside the grid. */
  private long levels(int i, int j, int k) {
    if (grid.contains(i, j, k) && grid.contains(i + ScalarVolume.LEVELS - 1, j, k)) {
      return volume.levels(i, j, k, quantizer);
    }
    long levels = 0;
    for (int n = 0; n < ScalarVolume.LEVELS; n++) {
      if (grid.contains(i + n, j, k)) {
        levels |= (long) quantizer.of(volume.value(i + n, j, k)) << (8 * n);
      }
    }
    return levels;
  }

  /** Returns the occupancies with those of {@code wrong} voxels taken from the bits. */
  private static long corrected(long occupancies, int solid, int wrong) {
    long wrongBytes = GreyOccupancyCache.bytesOf(wrong);
    return (occupancies & ~wrongBytes) | (wrongBytes & GreyOccupancyCache.bytesOf(solid));
  }
}
