package org.palpate.benchmarks.baseline;

import org.palpate.raycast.Ray;
import org.palpate.raycast.RayCaster;
import org.palpate.raycast.RayHit;
import org.palpate.volume.BitCube;

/**
 * The plain baseline of collision: samples one voxel apart over a flat bit array, as in {@link
 * PlainBaseline}. It skips nothing, and reports {@code t} and the voxel of a hit.
 *
 * <p>Source: Vlasov et al. 2013, section 4.1 and figure 3.
 */
public final class PlainRayCaster implements RayCaster {
  private final FlatBits bits;

  /** Copies the voxels, which every cast uses. */
  public PlainRayCaster(BitCube cube) {
    bits = new FlatBits(cube);
  }

  @Override
  public boolean cast(BitCube ignored, Ray ray, RayHit hit) {
    double dx = ray.toX - ray.fromX;
    double dy = ray.toY - ray.fromY;
    double dz = ray.toZ - ray.fromZ;
    double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
    for (double at = 0; at < length; at++) {
      double t = at / length;
      if (sample(ray.fromX + t * dx, ray.fromY + t * dy, ray.fromZ + t * dz, t, hit)) {
        return true;
      }
    }
    return sample(ray.toX, ray.toY, ray.toZ, 1, hit);
  }

  private boolean sample(double x, double y, double z, double t, RayHit hit) {
    int i = (int) Math.floor(x);
    int j = (int) Math.floor(y);
    int k = (int) Math.floor(z);
    if (!bits.solid(i, j, k)) {
      return false;
    }
    hit.set(t, i, j, k, RayHit.NO_AXIS);
    return true;
  }
}
