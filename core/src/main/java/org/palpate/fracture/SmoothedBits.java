package org.palpate.fracture;

import org.palpate.geometry.AffineMap;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.fracture.PosedBits;

/**
 * The occupancy of a posed fragment, smoothed by a Gaussian, so that its surface, where half is
 * solid, lies between voxels. One thread an instance.
 */
final class SmoothedBits {
  /** The standard deviation of the Gaussian, voxels, and the voxels that it reaches. */
  private static final double SIGMA = 1.3;

  private static final int REACH = 4;
  private static final int WIDTH = 2 * REACH + 1;

  private final BitCube bits;
  private final AffineMap worldToGrid;
  private final PosedBits fragment;
  private final Vec3 grid = new Vec3();
  private final double[][] weights = new double[3][WIDTH];
  private final double[][] slopes = new double[3][WIDTH];
  private final int[] first = new int[3];

  SmoothedBits(PosedBits fragment) {
    this.fragment = fragment;
    bits = fragment.bits();
    worldToGrid = fragment.gridFrom(VoxelGrid.ofUnitVoxels(1, 1, 1), new Pose());
  }

  /** Whether a world position lies in a voxel. */
  boolean isSolid(Vec3 world) {
    worldToGrid.transform(world, grid);
    return bits.get((int) Math.floor(grid.x), (int) Math.floor(grid.y), (int) Math.floor(grid.z));
  }

  /**
   * Returns the smoothed occupancy at a world position, 0 to 1.
   *
   * @param outward receives the direction of steepest descent, a unit vector in the world
   */
  double occupancy(Vec3 world, Vec3 outward) {
    worldToGrid.transform(world, grid);
    for (int axis = 0; axis < 3; axis++) {
      setWeights(axis, grid.get(axis));
    }
    double sum = 0;
    double x = 0;
    double y = 0;
    double z = 0;
    for (int c = 0; c < WIDTH; c++) {
      for (int b = 0; b < WIDTH; b++) {
        double yz = weights[1][b] * weights[2][c];
        double slopeY = slopes[1][b] * weights[2][c];
        double slopeZ = weights[1][b] * slopes[2][c];
        for (int a = 0; a < WIDTH; a++) {
          if (bits.get(first[0] + a, first[1] + b, first[2] + c)) {
            sum += weights[0][a] * yz;
            x += slopes[0][a] * yz;
            y += weights[0][a] * slopeY;
            z += weights[0][a] * slopeZ;
          }
        }
      }
    }
    Vec3 s = fragment.grid().spacingMm();
    outward.set(-x / s.x, -y / s.y, -z / s.z);
    fragment.grid().gridMmToWorld().rotate(outward, outward);
    fragment.pose().rotation.rotate(outward, outward);
    double length = outward.length();
    outward.mul(length > 0 ? 1 / length : 0, outward);
    return sum;
  }

  private void setWeights(int axis, double coordinate) {
    first[axis] = (int) Math.floor(coordinate) - REACH;
    double total = 0;
    for (int n = 0; n < WIDTH; n++) {
      double d = first[axis] + n + 0.5 - coordinate;
      double w = StrictMath.exp(-d * d / (2 * SIGMA * SIGMA));
      weights[axis][n] = w;
      slopes[axis][n] = w * d / (SIGMA * SIGMA);
      total += w;
    }
    for (int n = 0; n < WIDTH; n++) {
      weights[axis][n] /= total;
      slopes[axis][n] /= total;
    }
  }
}
