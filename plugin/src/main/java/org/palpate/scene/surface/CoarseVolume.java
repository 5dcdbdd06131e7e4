package org.palpate.scene.surface;

import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;

/**
 * A copy of a bit cube at a half or a quarter of its resolution, for the first picture and for
 * large meshes.
 *
 * <p>A coarse voxel is solid if any of its voxels is, so that thin bone does not vanish. The number
 * of its solid voxels determines the position of the surface. {@link #update} applies changes.
 */
public final class CoarseVolume implements EdgeCrossings {
  // Keeps the two sides of an almost empty coarse voxel apart.
  private static final float MIN_FRACTION = 0.05f;

  private static final int BRICK = BitCube.BRICK_SHIFT;

  private final BitCube fine;
  private final int shift;
  private final BitCube bits;
  private final int factor;
  private final byte[] fullness;

  private CoarseVolume(BitCube fine, int shift) {
    this.fine = fine;
    this.shift = shift;
    factor = 1 << shift;
    bits = new BitCube(shrunk(fine.sizeX()), shrunk(fine.sizeY()), shrunk(fine.sizeZ()));
    fullness =
        new byte[Math.multiplyExact(Math.multiplyExact(bits.sizeX(), bits.sizeY()), bits.sizeZ())];
    IntBox all = new IntBox();
    all.include(0, 0, 0);
    all.include(fine.sizeX() - 1, fine.sizeY() - 1, fine.sizeZ() - 1);
    update(all);
  }

  /**
   * Returns a coarser copy of a cube.
   *
   * @param shift 1 for half the resolution, 2 for a quarter
   * @throws IllegalArgumentException if {@code shift} is neither
   */
  public static CoarseVolume of(BitCube fine, int shift) {
    if (shift < 1 || shift > 2) {
      throw new IllegalArgumentException("shift must be 1 or 2: shift=" + shift);
    }
    return new CoarseVolume(fine, shift);
  }

  /**
   * Returns the source of its surface. Positions are grid mm of the fine cube.
   *
   * @param fineSpacingMm edge lengths of a fine voxel
   */
  public SurfaceSource source(Vec3 fineSpacingMm) {
    return new SurfaceSource(bits, this, fineSpacingMm.mul(factor, new Vec3()), 2);
  }

  private int shrunk(int size) {
    return (size + factor - 1) / factor;
  }

  /**
   * Applies changes of the fine cube. One thread at a time; a surface that is being built meanwhile
   * must be built again.
   *
   * @param voxels a box around the changed voxels of the fine cube; nothing may have changed
   *     outside it
   */
  public void update(IntBox voxels) {
    if (voxels.isEmpty()) {
      return;
    }
    for (int z = Math.max(0, voxels.lowZ >> BRICK);
        z <= highBrick(voxels.highZ, fine.sizeZ());
        z++) {
      for (int y = Math.max(0, voxels.lowY >> BRICK);
          y <= highBrick(voxels.highY, fine.sizeY());
          y++) {
        for (int x = Math.max(0, voxels.lowX >> BRICK);
            x <= highBrick(voxels.highX, fine.sizeX());
            x++) {
          updateBrick(x, y, z);
        }
      }
    }
  }

  private static int highBrick(int high, int size) {
    return Math.min(high, size - 1) >> BRICK;
  }

  private void updateBrick(int brickX, int brickY, int brickZ) {
    long word = fine.brick(brickX, brickY, brickZ);
    int perBrick = 4 >> shift;
    for (int part = 0; part < perBrick * perBrick * perBrick; part++) {
      int i = part % perBrick;
      int j = part / perBrick % perBrick;
      int k = part / perBrick / perBrick;
      long solidBits = word & (mask() << BitCube.bit(i * factor, j * factor, k * factor));
      setVoxel(brickX * perBrick + i, brickY * perBrick + j, brickZ * perBrick + k, solidBits);
    }
  }

  private void setVoxel(int i, int j, int k, long solidBits) {
    if (solidBits != 0) {
      bits.set(i, j, k);
      fullness[index(i, j, k)] = (byte) Long.bitCount(solidBits);
    } else if (bits.get(i, j, k)) {
      bits.clear(i, j, k);
      fullness[index(i, j, k)] = 0;
    }
  }

  /** Converts a box of the fine cube's voxels to coarse voxels, in {@code dest}. */
  public IntBox toCoarse(IntBox fineVoxels, IntBox dest) {
    dest.set(fineVoxels);
    if (!fineVoxels.isEmpty()) {
      dest.lowX >>= shift;
      dest.lowY >>= shift;
      dest.lowZ >>= shift;
      dest.highX >>= shift;
      dest.highY >>= shift;
      dest.highZ >>= shift;
    }
    return dest;
  }

  /** Returns the bits of a brick's first coarse voxel. */
  private long mask() {
    // 2x2x2 voxels are two of x, two of y (4 bits on), two of z (16 bits on); 4x4x4 are all.
    return factor == 2 ? 0x0033_0033L : -1L;
  }

  private int index(int i, int j, int k) {
    return (k * bits.sizeY() + j) * bits.sizeX() + i;
  }

  /**
   * Returns the crossing: at the face of a full coarse voxel, nearer to the middle of an emptier
   * one.
   */
  @Override
  public float fraction(int i, int j, int k, int axis) {
    boolean lowIsSolid = bits.get(i, j, k);
    int solidX = i + (axis == 0 && !lowIsSolid ? 1 : 0);
    int solidY = j + (axis == 1 && !lowIsSolid ? 1 : 0);
    int solidZ = k + (axis == 2 && !lowIsSolid ? 1 : 0);
    if (!isInside(solidX, solidY, solidZ)) {
      return 0.5f; // an edit emptied the voxel meanwhile; the brick is built again
    }
    float full = (float) fullness[index(solidX, solidY, solidZ)] / (factor * factor * factor);
    float fromSolid = Math.max(MIN_FRACTION, full - 0.5f);
    return lowIsSolid ? fromSolid : 1 - fromSolid;
  }

  private boolean isInside(int i, int j, int k) {
    return i >= 0 && j >= 0 && k >= 0 && i < bits.sizeX() && j < bits.sizeY() && k < bits.sizeZ();
  }
}
