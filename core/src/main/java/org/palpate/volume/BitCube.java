package org.palpate.volume;

import org.palpate.geometry.IntBox;

/**
 * A cube of bits, one a voxel: whether the voxel is solid. A brick of 4x4x4 voxels is one {@code
 * long}. A second level of the same shape marks the bricks that are not empty.
 *
 * <pre>
 *   brick word    bit  z z y y x x     of the voxel inside its brick
 *   upper word    bit  Z Z Y Y X X     of the brick inside its block of 4x4x4 bricks, set if the brick is not empty
 * </pre>
 *
 * <p>Invariant: an upper bit is set exactly if its brick word is not 0. Invariant: padding bits,
 * beyond the size, are clear. Every edit keeps both. Nothing else is precalculated, so that no edit
 * invalidates anything.
 *
 * <p>Frame: grid coordinates; outside the cube all is empty. Thread: one thread writes, the haptic
 * thread while a session runs. Readers take no lock; they need a safe publication of the changes.
 *
 * <p>All reading goes through {@link #brick}, {@link #block} or {@link #window}, so that a subclass
 * can count it. As long as no subclass is loaded, the virtual machine binds calls as if this class
 * were final.
 */
public class BitCube {
  /** The binary logarithm of the voxels along an edge of a brick. */
  public static final int BRICK_SHIFT = 2;

  /** The largest size: the planes behind the last voxel and its brick still have int numbers. */
  public static final int MAX_SIZE = 1 << 30;

  /** The binary logarithm of the voxels along an edge of a block of 4x4x4 bricks. */
  public static final int BLOCK_SHIFT = 4;

  private final int sizeX;
  private final int sizeY;
  private final int sizeZ;
  private final int bricksX;
  private final int bricksY;
  private final int bricksZ;
  private final int blocksX;
  private final int blocksY;
  private final long[] bricks;
  private final long[] blocks;
  private final IntBox bounds = new IntBox();
  private long solidCount;

  /**
   * Creates an empty cube. Allocates {@link #bytesFor} bytes.
   *
   * @param sizeX the number of voxels along x
   * @param sizeY the number of voxels along y
   * @param sizeZ the number of voxels along z
   * @throws IllegalArgumentException if a size is below 1 or above {@link #MAX_SIZE}, or there are
   *     more than 2^31-1 bricks
   */
  public BitCube(int sizeX, int sizeY, int sizeZ) {
    if (sizeX < 1 || sizeY < 1 || sizeZ < 1) {
      throw new IllegalArgumentException(
          "sizes must be at least 1: sizes=" + sizeX + "x" + sizeY + "x" + sizeZ);
    }
    if (Math.max(sizeX, Math.max(sizeY, sizeZ)) > MAX_SIZE) {
      throw new IllegalArgumentException(
          "sizes must be at most 2^30: sizes=" + sizeX + "x" + sizeY + "x" + sizeZ);
    }
    this.sizeX = sizeX;
    this.sizeY = sizeY;
    this.sizeZ = sizeZ;
    bricksX = cellsFor(sizeX, BRICK_SHIFT);
    bricksY = cellsFor(sizeY, BRICK_SHIFT);
    bricksZ = cellsFor(sizeZ, BRICK_SHIFT);
    blocksX = cellsFor(sizeX, BLOCK_SHIFT);
    blocksY = cellsFor(sizeY, BLOCK_SHIFT);
    bricks = new long[arrayLength(bricksX, bricksY, bricksZ)];
    blocks = new long[arrayLength(blocksX, blocksY, cellsFor(sizeZ, BLOCK_SHIFT))];
  }

  /**
   * {@return the memory of a cube of this size, bytes; may be far more than there is}
   *
   * @param sizeX the number of voxels along x, at least 1
   * @param sizeY the number of voxels along y, at least 1
   * @param sizeZ the number of voxels along z, at least 1
   */
  public static double bytesFor(int sizeX, int sizeY, int sizeZ) {
    return 8.0 * cells(sizeX, sizeY, sizeZ, BRICK_SHIFT)
        + 8.0 * cells(sizeX, sizeY, sizeZ, BLOCK_SHIFT);
  }

  private static double cells(int sizeX, int sizeY, int sizeZ, int shift) {
    return (double) cellsFor(sizeX, shift) * cellsFor(sizeY, shift) * cellsFor(sizeZ, shift);
  }

  private static int cellsFor(int voxels, int shift) {
    return ((voxels - 1) >> shift) + 1;
  }

  private static int arrayLength(int x, int y, int z) {
    double cells = (double) x * y * z;
    if (cells > Integer.MAX_VALUE - 8) {
      throw new IllegalArgumentException("too many bricks for one cube: " + x + "x" + y + "x" + z);
    }
    return x * y * z;
  }

  /** {@return the number of voxels along x} */
  public int sizeX() {
    return sizeX;
  }

  /** {@return the number of voxels along y} */
  public int sizeY() {
    return sizeY;
  }

  /** {@return the number of voxels along z} */
  public int sizeZ() {
    return sizeZ;
  }

  /** {@return the number of solid voxels} Constant time. */
  public long solidCount() {
    return solidCount;
  }

  /**
   * Returns a box that contains every solid voxel. It is tight as long as nothing was cleared, and
   * {@link #tightenBounds} makes it tight again. Constant time.
   *
   * @return the cube's own box, which the caller must not change
   */
  public IntBox bounds() {
    return bounds;
  }

  /**
   * {@return whether voxel (i,j,k) is solid; false outside the cube}
   *
   * @param i the voxel's number along x
   * @param j its number along y
   * @param k its number along z
   */
  public boolean get(int i, int j, int k) {
    return (brick(i >> BRICK_SHIFT, j >> BRICK_SHIFT, k >> BRICK_SHIFT) >>> bit(i, j, k) & 1) != 0;
  }

  /**
   * {@return whether all six voxels across the faces of voxel (i,j,k) are solid}
   *
   * @param i the voxel's number along x
   * @param j its number along y
   * @param k its number along z
   */
  public boolean isSurrounded(int i, int j, int k) {
    return get(i - 1, j, k)
        && get(i + 1, j, k)
        && get(i, j - 1, k)
        && get(i, j + 1, k)
        && get(i, j, k - 1)
        && get(i, j, k + 1);
  }

  /** Receives voxels. */
  @FunctionalInterface
  public interface VoxelSink {
    /**
     * Receives voxel (i,j,k).
     *
     * @param i the voxel's number along x
     * @param j its number along y
     * @param k its number along z
     */
    void take(int i, int j, int k);
  }

  /**
   * Hands every solid voxel that is not surrounded to a sink, in the order of k, j and i.
   *
   * @param sink receives the voxels on the calling thread; must not change the cube
   */
  public void forEachRimVoxel(VoxelSink sink) {
    for (int k = bounds.lowZ; k <= bounds.highZ; k++) {
      for (int j = bounds.lowY; j <= bounds.highY; j++) {
        for (int i = bounds.lowX; i <= bounds.highX; i++) {
          if (get(i, j, k) && !isSurrounded(i, j, k)) {
            sink.take(i, j, k);
          }
        }
      }
    }
  }

  /**
   * Makes voxel (i,j,k) solid.
   *
   * @param i the voxel's number along x
   * @param j its number along y
   * @param k its number along z
   * @throws IndexOutOfBoundsException if the voxel lies outside the cube
   */
  public void set(int i, int j, int k) {
    int index = checkedBrickIndex(i, j, k);
    long word = bricks[index];
    long changed = word | 1L << bit(i, j, k);
    if (changed != word) {
      putBrick(index, changed, i >> BRICK_SHIFT, j >> BRICK_SHIFT, k >> BRICK_SHIFT);
      bounds.include(i, j, k);
    }
  }

  /**
   * Makes voxel (i,j,k) empty.
   *
   * @param i the voxel's number along x
   * @param j its number along y
   * @param k its number along z
   * @throws IndexOutOfBoundsException if the voxel lies outside the cube
   */
  public void clear(int i, int j, int k) {
    int index = checkedBrickIndex(i, j, k);
    long word = bricks[index];
    long changed = word & ~(1L << bit(i, j, k));
    if (changed != word) {
      putBrick(index, changed, i >> BRICK_SHIFT, j >> BRICK_SHIFT, k >> BRICK_SHIFT);
    }
  }

  /**
   * {@return the bit of a voxel in the word of its brick: two bits of z, two of y, two of x}
   *
   * @param i the voxel's number along x, of any sign
   * @param j its number along y
   * @param k its number along z
   */
  public static int bit(int i, int j, int k) {
    return ((k & 3) << 4) | ((j & 3) << 2) | (i & 3);
  }

  /**
   * {@return the word of a brick; 0 outside the cube}
   *
   * @param brickX brick coordinates: voxel coordinates shifted right by {@link #BRICK_SHIFT}
   * @param brickY the same along y
   * @param brickZ the same along z
   */
  public long brick(int brickX, int brickY, int brickZ) {
    return isBrick(brickX, brickY, brickZ) ? bricks[brickIndex(brickX, brickY, brickZ)] : 0;
  }

  /**
   * {@return whether the voxels around a grid coordinate have int numbers that {@link #window}
   * takes}
   *
   * @param coordinate a coordinate of a point along any axis; NaN has no window
   */
  public static boolean hasWindow(double coordinate) {
    return Math.abs(coordinate) < MAX_SIZE;
  }

  /**
   * {@return the 4x4x4 voxels whose lowest is (i,j,k), across bricks, in the bit order of a brick}
   * Voxels outside the cube are empty. Cost: eight loads and no mispredicted branch.
   *
   * @param i the number of the lowest voxel along x, below {@link #MAX_SIZE} in magnitude
   * @param j its number along y, likewise
   * @param k its number along z, likewise
   */
  public long window(int i, int j, int k) {
    int x = i >> BRICK_SHIFT;
    int y = j >> BRICK_SHIFT;
    int z = k >> BRICK_SHIFT;
    boolean inside =
        x >= 0 && x < bricksX - 1 && y >= 0 && y < bricksY - 1 && z >= 0 && z < bricksZ - 1;
    return inside ? windowInside(i, j, k, brickIndex(x, y, z)) : windowAtRim(i, j, k);
  }

  /** Returns a window whose eight bricks all lie in the cube, the lowest of them at an index. */
  private long windowInside(int i, int j, int k, int at) {
    int shift = (k & 3) << 4;
    int above = at + bricksX * bricksY;
    long near = slabInside(i, j, at) >>> shift;
    return near | slabInside(i, j, above) << (48 - shift) << 16;
  }

  private long slabInside(int i, int j, int at) {
    int shift = (j & 3) << 2;
    long nearRows = (0xffff >>> shift) * 0x0001_0001_0001_0001L;
    long near = rowInside(i, at) >>> shift;
    long far = rowInside(i, at + bricksX) << (16 - shift);
    return (near & nearRows) | (far & ~nearRows);
  }

  private long rowInside(int i, int at) {
    int shift = i & 3;
    long nearVoxels = (0xf >>> shift) * 0x1111_1111_1111_1111L;
    return (bricks[at] >>> shift & nearVoxels) | (bricks[at + 1] << (4 - shift) & ~nearVoxels);
  }

  private long windowAtRim(int i, int j, int k) {
    int shift = (k & 3) << 4;
    long near = slab(i, j, k >> BRICK_SHIFT) >>> shift;
    long far = slab(i, j, (k >> BRICK_SHIFT) + 1);
    return near | far << (48 - shift) << 16; // in two shifts, because a shift by 64 is one by 0
  }

  private long slab(int i, int j, int brickZ) {
    int shift = (j & 3) << 2;
    long nearRows = (0xffff >>> shift) * 0x0001_0001_0001_0001L;
    long near = row(i, j >> BRICK_SHIFT, brickZ) >>> shift;
    long far = row(i, (j >> BRICK_SHIFT) + 1, brickZ) << (16 - shift);
    return (near & nearRows) | (far & ~nearRows);
  }

  private long row(int i, int brickY, int brickZ) {
    int shift = i & 3;
    long nearVoxels = (0xf >>> shift) * 0x1111_1111_1111_1111L;
    long near = brick(i >> BRICK_SHIFT, brickY, brickZ) >>> shift;
    long far = brick((i >> BRICK_SHIFT) + 1, brickY, brickZ) << (4 - shift);
    return (near & nearVoxels) | (far & ~nearVoxels);
  }

  /**
   * {@return the word of a block of 4x4x4 bricks; 0 outside the cube} A bit is set if its brick is
   * not empty.
   *
   * @param blockX block coordinates: voxel coordinates shifted right by {@link #BLOCK_SHIFT}
   * @param blockY the same along y
   * @param blockZ the same along z
   */
  public long block(int blockX, int blockY, int blockZ) {
    int index = (blockZ * blocksY + blockY) * blocksX + blockX;
    boolean inside =
        blockX >= 0
            && blockX < blocksX
            && blockY >= 0
            && blockY < blocksY
            && blockZ >= 0
            && index < blocks.length;
    return inside ? blocks[index] : 0;
  }

  /**
   * Replaces a whole brick.
   *
   * @param brickX brick coordinates: voxel coordinates shifted right by {@link #BRICK_SHIFT}
   * @param brickY the same along y
   * @param brickZ the same along z
   * @param word the new bits; those beyond the size of the cube must be clear
   * @throws IllegalArgumentException if the brick lies outside or the word has a padding bit set
   */
  public void setBrick(int brickX, int brickY, int brickZ, long word) {
    if (!isBrick(brickX, brickY, brickZ) || (word & ~insideMask(brickX, brickY, brickZ)) != 0) {
      throw new IllegalArgumentException(
          "brick lies outside or has padding bits set: brick="
              + brickX
              + ","
              + brickY
              + ","
              + brickZ
              + " word="
              + Long.toHexString(word));
    }
    putBrick(brickIndex(brickX, brickY, brickZ), word, brickX, brickY, brickZ);
    includeBrick(brickX, brickY, brickZ, word);
  }

  /** {@return the number of bricks along x} */
  public int bricksX() {
    return bricksX;
  }

  /** {@return the number of bricks along y} */
  public int bricksY() {
    return bricksY;
  }

  /** {@return the number of bricks along z} */
  public int bricksZ() {
    return bricksZ;
  }

  /** Makes {@link #bounds} tight again after voxels were cleared. Cost: reads every brick. */
  public void tightenBounds() {
    bounds.clear();
    for (int z = 0; z < bricksZ; z++) {
      for (int y = 0; y < bricksY; y++) {
        for (int x = 0; x < bricksX; x++) {
          includeBrick(x, y, z, bricks[brickIndex(x, y, z)]);
        }
      }
    }
  }

  /** {@return a copy that shares nothing with this cube} */
  public BitCube copy() {
    BitCube copy = new BitCube(sizeX, sizeY, sizeZ);
    System.arraycopy(bricks, 0, copy.bricks, 0, bricks.length);
    System.arraycopy(blocks, 0, copy.blocks, 0, blocks.length);
    copy.bounds.set(bounds);
    copy.solidCount = solidCount;
    return copy;
  }

  private void includeBrick(int brickX, int brickY, int brickZ, long word) {
    if (word == 0) {
      return;
    }
    int i = brickX << BRICK_SHIFT;
    int j = brickY << BRICK_SHIFT;
    int k = brickZ << BRICK_SHIFT;
    if (bounds.contains(i, j, k) && bounds.contains(i + 3, j + 3, k + 3)) {
      return;
    }
    long half = word | word >>> 32;
    int layer = (int) (half | half >>> 16) & 0xffff; // all z layers in one
    int row = (layer | layer >>> 4 | layer >>> 8 | layer >>> 12) & 0xf; // and all y rows
    bounds.include(
        i + lowest(row), j + (lowest(layer) >> 2), k + (Long.numberOfTrailingZeros(word) >> 4));
    bounds.include(
        i + highest(row),
        j + (highest(layer) >> 2),
        k + ((63 - Long.numberOfLeadingZeros(word)) >> 4));
  }

  private static int lowest(int bits) {
    return Integer.numberOfTrailingZeros(bits);
  }

  private static int highest(int bits) {
    return 31 - Integer.numberOfLeadingZeros(bits);
  }

  private void putBrick(int index, long word, int brickX, int brickY, int brickZ) {
    solidCount += Long.bitCount(word) - Long.bitCount(bricks[index]);
    bricks[index] = word;
    int block = ((brickZ >> 2) * blocksY + (brickY >> 2)) * blocksX + (brickX >> 2);
    long mark = 1L << bit(brickX, brickY, brickZ);
    blocks[block] = word == 0 ? blocks[block] & ~mark : blocks[block] | mark;
  }

  private long insideMask(int brickX, int brickY, int brickZ) {
    int x = Math.min(4, sizeX - (brickX << BRICK_SHIFT));
    int y = Math.min(4, sizeY - (brickY << BRICK_SHIFT));
    int z = Math.min(4, sizeZ - (brickZ << BRICK_SHIFT));
    if (x == 4 && y == 4 && z == 4) {
      return -1L;
    }
    long row = (1L << x) - 1;
    long layer = 0;
    for (int j = 0; j < y; j++) {
      layer |= row << (4 * j);
    }
    long mask = 0;
    for (int k = 0; k < z; k++) {
      mask |= layer << (16 * k);
    }
    return mask;
  }

  private boolean isBrick(int brickX, int brickY, int brickZ) {
    return brickX >= 0
        && brickX < bricksX
        && brickY >= 0
        && brickY < bricksY
        && brickZ >= 0
        && brickZ < bricksZ;
  }

  private int brickIndex(int brickX, int brickY, int brickZ) {
    return (brickZ * bricksY + brickY) * bricksX + brickX;
  }

  private int checkedBrickIndex(int i, int j, int k) {
    if (i < 0 || i >= sizeX || j < 0 || j >= sizeY || k < 0 || k >= sizeZ) {
      throw new IndexOutOfBoundsException(
          "voxel lies outside: voxel="
              + i
              + ","
              + j
              + ","
              + k
              + " sizes="
              + sizeX
              + "x"
              + sizeY
              + "x"
              + sizeZ);
    }
    return brickIndex(i >> BRICK_SHIFT, j >> BRICK_SHIFT, k >> BRICK_SHIFT);
  }
}
