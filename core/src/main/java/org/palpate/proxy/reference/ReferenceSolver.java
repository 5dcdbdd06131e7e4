package org.palpate.proxy.reference;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.LegPath;
import org.palpate.proxy.ProxySolver;
import org.palpate.raycast.RayCaster;

/**
 * The common part of the two published methods: the point moves to a solid, follows border voxels
 * along its surface, and repeats this until it arrives, stands still or has used up its path. They
 * differ in the border voxel that they select, and in what else ends the motion along the surface.
 *
 * <p>Where both descriptions are open: the position of a voxel is its centre; distances are metric,
 * but one step and epsilon are in voxels; a full {@link LegPath} ends the frame.
 *
 * <p>Haptic thread. Reference: Vlasov, Friese, Wolter 2013, section 4.2.
 */
abstract class ReferenceSolver implements ProxySolver {
  /**
   * The distance before the collision point at which p stops, voxels. It is the largest number
   * below 1, so that p comes to the last free sample of a step of 1. With a smaller one p stalls
   * before it reaches the surface, because its stop lies in the solid, or it creeps.
   */
  static final double EPSILON_VOXELS = 1 - 0x1p-53;

  private final BorderVoxels border;

  /** The moving point of the descriptions. */
  final ReferencePath p2;

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
  ReferenceSolver(RayCaster caster, GridMetric metric, double maxPathMm, BorderVoxels border) {
    this.border = border;
    p2 = new ReferencePath(caster, metric, maxPathMm);
  }

  @Override
  public final void reset() {
    border.forget();
  }

  /** Follows the device, by the steps of {@link DotSolver} and the lines of {@link PaperSolver}. */
  @Override
  public final void follow(CollisionScene scene, Vec3 device, InteractionPoint point) {
    p2.begin(scene, device, point); // step 1; lines 1 and 2, 4
    point.contact = false;
    boolean moved = true; // line 3
    while (!p2.isAtDevice() && p2.mayGoOn() && moved) { // step 4; line 5
      double lastX = p2.x; // line 6
      double lastY = p2.y;
      double lastZ = p2.z;
      if (!p2.meetsSolidBeforeDevice()) { // step 2; lines 7 and 8
        p2.moveTowards(p2.deviceX, p2.deviceY, p2.deviceZ, false); // line 9
        break;
      }
      point.contact = true;
      p2.moveBeforeCollision(EPSILON_VOXELS); // line 13
      followSurface(); // step 3; line 17
      moved = p2.x != lastX || p2.y != lastY || p2.z != lastZ;
    }
    point.position.set(p2.x, p2.y, p2.z);
  }

  /** Moves along the surface until a voxel is not reached, or the method ends the motion. */
  abstract void followSurface();

  /**
   * Selects the border voxel around p with the greatest merit.
   *
   * @param least the merit that it has to exceed
   * @return false if there is none
   */
  final boolean selectVoxel(double least) {
    int i = (int) Math.floor(p2.x);
    int j = (int) Math.floor(p2.y);
    int k = (int) Math.floor(p2.z);
    double greatest = least;
    for (int n = 0; n < 27; n++) {
      int x = i + n % 3 - 1;
      int y = j + n / 3 % 3 - 1;
      int z = k + n / 9 - 1;
      if (n != 13 && border.isBorder(p2.scene(), x, y, z)) {
        double merit = merit(x + 0.5, y + 0.5, z + 0.5);
        if (merit > greatest) {
          greatest = merit;
          voxelX = x + 0.5;
          voxelY = y + 0.5;
          voxelZ = z + 0.5;
        }
      }
    }
    return greatest > least;
  }

  /** Returns how well a voxel leads to the device, given its centre. */
  abstract double merit(double x, double y, double z);

  /** Moves to the selected voxel; returns false if the motion was cancelled. */
  final boolean moveToVoxel() {
    return p2.moveToVoxel(voxelX, voxelY, voxelZ);
  }
}
