package org.palpate.proxy.reference;

import org.palpate.collision.CollisionScene;

/**
 * Decides whether a voxel is an empty-space border voxel: empty, with a solid voxel among its 26
 * neighbours. Voxels outside the grid count too. Haptic thread.
 *
 * <p>Reference: Vlasov, Friese, Wolter 2013, section 4.2.
 */
public interface BorderVoxels {

  /**
   * {@return whether a voxel is an empty-space border voxel of the scene}
   *
   * @param scene the solids
   * @param i the voxel's number along x
   * @param j its number along y
   * @param k its number along z
   */
  boolean isBorder(CollisionScene scene, int i, int j, int k);

  /** Forgets what is kept about the solids, because they may have changed. */
  default void forget() {}

  /** {@return the method that reads the neighbours at each call, by up to 28 look-ups} */
  static BorderVoxels onTheFly() {
    return BorderVoxels::hasSolidNeighbour;
  }

  private static boolean hasSolidNeighbour(CollisionScene scene, int i, int j, int k) {
    if (scene.isSolid(i, j, k)) {
      return false;
    }
    for (int z = k - 1; z <= k + 1; z++) {
      for (int y = j - 1; y <= j + 1; y++) {
        for (int x = i - 1; x <= i + 1; x++) {
          if (scene.isSolid(x, y, z)) {
            return true;
          }
        }
      }
    }
    return false;
  }
}
