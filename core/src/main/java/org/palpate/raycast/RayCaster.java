package org.palpate.raycast;

import org.palpate.volume.BitCube;

/**
 * A way to find where a ray first meets a solid voxel of a bit cube. Keeps scratch: one thread an
 * instance.
 */
public interface RayCaster {
  /**
   * Casts a ray.
   *
   * @param bits the voxels; outside them all is empty
   * @param ray six finite doubles in grid coordinates
   * @param hit filled where the answer is true
   * @return whether the ray meets a solid voxel, as this caster understands it
   */
  boolean cast(BitCube bits, Ray ray, RayHit hit);
}
