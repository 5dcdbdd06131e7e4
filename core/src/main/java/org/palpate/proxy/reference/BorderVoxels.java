package org.palpate.proxy.reference;

import org.palpate.collision.CollisionScene;

/**
 * Tells empty-space border voxels: empty, with a solid voxel among their 26 neighbours. Those
 * outside the grid count too.
 *
 * <p>Source: Vlasov, Friese, Wolter 2013, section 4.2.
 */
public interface BorderVoxels {

  /** Whether voxel (i,j,k) is an empty-space border voxel of the frame's obstacles. */
  boolean isBorder(CollisionScene obstacles, int i, int j, int k);

  /** Looks at the neighbours each time: up to 27 look-ups, and nothing that an edit would spoil. */
  static BorderVoxels onTheFly() {
    return BorderVoxels::hasSolidNeighbour;
  }

  private static boolean hasSolidNeighbour(CollisionScene obstacles, int i, int j, int k) {
    if (obstacles.isSolid(i, j, k)) {
      return false;
    }
    for (int z = k - 1; z <= k + 1; z++) {
      for (int y = j - 1; y <= j + 1; y++) {
        for (int x = i - 1; x <= i + 1; x++) {
          if (obstacles.isSolid(x, y, z)) {
            return true;
          }
        }
      }
    }
    return false;
  }
}
