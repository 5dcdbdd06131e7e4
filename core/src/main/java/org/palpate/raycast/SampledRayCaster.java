package org.palpate.raycast;

import org.palpate.volume.BitCube;

/**
 * Samples the voxels at a fixed step along the ray, from its start to its end, both included. A
 * baseline: it misses a solid that lies between two samples.
 *
 * <p>A sample belongs to the voxel of its rounded-down coordinates. The hit lies at the sample that
 * found it. Coordinates may be as large as 1e100. Cost: one look-up a step inside the box of the
 * solid voxels, and none outside.
 *
 * <p>Reference: Vlasov, Friese, Wolter 2013, section 4.1 and figure 3, with a step of 1 voxel.
 */
public final class SampledRayCaster implements RayCaster {
  private final double stepVoxels;
  private final RayClip clip = new RayClip();

  /**
   * Creates a caster.
   *
   * @param stepVoxels the distance between two samples in grid coordinates; the paper's is 1
   * @throws IllegalArgumentException if the step is not positive and finite
   */
  public SampledRayCaster(double stepVoxels) {
    if (!(stepVoxels > 0) || stepVoxels == Double.POSITIVE_INFINITY) {
      throw new IllegalArgumentException(
          "step must be positive and finite: stepVoxels=" + stepVoxels);
    }
    this.stepVoxels = stepVoxels;
  }

  @Override
  public boolean cast(BitCube bits, Ray ray, RayHit hit) {
    if (!clip.clip(ray, bits.bounds())) {
      return false;
    }
    double dx = ray.toX - ray.fromX;
    double dy = ray.toY - ray.fromY;
    double dz = ray.toZ - ray.fromZ;
    double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
    double lastAt = clip.to * length;
    // Beyond 2^53 steps the next number is the next double, so that even there the samples go on.
    for (double n = Math.floor(clip.from * length / stepVoxels);
        ;
        n = Math.max(n + 1, Math.nextUp(n))) {
      double at = n * stepVoxels;
      if (at >= length) {
        return sample(bits, ray.toX, ray.toY, ray.toZ, 1, hit);
      }
      double t = at / length;
      if (sample(bits, ray.fromX + t * dx, ray.fromY + t * dy, ray.fromZ + t * dz, t, hit)) {
        return true;
      }
      if (at > lastAt) {
        return false;
      }
    }
  }

  /** Whether the voxel under a sample is solid; if so, writes the hit. */
  static boolean sample(BitCube bits, double x, double y, double z, double t, RayHit hit) {
    int i = (int) Math.floor(x);
    int j = (int) Math.floor(y);
    int k = (int) Math.floor(z);
    if (!bits.get(i, j, k)) {
      return false;
    }
    hit.set(t, i, j, k, RayHit.NO_AXIS);
    return true;
  }
}
