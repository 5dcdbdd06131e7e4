package org.palpate.proxy.reference;

import org.palpate.collision.CollisionScene;
import org.palpate.volume.BitCube;

/**
 * Empty-space border voxels that are calculated once and then cost one look-up each.
 *
 * <p>The unit of calculation is a brick of 4x4x4 voxels. A brick is calculated when a voxel of it
 * is first asked for after {@link #forget}, so that no frame has to calculate a whole volume, and
 * an edit costs only the bricks around the proxy.
 *
 * <p>Haptic thread; allocates nothing after construction. Memory: 3/16 byte a voxel. Cost: 28
 * {@link CollisionScene#window} calls for a new brick, else one look-up. Reference: Vlasov, Friese,
 * Wolter 2013, note 1, which calculates the whole volume beforehand.
 */
public final class PrecalculatedBorderVoxels implements BorderVoxels {
  /** Border voxels reach one voxel outside the grid: voxel i is kept as voxel i + 1. */
  private static final int RIM = 1;

  private final BitCube border;

  /** The generation in which each brick was calculated; a brick of an older one is unknown. */
  private final int[] generations;

  private int generation = 1;

  /**
   * Creates an instance that has calculated nothing yet.
   *
   * @param sizeX the size of the grid of the scene along x, voxels
   * @param sizeY the size along y, voxels
   * @param sizeZ the size along z, voxels
   */
  public PrecalculatedBorderVoxels(int sizeX, int sizeY, int sizeZ) {
    border = new BitCube(wholeBricks(sizeX), wholeBricks(sizeY), wholeBricks(sizeZ));
    generations = new int[border.bricksX() * border.bricksY() * border.bricksZ()];
  }

  private static int wholeBricks(int size) {
    return (size + 2 * RIM + 3) & ~3;
  }

  /** Whether voxel (i,j,k) is a border voxel; the scene is the same one until {@link #forget}. */
  @Override
  public boolean isBorder(CollisionScene scene, int i, int j, int k) {
    int x = i + RIM;
    int y = j + RIM;
    int z = k + RIM;
    if (x < 0
        || x >= border.sizeX()
        || y < 0
        || y >= border.sizeY()
        || z < 0
        || z >= border.sizeZ()) {
      return false;
    }
    int brick =
        (z >> 2) * border.bricksY() * border.bricksX() + (y >> 2) * border.bricksX() + (x >> 2);
    if (generations[brick] != generation) {
      generations[brick] = generation;
      calculateBrick(scene, x >> 2, y >> 2, z >> 2);
    }
    return border.get(x, y, z);
  }

  /** Calculates the bits of a brick: empty voxels in the union of the 27 shifted copies. */
  private void calculateBrick(CollisionScene scene, int brickX, int brickY, int brickZ) {
    int i = (brickX << 2) - RIM;
    int j = (brickY << 2) - RIM;
    int k = (brickZ << 2) - RIM;
    long near = 0;
    for (int n = 0; n < 27; n++) {
      near |= scene.window(i + n % 3 - 1, j + n / 3 % 3 - 1, k + n / 9 - 1);
    }
    border.setBrick(brickX, brickY, brickZ, near & ~scene.window(i, j, k));
  }

  @Override
  public void forget() {
    generation++;
  }
}
