package org.palpate.raycast;

import org.palpate.volume.BitCube;

/**
 * Samples once between each two consecutive crossings of the ray with grid planes, half way between
 * them, and once at the end of the ray. A baseline: it passes through edges and corners that solids
 * share, and rounding decides near them.
 *
 * <p>The hit lies at the sample that found it. Coordinates may be as large as 1e100. Cost: one
 * look-up for each plane crossed inside the box of the solid voxels, and none outside.
 *
 * <p>Reference: Vlasov, Friese, Wolter 2013, section 4.1, the proposal for higher precision.
 */
public final class GridPlanesRayCaster implements RayCaster {
  private final RayClip clip = new RayClip();
  private final PlaneCrossings crossingsX = new PlaneCrossings();
  private final PlaneCrossings crossingsY = new PlaneCrossings();
  private final PlaneCrossings crossingsZ = new PlaneCrossings();

  @Override
  public boolean cast(BitCube bits, Ray ray, RayHit hit) {
    if (!clip.clip(ray, bits.bounds())) {
      return false;
    }
    crossingsX.start(ray.fromX, ray.toX - ray.fromX, clip.from);
    crossingsY.start(ray.fromY, ray.toY - ray.fromY, clip.from);
    crossingsZ.start(ray.fromZ, ray.toZ - ray.fromZ, clip.from);
    double last = clip.from;
    while (last < 1 && last <= clip.to) {
      double next = Math.min(Math.min(crossingsX.t, crossingsY.t), Math.min(crossingsZ.t, 1));
      if (next > last && sampleAt(bits, ray, (last + next) / 2, hit)) {
        return true;
      }
      last = next;
      crossingsX.passUpTo(last);
      crossingsY.passUpTo(last);
      crossingsZ.passUpTo(last);
    }
    return SampledRayCaster.sample(bits, ray.toX, ray.toY, ray.toZ, 1, hit);
  }

  private static boolean sampleAt(BitCube bits, Ray ray, double t, RayHit hit) {
    double x = ray.fromX + t * (ray.toX - ray.fromX);
    double y = ray.fromY + t * (ray.toY - ray.fromY);
    double z = ray.fromZ + t * (ray.toZ - ray.fromZ);
    return SampledRayCaster.sample(bits, x, y, z, t, hit);
  }

  /** The crossings of the ray with the grid planes of one axis, in order. */
  private static final class PlaneCrossings {
    private double from;
    private double delta;
    private double plane;

    /** The ray parameter of the next crossing; infinite if there is none. */
    private double t;

    void start(double newFrom, double newDelta, double after) {
      from = newFrom;
      delta = newDelta;
      double at = from + after * delta;
      plane = delta > 0 ? Math.floor(at) - 1 : Math.ceil(at) + 1;
      t = delta == 0 ? Double.POSITIVE_INFINITY : (plane - from) / delta;
      passUpTo(after);
    }

    void passUpTo(double reached) {
      while (t <= reached && t < 1) {
        plane += delta > 0 ? 1 : -1;
        t = (plane - from) / delta;
      }
    }
  }
}
