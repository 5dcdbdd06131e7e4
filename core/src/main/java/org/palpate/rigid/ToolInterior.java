package org.palpate.rigid;

import org.palpate.body.Body;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.volume.BitCube;

/**
 * Finds bodies that lie wholly inside a tool. A tool whose points keep their clearance has no solid
 * voxel across its surface, but a small body may be in its inside; verified motions keep both as
 * they are. Only bodies with a clearance matter. Keeps scratch: one thread.
 */
final class ToolInterior {
  private final RigidTool tool;
  private final BodyVerifier[] bodies;
  private final Vec3 p = new Vec3();
  private final Vec3 low = new Vec3();
  private final Vec3 high = new Vec3();

  ToolInterior(RigidTool tool, BodyVerifier[] bodies) {
    this.tool = tool;
    this.bodies = bodies;
  }

  /** Whether the centre of a voxel of any body with a clearance lies in the tool at a pose. */
  boolean holdsSolid(Pose pose) {
    if (tool.solid() == null) {
      return false;
    }
    for (BodyVerifier verifier : bodies) {
      if (verifier.barrier.highest > 0 && holdsSolid(verifier.barrier.body, pose)) {
        return true;
      }
    }
    return false;
  }

  private boolean holdsSolid(Body body, Pose pose) {
    BitCube bits = body.bits();
    setBox(body, pose);
    for (int k = (int) low.z; k <= high.z; k++) {
      for (int j = (int) low.y; j <= high.y; j++) {
        for (int i = (int) low.x; i <= high.x; i++) {
          if (bits.brick(i >> 2, j >> 2, k >> 2) == 0) {
            i |= 3;
          } else if (bits.get(i, j, k) && isInTool(body, pose, i, j, k)) {
            return true;
          }
        }
      }
    }
    return false;
  }

  /** Sets the voxels of a body around the tool, cut to its grid. */
  private void setBox(Body body, Pose pose) {
    body.pose().inverseTransform(pose.translation, p);
    body.grid().worldToGrid(p, p);
    Vec3 spacing = body.grid().spacingMm();
    for (int axis = 0; axis < 3; axis++) {
      double reach = tool.radiusMm() / spacing.get(axis) + 2;
      low.set(axis, Math.max(0, Math.floor(p.get(axis) - reach)));
    }
    high.set(
        Math.min(body.grid().sizeX() - 1.0, p.x + tool.radiusMm() / spacing.x + 2),
        Math.min(body.grid().sizeY() - 1.0, p.y + tool.radiusMm() / spacing.y + 2),
        Math.min(body.grid().sizeZ() - 1.0, p.z + tool.radiusMm() / spacing.z + 2));
  }

  private boolean isInTool(Body body, Pose pose, int i, int j, int k) {
    body.grid().gridToWorld(p.set(i + 0.5, j + 0.5, k + 0.5), p);
    body.pose().transform(p, p);
    pose.inverseTransform(p, p);
    return tool.solid().contains(p.x, p.y, p.z);
  }
}
