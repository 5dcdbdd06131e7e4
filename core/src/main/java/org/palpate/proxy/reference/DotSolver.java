package org.palpate.proxy.reference;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.LegPath;
import org.palpate.proxy.ProxySolver;
import org.palpate.raycast.RayCaster;

/**
 * The method of 2012 as the paper of 2013 describes it, a baseline: of the border voxels around p
 * it takes the one farthest in the direction of the device. It does not keep the guarantee, and it
 * oscillates around the point closest to the device, as the paper reports.
 *
 * <p>Methods are named after the steps of the description. Where the description is open: the
 * position of a voxel is its centre; a motion is cut off where w_max ends; dot products and lengths
 * are metric, but one step and epsilon are in voxels; a full {@link LegPath} ends the frame.
 *
 * <p>Haptic thread. Reference: Vlasov, Friese, Wolter 2013, section 4.2, steps 1 to 4.
 */
public final class DotSolver implements ProxySolver {
  /**
   * The epsilon of step 2: the distance before the collision point at which p stops, voxels. It is
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
  public DotSolver(RayCaster caster, GridMetric metric, double maxPathMm, BorderVoxels border) {
    this.border = border;
    p2 = new ReferencePath(caster, metric, maxPathMm);
  }

  @Override
  public void reset() {
    border.forget();
  }

  @Override
  public void follow(CollisionScene scene, Vec3 device, InteractionPoint point) {
    p2.begin(scene, device, point); // step 1
    point.contact = false;
    boolean moved = true;
    while (!p2.isAtDevice() && p2.mayGoOn() && moved) { // step 4
      double lastX = p2.x;
      double lastY = p2.y;
      double lastZ = p2.z;
      if (!p2.meetsSolidBeforeDevice()) { // step 2
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
    boolean moved = true;
    while (moved && !p2.isAtDevice() && p2.mayGoOn() && !p2.isFreeOneVoxelTowardsDevice()) {
      if (!step3bSelectVoxel()) {
        return;
      }
      moved = step3cMoveToVoxel();
    }
  }

  /** Selects a voxel by steps 3a and 3b; returns false if no border voxel lies ahead. */
  private boolean step3bSelectVoxel() {
    int i = (int) Math.floor(p2.x);
    int j = (int) Math.floor(p2.y);
    int k = (int) Math.floor(p2.z);
    double greatest = 0;
    for (int n = 0; n < 27; n++) {
      int x = i + n % 3 - 1;
      int y = j + n / 3 % 3 - 1;
      int z = k + n / 9 - 1;
      if (n != 13 && border.isBorder(p2.scene(), x, y, z)) {
        double dot = dotWithDirectionToDevice(x + 0.5, y + 0.5, z + 0.5);
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

  private double dotWithDirectionToDevice(double x, double y, double z) {
    GridMetric metric = p2.metric();
    double sx = metric.spacingX() * metric.spacingX();
    double sy = metric.spacingY() * metric.spacingY();
    double sz = metric.spacingZ() * metric.spacingZ();
    return (x - p2.x) * (p2.deviceX - p2.x) * sx
        + (y - p2.y) * (p2.deviceY - p2.y) * sy
        + (z - p2.z) * (p2.deviceZ - p2.z) * sz;
  }

  /** Moves to the selected voxel by step 3c; returns false if the motion was cancelled. */
  private boolean step3cMoveToVoxel() {
    return p2.moveToVoxel(voxelX, voxelY, voxelZ);
  }
}
