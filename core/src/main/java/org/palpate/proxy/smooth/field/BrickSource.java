package org.palpate.proxy.smooth.field;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.IntBox;

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

        @Override
        public void forget(IntBox changed) {}
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

  /**
   * Whether some cells of a brick are all solid. A source that makes its bricks makes this one only
   * if it cannot answer without it.
   *
   * @param cells the cells, in the order of the word of a brick
   */
  default boolean areSolid(CollisionScene scene, int x, int y, int z, long cells) {
    return (~brick(scene, x, y, z) & cells) == 0;
  }

  /**
   * Returns how many columns were interpolated so far between slices to make bricks; 0 if the
   * source makes none. Bricks that are still cached take no such work.
   */
  default long columns() {
    return 0;
  }

  /** Forgets all cached bits. */
  void forget();

  /**
   * Forgets the cached bits that depend on changed voxels.
   *
   * @param changed the voxels of the scene; receives the cells of this source that they may change
   */
  void forget(IntBox changed);

  /**
   * The voxels of a scene. Bricks outside the bounds of the scene are empty, so they are not looked
   * up in its objects.
   */
  final class BoundedVoxels implements BrickSource {
    private final IntBox bounds = new IntBox();

    /** Whether the bounds were read since {@link #forget}. */
    private boolean isKnown;

    @Override
    public long brick(CollisionScene scene, int x, int y, int z) {
      if (!isKnown) {
        scene.bounds(bounds);
        isKnown = true;
      }
      boolean inBounds =
          x >= bounds.lowX >> 2
              && x <= bounds.highX >> 2
              && y >= bounds.lowY >> 2
              && y <= bounds.highY >> 2
              && z >= bounds.lowZ >> 2
              && z <= bounds.highZ >> 2;
      return inBounds ? scene.brick(x, y, z) : 0;
    }

    @Override
    public void forget() {
      isKnown = false;
    }

    @Override
    public void forget(IntBox changed) {
      isKnown = false;
    }
  }
}
