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
 * come to rest on slopes: line 26 starts from infinity, so the nearest border voxel is taken even
 * where it lies farther from the device than p.
 *
 * <p>Methods are named after the lines of the listing. Where the listing leaves room: a voxel's
 * place is its centre; a step of line 20 does not go past the device; line 13 never moves back and
 * never to an end in a solid; all distances are metric, but one step and epsilon are in voxels; a
 * full {@link LegPath} ends the frame.
 *
 * <p>Source: Vlasov, Friese, Wolter 2013, section 4.2, the listing.
 */
public final class PaperSolver implements ProxySolver {
  /**
   * Line 13's epsilon: so far before the collision point p stops, voxels. The largest number below
   * 1: p comes to the last free sample of a step of 1. A smaller one lets p stall away from the
   * surface, its stop being in the solid, or creep towards it.
   */
  public static final double EPSILON_VOXELS = 1 - 0x1p-53;

  private final BorderVoxels border;
  private final ReferencePath p2;
  private double voxelX;
  private double voxelY;
  private double voxelZ;

  /**
   * A solver that keeps scratch.
   *
   * @param caster the collision test; the paper's is sampled with a step of 1
   * @param maxPathMm w_max, the most that p may travel in one frame
   * @param border on the fly or precalculated
   */
  public PaperSolver(RayCaster caster, GridMetric metric, double maxPathMm, BorderVoxels border) {
    this.border = border;
    p2 = new ReferencePath(caster, metric, maxPathMm);
  }

  @Override
  public void follow(CollisionScene obstacles, Vec3 device, InteractionPoint point) {
    p2.begin(obstacles, device, point); // lines 1 and 2, 4
    point.contact = false;
    boolean movedLast = true; // line 3
    while (!p2.isAtDevice() && p2.mayGoOn() && movedLast) { // line 5
      double lastX = p2.x; // line 6
      double lastY = p2.y;
      double lastZ = p2.z;
      if (!p2.meetsSolidOnWayToDevice()) { // lines 7 and 8
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
    while (p2.mayGoOn() && !p2.isAtDevice()) {
      boolean shorterStraight = p2.isFreeOneVoxelTowardsDevice(); // line 20
      if (shorterStraight || !line25SelectVoxel() || !line31MoveToVoxel()) {
        return;
      }
    }
  }

  /** Lines 25 to 28: the border voxel round p nearest to the device; false where there is none. */
  private boolean line25SelectVoxel() {
    int i = (int) Math.floor(p2.x);
    int j = (int) Math.floor(p2.y);
    int k = (int) Math.floor(p2.z);
    double leastSquared = Double.POSITIVE_INFINITY; // line 26
    for (int n = 0; n < 27; n++) {
      int x = i + n % 3 - 1;
      int y = j + n / 3 % 3 - 1;
      int z = k + n / 9 - 1;
      if (n != 13 && border.isBorder(p2.obstacles(), x, y, z)) {
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

  /** Lines 31 to 36: false where the step was cancelled. */
  private boolean line31MoveToVoxel() {
    return p2.moveToVoxel(voxelX, voxelY, voxelZ);
  }
}
