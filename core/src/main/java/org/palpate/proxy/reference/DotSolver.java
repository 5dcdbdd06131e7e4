package org.palpate.proxy.reference;

import org.palpate.geometry.GridMetric;
import org.palpate.raycast.RayCaster;

/**
 * The method of 2012 as the paper of 2013 describes it, a baseline: of the border voxels around p
 * it takes the one farthest in the direction of the device. It does not keep the guarantee, and it
 * oscillates around the point closest to the device, as the paper reports.
 *
 * <p>Where the description is open, beyond {@link ReferenceSolver}: a motion is cut off where w_max
 * ends; dot products are metric.
 *
 * <p>Haptic thread. Reference: Vlasov, Friese, Wolter 2013, section 4.2, steps 1 to 4.
 */
public final class DotSolver extends ReferenceSolver {
  /**
   * Creates a solver.
   *
   * @param caster the collision test; the paper samples with a step of 1
   * @param metric the spacing of the grid
   * @param maxPathMm the longest path of one frame, w_max, positive
   * @param border the border voxels; the solver tells it when the solids may have changed
   * @throws IllegalArgumentException if {@code maxPathMm} is not positive
   */
  public DotSolver(RayCaster caster, GridMetric metric, double maxPathMm, BorderVoxels border) {
    super(caster, metric, maxPathMm, border);
  }

  @Override
  void followSurface() {
    boolean moved = true;
    while (moved && !p2.isAtDevice() && p2.mayGoOn() && !p2.isFreeOneVoxelTowardsDevice()) {
      if (!selectVoxel(0)) { // steps 3a and 3b: it must lie ahead
        return;
      }
      moved = moveToVoxel(); // step 3c
    }
  }

  /** Returns the dot product with the direction to the device. */
  @Override
  double merit(double x, double y, double z) {
    GridMetric metric = p2.metric();
    double sx = metric.spacingX() * metric.spacingX();
    double sy = metric.spacingY() * metric.spacingY();
    double sz = metric.spacingZ() * metric.spacingZ();
    return (x - p2.x) * (p2.deviceX - p2.x) * sx
        + (y - p2.y) * (p2.deviceY - p2.y) * sy
        + (z - p2.z) * (p2.deviceZ - p2.z) * sz;
  }
}
