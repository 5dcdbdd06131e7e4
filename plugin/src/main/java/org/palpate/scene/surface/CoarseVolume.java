package org.palpate.scene.surface;

import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;

/**
 * A cube at half, a quarter, an eighth of its resolution, for the first picture and for large
 * meshes: a coarse voxel is solid where any of its voxels is, so thin bone does not vanish, and how
 * many are tells where the surface runs.
 */
public final class CoarseVolume implements Crossings {
  // Less full than this, a coarse voxel still keeps its two walls apart.
  private static final float MIN_FRACTION = 0.05f;

  private final BitCube bits;
  private final int factor;
  private final byte[] fullness;

  private CoarseVolume(BitCube fine, int shift) {
    factor = 1 << shift;
    bits = new BitCube(shrunk(fine.sizeX()), shrunk(fine.sizeY()), shrunk(fine.sizeZ()));
    fullness =
        new byte[Math.multiplyExact(Math.multiplyExact(bits.sizeX(), bits.sizeY()), bits.sizeZ())];
    fill(fine, shift);
  }

  /**
   * What the surface of a cube is made from at a coarser level; its positions are the fine cube's
   * grid millimetres.
   *
   * @param shift 1 for half the resolution, 2 for a quarter; more than 2 is refused
   */
  public static SurfaceSource source(BitCube fine, int shift, Vec3 spacingMm) {
    if (shift < 1 || shift > 2) {
      throw new IllegalArgumentException("shift must be 1 or 2: shift=" + shift);
    }
    CoarseVolume coarse = new CoarseVolume(fine, shift);
    Vec3 spacing = spacingMm.mul(coarse.factor, new Vec3());
    return new SurfaceSource(coarse.bits, coarse, spacing, 2);
  }

  private int shrunk(int size) {
    return (size + factor - 1) / factor;
  }

  private void fill(BitCube fine, int shift) {
    int perBrick = 4 >> shift;
    for (int z = 0; z < fine.bricksZ(); z++) {
      for (int y = 0; y < fine.bricksY(); y++) {
        for (int x = 0; x < fine.bricksX(); x++) {
          long word = fine.brick(x, y, z);
          if (word != 0) {
            fillBrick(word, perBrick, x * perBrick, y * perBrick, z * perBrick);
          }
        }
      }
    }
  }

  private void fillBrick(long word, int perBrick, int x, int y, int z) {
    for (int part = 0; part < perBrick * perBrick * perBrick; part++) {
      int i = part % perBrick;
      int j = part / perBrick % perBrick;
      int k = part / perBrick / perBrick;
      long share = word & (mask() << BitCube.bit(i * factor, j * factor, k * factor));
      if (share != 0) {
        bits.set(x + i, y + j, z + k);
        fullness[index(x + i, y + j, z + k)] = (byte) Long.bitCount(share);
      }
    }
  }

  /** The voxels of a brick's first coarse voxel. */
  private long mask() {
    // 2x2x2 voxels are two of x, two of y (4 bits on), two of z (16 bits on); 4x4x4 are all.
    return factor == 2 ? 0x0033_0033L : -1L;
  }

  private int index(int i, int j, int k) {
    return (k * bits.sizeY() + j) * bits.sizeX() + i;
  }

  /** A full voxel ends at its face, half way; an emptier one nearer to its middle. */
  @Override
  public float fraction(int i, int j, int k, int axis) {
    boolean lowIsSolid = bits.get(i, j, k);
    int solidX = i + (axis == 0 && !lowIsSolid ? 1 : 0);
    int solidY = j + (axis == 1 && !lowIsSolid ? 1 : 0);
    int solidZ = k + (axis == 2 && !lowIsSolid ? 1 : 0);
    float full = (float) fullness[index(solidX, solidY, solidZ)] / (factor * factor * factor);
    float fromSolid = Math.max(MIN_FRACTION, full - 0.5f);
    return lowIsSolid ? fromSolid : 1 - fromSolid;
  }
}
