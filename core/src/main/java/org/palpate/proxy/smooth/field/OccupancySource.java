package org.palpate.proxy.smooth.field;

import org.palpate.collision.CollisionScene;

/**
 * A source of the occupancies of cells, whole numbers from 0 to {@link GreyOccupancyCache#WHOLE}.
 */
interface OccupancySource {
  /**
   * Returns the occupancies of the cells from (8 word, j, k) on along x, a byte each, the first in
   * the lowest byte.
   *
   * @param scene the same one since {@link #forget}
   */
  long occupancies(CollisionScene scene, int word, int j, int k);

  /** Forgets all cached occupancies. */
  void forget();
}
