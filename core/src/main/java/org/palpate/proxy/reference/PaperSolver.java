package org.palpate.proxy.reference;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.LegPath;
import org.palpate.proxy.ProxySolver;
import org.palpate.raycast.RayCaster;

/**
 * The path finding of 2013 as printed, a baseline. It does not keep the guarantee, and it does not
 * come to rest on slopes: line 26 starts from infinity, so that the nearest border voxel is taken
 * even if it lies farther from the device than p.
 *
 * <p>Methods are named after the lines of the listing. Where the listing is open: the position of a
 * voxel is its centre; a step of line 20 does not pass the device; line 13 never moves back and
 * never to an end in a solid; all distances are metric, but one step and epsilon are in voxels; a
 * full {@link LegPath} ends the frame.
 *
 * <p>Haptic thread. Reference: Vlasov, Friese, Wolter 2013, section 4.2, the listing.
 */
public final class PaperSolver implements ProxySolver {
  /**
   * The epsilon of line 13: the distance before the collision point at which p stops, voxels. It is
   * the largest number below 1, so that p comes to the last free sample of a step of 1. With a
   * smaller one p stalls before it reaches the surface, because its stop lies in the solid, or it
   * creeps.
   */
  public static final double EPSILON_VOXELS = 1 - 0x1p-53;

  private final BorderVoxels border;
  private final ReferencePath p2;
  private double voxelX;
  private double voxelY;
  private double voxelZ;

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
    this.border = border;
    p2 = new ReferencePath(caster, metric, maxPathMm);
  }

  @Override
  public void reset() {
    border.forget();
  }

  @Override
  public void follow(CollisionScene scene, Vec3 device, InteractionPoint point) {
    p2.begin(scene, device, point); // lines 1 and 2, 4
    point.contact = false;
    boolean movedLast = true; // line 3
    while (!p2.isAtDevice() && p2.mayGoOn() && movedLast) { // line 5
      double lastX = p2.x; // line 6
      double lastY = p2.y;
      double lastZ = p2.z;
      if (!p2.meetsSolidBeforeDevice()) { // lines 7 and 8
        line9MoveToDevice();
        break;
      }
      point.contact = true;
      line13MoveBeforeCollision();
      line17FollowSurface();
      movedLast = p2.x != lastX || p2.y != lastY || p2.z != lastZ;
    }
    point.position.set(p2.x, p2.y, p2.z);
  }

  private void line9MoveToDevice() {
    p2.moveTowards(p2.deviceX, p2.deviceY, p2.deviceZ, false);
  }

  private void line13MoveBeforeCollision() {
    p2.moveBeforeCollision(EPSILON_VOXELS);
  }

  private void line17FollowSurface() {
    boolean moved = true;
    while (moved && p2.mayGoOn() && !p2.isAtDevice()) {
      boolean shorterStraight = p2.isFreeOneVoxelTowardsDevice(); // line 20
      if (shorterStraight || !line25SelectVoxel()) {
        return;
      }
      moved = line31MoveToVoxel();
    }
  }

  /**
   * Selects the border voxel around p that is nearest to the device, by lines 25 to 28; returns
   * false if there is none.
   */
  private boolean line25SelectVoxel() {
    int i = (int) Math.floor(p2.x);
    int j = (int) Math.floor(p2.y);
    int k = (int) Math.floor(p2.z);
    double leastSquared = Double.POSITIVE_INFINITY; // line 26
    for (int n = 0; n < 27; n++) {
      int x = i + n % 3 - 1;
      int y = j + n / 3 % 3 - 1;
      int z = k + n / 9 - 1;
      if (n != 13 && border.isBorder(p2.scene(), x, y, z)) {
        double squared = squaredToDevice(x + 0.5, y + 0.5, z + 0.5);
        if (squared < leastSquared) { // line 27
          leastSquared = squared;
          voxelX = x + 0.5;
          voxelY = y + 0.5;
          voxelZ = z + 0.5;
        }
      }
    }
    return leastSquared < Double.POSITIVE_INFINITY; // line 28
  }

  private double squaredToDevice(double x, double y, double z) {
    return p2.metric().squaredDistance(x, y, z, p2.deviceX, p2.deviceY, p2.deviceZ);
  }

  /** Moves to the selected voxel by lines 31 to 36; returns false if the step was cancelled. */
  private boolean line31MoveToVoxel() {
    return p2.moveToVoxel(voxelX, voxelY, voxelZ);
  }
}
