package org.palpate.proxy.reference;

import org.palpate.geometry.GridMetric;
import org.palpate.raycast.RayCaster;

/**
 * The path finding of 2013 as printed, a baseline. It does not keep the guarantee, and it does not
 * come to rest on slopes: line 26 starts from infinity, so that the nearest border voxel is taken
 * even if it lies farther from the device than p.
 *
 * <p>Where the listing is open, beyond {@link ReferenceSolver}: a step of line 20 does not pass the
 * device; line 13 never moves back and never to an end in a solid.
 *
 * <p>Haptic thread. Reference: Vlasov, Friese, Wolter 2013, section 4.2, the listing.
 */
public final class PaperSolver extends ReferenceSolver {
  /**
   * Creates a solver.
   *
   * @param caster the collision test; the paper samples with a step of 1
   * @param metric the spacing of the grid
   * @param maxPathMm the longest path of one frame, w_max, positive
   * @param border the border voxels; the solver tells it when the solids may have changed
   * @throws IllegalArgumentException if {@code maxPathMm} is not positive
   */
  public PaperSolver(RayCaster caster, GridMetric metric, double maxPathMm, BorderVoxels border) {
    super(caster, metric, maxPathMm, border);
  }

  @Override
  void followSurface() {
    boolean moved = true;
    while (moved && p2.mayGoOn() && !p2.isAtDevice()) {
      boolean shorterStraight = p2.isFreeOneVoxelTowardsDevice(); // line 20
      if (shorterStraight || !selectVoxel(Double.NEGATIVE_INFINITY)) { // lines 25 to 28
        return;
      }
      moved = moveToVoxel(); // lines 31 to 36
    }
  }

  /** Returns the negative square of the distance to the device, which line 27 compares. */
  @Override
  double merit(double x, double y, double z) {
    return -p2.metric().squaredDistance(x, y, z, p2.deviceX, p2.deviceY, p2.deviceZ);
  }
}
