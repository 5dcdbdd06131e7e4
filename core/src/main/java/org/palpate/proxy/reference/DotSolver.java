package org.palpate.proxy.reference;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.LegPath;
import org.palpate.proxy.ProxySolver;
import org.palpate.raycast.RayCaster;

/**
 * The method of 2012 as the paper of 2013 tells it, a baseline: of the border voxels round p it
 * takes the one farthest along the way to the device. It does not keep the guarantee, and it
 * oscillates round the point nearest to the device, as the paper says.
 *
 * <p>Methods are named after its steps. Where the telling leaves room: a voxel's place is its
 * centre; a move is cut off where w_max ends; dot products and lengths are metric, but one step and
 * epsilon are in voxels; a full {@link LegPath} ends the frame.
 *
 * <p>Source: Vlasov, Friese, Wolter 2013, section 4.2, steps 1 to 4.
 */
public final class DotSolver implements ProxySolver {
  /**
   * Step 2's epsilon: so far before the collision point p stops, voxels. The largest number below
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
  public DotSolver(RayCaster caster, GridMetric metric, double maxPathMm, BorderVoxels border) {
    this.border = border;
    p2 = new ReferencePath(caster, metric, maxPathMm);
  }

  @Override
  public void follow(CollisionScene obstacles, Vec3 device, InteractionPoint point) {
    p2.begin(obstacles, device, point); // step 1
    point.contact = false;
    boolean moved = true;
    while (!p2.isAtDevice() && p2.mayGoOn() && moved) { // step 4
      double lastX = p2.x;
      double lastY = p2.y;
      double lastZ = p2.z;
      if (!p2.meetsSolidOnWayToDevice()) { // step 2
        p2.moveTowards(p2.deviceX, p2.deviceY, p2.deviceZ, false);
        break;
      }
      point.contact = true;
      p2.moveBeforeCollision(EPSILON_VOXELS);
      step3FollowSurface();
      moved = p2.x != lastX || p2.y != lastY || p2.z != lastZ;
    }
    point.position.set(p2.x, p2.y, p2.z);
  }

  private void step3FollowSurface() {
    while (!p2.isAtDevice() && p2.mayGoOn() && !p2.isFreeOneVoxelTowardsDevice()) {
      if (!step3bSelectVoxel() || !step3cMoveToVoxel()) {
        return;
      }
    }
  }

  /** Steps 3a and 3b: false where no border voxel lies ahead. */
  private boolean step3bSelectVoxel() {
    int i = (int) Math.floor(p2.x);
    int j = (int) Math.floor(p2.y);
    int k = (int) Math.floor(p2.z);
    double greatest = 0;
    for (int n = 0; n < 27; n++) {
      int x = i + n % 3 - 1;
      int y = j + n / 3 % 3 - 1;
      int z = k + n / 9 - 1;
      if (n != 13 && border.isBorder(p2.obstacles(), x, y, z)) {
        double dot = dotWithWayToDevice(x + 0.5, y + 0.5, z + 0.5);
        if (dot > greatest) {
          greatest = dot;
          voxelX = x + 0.5;
          voxelY = y + 0.5;
          voxelZ = z + 0.5;
        }
      }
    }
    return greatest > 0;
  }

  private double dotWithWayToDevice(double x, double y, double z) {
    GridMetric metric = p2.metric();
    double sx = metric.spacingX() * metric.spacingX();
    double sy = metric.spacingY() * metric.spacingY();
    double sz = metric.spacingZ() * metric.spacingZ();
    return (x - p2.x) * (p2.deviceX - p2.x) * sx
        + (y - p2.y) * (p2.deviceY - p2.y) * sy
        + (z - p2.z) * (p2.deviceZ - p2.z) * sz;
  }

  /** Step 3c: false where the move was cancelled. */
  private boolean step3cMoveToVoxel() {
    return p2.moveToVoxel(voxelX, voxelY, voxelZ);
  }
}
