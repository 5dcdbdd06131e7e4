package org.palpate.reduction;

import java.util.List;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.volume.BitCube;

/**
 * Finds out whether fragments at some poses would lie in each other. It compares some of their
 * sample points with the voxels, so it may miss a thin contact. World mm. One thread.
 */
final class FragmentPlaces {
  /**
   * Fragments meet if a point is at most so far from a voxel, along an axis of its grid, voxels.
   */
  private static final int NEAR_VOXELS = 1;

  private final BodyScene bodies;
  private final List<RigidTool> shapes;

  /**
   * Creates it.
   *
   * @param shapes sample points of each body; few are enough
   */
  FragmentPlaces(BodyScene bodies, List<RigidTool> shapes) {
    this.bodies = bodies;
    this.shapes = shapes;
  }

  /** Whether a fragment at a pose would meet another at a pose. */
  boolean meet(int fragment, Pose pose, int other, Pose otherPose) {
    return lieIn(fragment, pose, other, otherPose) || lieIn(other, otherPose, fragment, pose);
  }

  /** Returns the distance from a point to the farthest point of a body where it is now, mm. */
  double farthestMm(int body, Vec3 from) {
    double farMm = 0;
    for (Vec3 point : ReductionPlan.points(shapes.get(body), bodies.body(body).pose())) {
      farMm = Math.max(farMm, point.sub(from, point).length());
    }
    return farMm;
  }

  /** Whether a sample point of one lies in or beside a voxel of the other. */
  private boolean lieIn(int fragment, Pose pose, int other, Pose otherPose) {
    Body body = bodies.body(other);
    AffineMap toGrid = body.toolToGrid(otherPose, new Pose(), new AffineMap());
    Vec3 at = new Vec3();
    for (Vec3 point : ReductionPlan.points(shapes.get(fragment), pose)) {
      if (isNear(body.bits(), toGrid.transform(point, at))) {
        return true;
      }
    }
    return false;
  }

  private static boolean isNear(BitCube bits, Vec3 grid) {
    int i = (int) Math.floor(grid.x);
    int j = (int) Math.floor(grid.y);
    int k = (int) Math.floor(grid.z);
    for (int n = -NEAR_VOXELS; n <= NEAR_VOXELS; n++) {
      if (bits.get(i + n, j, k) || bits.get(i, j + n, k) || bits.get(i, j, k + n)) {
        return true;
      }
    }
    return false;
  }
}
