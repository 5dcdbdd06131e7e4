package org.palpate.fracture;

import java.util.Optional;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;

/**
 * The part of each voxel on both sides of a fragment's surface that bone fills. It follows from the
 * grey values from which a threshold made the fragment. Immutable; any thread.
 *
 * <p>Grey values count only where they show an edge: in a voxel of the fragment that shares a face
 * with one outside below the threshold, and in that one. A face that was cut inside bone has bone
 * on its other side, so its voxels stay full and empty. An empty voxel beside bone of another
 * fragment stays empty, because its grey value does not say how much of it each fills.
 */
public final class PartialVoxels {
  /** The edge of a brick of voxels. */
  static final int EDGE = 1 << BitCube.BRICK_SHIFT;

  private static final int MASK = EDGE - 1;

  /** The largest distance of two voxels that count as one, voxels. */
  private static final double SAME_VOXEL = 1e-3;

  /** The lowest brick along each axis, and the number of bricks. */
  private final int[] low = new int[3];

  private final int[] count = new int[3];

  /** For each brick what grey values add to the bits, x first; null if nothing. */
  private final float[][] bricks;

  private PartialVoxels(IntBox box) {
    int[] first = {box.lowX, box.lowY, box.lowZ};
    int[] last = {box.highX, box.highY, box.highZ};
    for (int axis = 0; axis < 3; axis++) {
      low[axis] = (first[axis] - 1) >> BitCube.BRICK_SHIFT;
      count[axis] = ((last[axis] + 1) >> BitCube.BRICK_SHIFT) - low[axis] + 1;
    }
    bricks = new float[count[0] * count[1] * count[2]][];
  }

  /**
   * Reads the grey values around a fragment.
   *
   * @param bits the voxels of the fragment, of which there is one
   * @param grid their grid
   * @param values the grey values
   * @param valuesGrid their grid in the world of the fragment
   * @param threshold the least value of bone
   * @param contrast how far above the threshold a voxel is full, and how far below it empty
   * @return empty if the voxels of the fragment are not voxels of the grey values
   */
  public static Optional<PartialVoxels> of(
      BitCube bits,
      VoxelGrid grid,
      ScalarVolume values,
      VoxelGrid valuesGrid,
      double threshold,
      double contrast) {
    int[] offset = new int[3];
    if (!findOffset(bits.bounds(), grid, valuesGrid, offset)) {
      return Optional.empty();
    }
    PartialVoxels made = new PartialVoxels(bits.bounds());
    bits.forEachRimVoxel(new Reading(bits, values, offset, threshold, contrast, made)::readAround);
    return Optional.of(made);
  }

  /** Finds how far voxels of a box have to be counted on to be those of another grid. */
  private static boolean findOffset(IntBox box, VoxelGrid grid, VoxelGrid other, int[] offset) {
    for (int corner = 0; corner < 8; corner++) {
      Vec3 here =
          new Vec3(
              (corner & 1) == 0 ? box.lowX : box.highX + 1.0,
              (corner & 2) == 0 ? box.lowY : box.highY + 1.0,
              (corner & 4) == 0 ? box.lowZ : box.highZ + 1.0);
      Vec3 there = other.worldToGrid(grid.gridToWorld(here, new Vec3()), new Vec3());
      there.sub(here, there);
      for (int axis = 0; axis < 3; axis++) {
        if (corner == 0) {
          offset[axis] = (int) Math.rint(there.get(axis));
        }
        if (!(Math.abs(there.get(axis) - offset[axis]) <= SAME_VOXEL)) {
          return false;
        }
      }
    }
    return true;
  }

  /** Returns what grey values add to the bits of a brick, x first; null if nothing. */
  float[] excess(int x, int y, int z) {
    int at = brick(x, y, z);
    return at < 0 ? null : bricks[at];
  }

  private int brick(int x, int y, int z) {
    int a = x - low[0];
    int b = y - low[1];
    int c = z - low[2];
    boolean isInside = a >= 0 && b >= 0 && c >= 0 && a < count[0] && b < count[1] && c < count[2];
    return isInside ? (c * count[1] + b) * count[0] + a : -1;
  }

  private void set(int i, int j, int k, double excess) {
    int at = brick(i >> BitCube.BRICK_SHIFT, j >> BitCube.BRICK_SHIFT, k >> BitCube.BRICK_SHIFT);
    if (bricks[at] == null) {
      bricks[at] = new float[EDGE * EDGE * EDGE];
    }
    bricks[at][((k & MASK) * EDGE + (j & MASK)) * EDGE + (i & MASK)] = (float) excess;
  }

  /** The grey values around the rim of a fragment. */
  private static final class Reading {
    private final BitCube bits;
    private final ScalarVolume values;
    private final int[] offset;
    private final double threshold;
    private final double contrast;
    private final PartialVoxels dest;

    /** Prepares to read; the offset leads from a voxel of the fragment to that of the values. */
    Reading(
        BitCube bits,
        ScalarVolume values,
        int[] offset,
        double threshold,
        double contrast,
        PartialVoxels dest) {
      this.bits = bits;
      this.values = values;
      this.offset = offset;
      this.threshold = threshold;
      this.contrast = contrast;
      this.dest = dest;
    }

    /** Reads a voxel of the rim, and the voxels of background that share a face with it. */
    void readAround(int i, int j, int k) {
      boolean hasEdge = false;
      for (int side = 0; side < 6; side++) {
        int axis = side / 2;
        int step = side % 2 == 0 ? 1 : -1;
        int x = i + (axis == 0 ? step : 0);
        int y = j + (axis == 1 ? step : 0);
        int z = k + (axis == 2 ? step : 0);
        if (isOutside(x, y, z) && value(x, y, z) < threshold) {
          hasEdge = true;
          dest.set(x, y, z, isBesideOther(x, y, z) ? 0 : fullness(x, y, z));
        }
      }
      if (hasEdge && isIn(i, j, k) && value(i, j, k) >= threshold) {
        dest.set(i, j, k, fullness(i, j, k) - 1);
      }
    }

    private boolean isIn(int i, int j, int k) {
      return values.grid().contains(i + offset[0], j + offset[1], k + offset[2]);
    }

    private boolean isOutside(int i, int j, int k) {
      return isIn(i, j, k) && !bits.get(i, j, k);
    }

    private double value(int i, int j, int k) {
      return values.value(i + offset[0], j + offset[1], k + offset[2]);
    }

    private double fullness(int i, int j, int k) {
      double fullness = 0.5 + 0.5 * (value(i, j, k) - threshold) / contrast;
      return Math.max(0, Math.min(1, fullness));
    }

    /** Whether bone that is not of the fragment touches a voxel. */
    private boolean isBesideOther(int i, int j, int k) {
      for (int z = k - 1; z <= k + 1; z++) {
        for (int y = j - 1; y <= j + 1; y++) {
          for (int x = i - 1; x <= i + 1; x++) {
            if (isOutside(x, y, z) && value(x, y, z) >= threshold) {
              return true;
            }
          }
        }
      }
      return false;
    }
  }
}
