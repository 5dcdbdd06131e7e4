package org.palpate.proxy.smooth.field;

import org.palpate.collision.CollisionScene;

/** A source of the bits of a window, in bricks of 4x4x4 cells. */
interface BrickSource {
  /** The voxels of the scene as they are. */
  BrickSource VOXELS =
      new BrickSource() {
        @Override
        public long brick(CollisionScene scene, int x, int y, int z) {
          return scene.brick(x, y, z);
        }

        @Override
        public void forget() {}
      };

  /**
   * Returns the solid cells of a brick as the bits of a word, in the order of {@link
   * CollisionScene#brick}.
   *
   * @param scene the same one since {@link #forget}
   * @param x brick coordinates: cell coordinates over 4, rounded down
   */
  long brick(CollisionScene scene, int x, int y, int z);

  /** Whether a cell is solid. */
  default boolean isSolid(CollisionScene scene, int x, int y, int z) {
    long brick = brick(scene, x >> 2, y >> 2, z >> 2);
    return (brick >>> ((z & 3) << 4 | (y & 3) << 2 | (x & 3)) & 1) != 0;
  }

  /** Forgets all cached bits. */
  void forget();
}
