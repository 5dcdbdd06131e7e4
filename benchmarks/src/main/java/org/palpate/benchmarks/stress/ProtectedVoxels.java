package org.palpate.benchmarks.stress;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.palpate.body.GrownSolids;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;

/**
 * A protected segment of a few voxels in a hostile scene.
 *
 * @param nerve the segment
 * @param voxels its voxels, i, j and k of each
 * @param spacingMm the edges of a voxel
 * @param marginMm the margin around it
 * @param kept the voxels that nothing may change, as a session finds them
 */
public record ProtectedVoxels(
    BitCube nerve, List<int[]> voxels, Vec3 spacingMm, double marginMm, BitCube kept) {
  private static final int MOST_VOXELS = 3;

  /** The largest margin, shortest voxel edges. */
  private static final double MOST_EDGES = 3;

  /** Returns random voxels with a random margin, which is sometimes zero. */
  public static ProtectedVoxels next(SplittableRandom random, HostileScene scene) {
    BitCube nerve = emptyLike(scene.bits());
    List<int[]> voxels = new ArrayList<>();
    for (int n = random.nextInt(MOST_VOXELS); n >= 0; n--) {
      int[] voxel = {
        random.nextInt(nerve.sizeX()), random.nextInt(nerve.sizeY()), random.nextInt(nerve.sizeZ())
      };
      nerve.set(voxel[0], voxel[1], voxel[2]);
      voxels.add(voxel);
    }
    Vec3 spacing = scene.spacingMm();
    double edgeMm = scene.metric().shortestEdgeMm();
    double marginMm = random.nextInt(4) == 0 ? 0 : random.nextDouble(MOST_EDGES) * edgeMm;
    BitCube kept = emptyLike(nerve);
    GrownSolids.addNear(nerve, scene.metric(), marginMm, kept);
    return new ProtectedVoxels(nerve, voxels, spacing, marginMm, kept);
  }

  private static BitCube emptyLike(BitCube bits) {
    return new BitCube(bits.sizeX(), bits.sizeY(), bits.sizeZ());
  }

  /** Returns the voxels that must stay, found by comparing each one with each of the segment. */
  public BitCube near() {
    BitCube near = nerve.copy();
    for (int k = 0; k < near.sizeZ(); k++) {
      for (int j = 0; j < near.sizeY(); j++) {
        for (int i = 0; i < near.sizeX(); i++) {
          if (isNear(i, j, k, 1)) {
            near.set(i, j, k);
          }
        }
      }
    }
    return near;
  }

  /** Whether a point of the grid is nearer to the segment than the margin. */
  public boolean isNear(double x, double y, double z) {
    return isNear(x, y, z, 0);
  }

  private boolean isNear(double x, double y, double z, double edge) {
    for (int[] voxel : voxels) {
      double a = spacingMm.x * gap(x, edge, voxel[0]);
      double b = spacingMm.y * gap(y, edge, voxel[1]);
      double c = spacingMm.z * gap(z, edge, voxel[2]);
      if (a * a + b * b + c * c < marginMm * marginMm) {
        return true;
      }
    }
    return false;
  }

  /** Returns the distance between the interval of an edge from a coordinate on, and a voxel. */
  private static double gap(double low, double edge, int voxel) {
    return Math.max(0, Math.max(voxel - (low + edge), low - (voxel + 1)));
  }
}
