package org.palpate.raycast;

import org.palpate.volume.BitCube;

/**
 * A method to find the first solid voxel of a bit cube on a ray.
 *
 * <p>An instance keeps scratch memory and belongs to one thread. A cast allocates nothing.
 */
public interface RayCaster {
  /**
   * Casts a ray through a bit cube. Voxels outside the cube are empty.
   *
   * @param bits the voxels
   * @param ray two points in grid coordinates, all finite; not changed
   * @param hit receives the hit if the answer is true; undefined after a miss
   * @return whether the ray meets a solid voxel by the rule of this caster
   */
  boolean cast(BitCube bits, Ray ray, RayHit hit);
}
