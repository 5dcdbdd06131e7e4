package org.palpate.rigid;

import org.palpate.body.Body;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.volume.BitCube;

/**
 * Checks whether the solid of a tool encloses solid voxels of a body. Sample points that keep their
 * clearance say that no solid crosses the surface of the tool. They do not say that none lies
 * inside. Only bodies with a clearance are checked.
 *
 * <p>While some points keep less than the clearance, a solid may pass between them into the tool.
 * So once all points keep it again, all voxels are examined, some in each frame. As long as all
 * points keep the clearance, a connected solid stays inside or outside. Therefore the result holds
 * although the tool moves between the frames of an examination.
 *
 * <p>Keeps scratch: haptic thread only.
 */
final class EnclosureCheck {
  /** About the number of solid voxels that are examined in a frame. */
  private static final int VOXELS_PER_FRAME = 2000;

  /** The number of rows of voxels of each body that are examined in a frame. */
  private static final int ROWS_PER_FRAME = 500;

  private final RigidTool tool;
  private final BodyVerifier[] bodies;
  private final double reachMm;
  private final Vec3 p = new Vec3();
  private final IntBox around = new IntBox();
  private boolean isPending;
  private int nextBody;
  private int nextJ;
  private int nextK;
  private int examined;

  EnclosureCheck(RigidTool tool, BodyVerifier[] bodies) {
    this.tool = tool;
    this.bodies = bodies;
    reachMm = tool.isCovered() ? tool.radiusMm() + tool.coverRadiusMm() : tool.radiusMm();
  }

  /** Whether an examination has not ended, so that the tool may enclose a solid. */
  boolean isPending() {
    return isPending;
  }

  /** Begins the examination anew, because a solid may have passed between the points. */
  void begin() {
    isPending = hasAnythingToCheck();
    nextBody = 0;
    nextJ = 0;
    nextK = 0;
  }

  /** Ends the examination, because the whole tool was checked at one pose. */
  void end() {
    isPending = false;
  }

  private boolean hasAnythingToCheck() {
    for (BodyVerifier verifier : bodies) {
      if (hasClearance(verifier)) {
        return tool.solid() != null;
      }
    }
    return false;
  }

  private static boolean hasClearance(BodyVerifier verifier) {
    return verifier.levels.highest > 0;
  }

  /** Whether the tool at a pose encloses the centre of a solid voxel. */
  boolean enclosesAny(Pose pose) {
    return enclosesAny(pose, false);
  }

  /** Whether the tool at a pose encloses the centre of a solid voxel that the last edit changed. */
  boolean enclosesEdited(Pose pose) {
    return enclosesAny(pose, true);
  }

  private boolean enclosesAny(Pose pose, boolean editedOnly) {
    if (tool.solid() == null) {
      return false;
    }
    for (BodyVerifier verifier : bodies) {
      if (hasClearance(verifier) && enclosesAny(verifier, pose, editedOnly)) {
        return true;
      }
    }
    return false;
  }

  private boolean enclosesAny(BodyVerifier verifier, Pose pose, boolean editedOnly) {
    Body body = verifier.levels.body;
    setVoxelsAround(body, pose);
    if (editedOnly) {
      cut(verifier.editedVoxels());
    }
    for (int k = around.lowZ; k <= around.highZ; k++) {
      for (int j = around.lowY; j <= around.highY; j++) {
        if (enclosesInRow(body, pose, j, k)) {
          return true;
        }
      }
    }
    return false;
  }

  /**
   * Goes on with the examination. It begins anew if it finds that the tool encloses a solid.
   *
   * @param pose the committed pose, at which all points keep their clearance
   */
  void continueAt(Pose pose) {
    examined = 0;
    boolean isBodyExamined = true;
    while (isPending && isBodyExamined) {
      isBodyExamined = examineBody(pose);
      if (isBodyExamined) {
        nextBody++;
        nextJ = 0;
        nextK = 0;
        isPending = nextBody < bodies.length;
      }
    }
  }

  /** Goes on with the present body. Returns whether all of it was examined, with nothing found. */
  private boolean examineBody(Pose pose) {
    if (!hasClearance(bodies[nextBody])) {
      return true;
    }
    Body body = bodies[nextBody].levels.body;
    setVoxelsAround(body, pose);
    for (int rows = 0; rows < ROWS_PER_FRAME && examined < VOXELS_PER_FRAME; rows++) {
      if (!findRow()) {
        return true;
      }
      if (enclosesInRow(body, pose, nextJ++, nextK)) {
        begin();
        return false;
      }
    }
    return false;
  }

  /** Finds the next row of voxels that meets the box around the tool; false if there is none. */
  private boolean findRow() {
    if (nextK < around.lowZ) {
      nextK = around.lowZ;
      nextJ = around.lowY;
    }
    if (nextJ > around.highY) {
      nextK++;
      nextJ = around.lowY;
    }
    nextJ = Math.max(nextJ, around.lowY);
    return !around.isEmpty() && nextK <= around.highZ;
  }

  private boolean enclosesInRow(Body body, Pose pose, int j, int k) {
    BitCube bits = body.bits();
    for (int i = around.lowX; i <= around.highX; i++) {
      if (bits.brick(i >> 2, j >> 2, k >> 2) == 0) {
        i |= 3;
      } else if (bits.get(i, j, k) && encloses(body, pose, i, j, k)) {
        return true;
      }
    }
    return false;
  }

  private boolean encloses(Body body, Pose pose, int i, int j, int k) {
    examined++;
    body.grid().gridToWorld(p.set(i + 0.5, j + 0.5, k + 0.5), p);
    body.pose().transform(p, p);
    pose.inverseTransform(p, p);
    return tool.solid().contains(p.x, p.y, p.z);
  }

  /** Sets the voxels of a body around the tool, cut to its grid. */
  private void setVoxelsAround(Body body, Pose pose) {
    body.pose().inverseTransform(pose.translation, p);
    body.grid().worldToGrid(p, p);
    Vec3 spacing = body.grid().spacingMm();
    around.lowX = low(p.x, spacing.x);
    around.lowY = low(p.y, spacing.y);
    around.lowZ = low(p.z, spacing.z);
    around.highX = high(p.x, spacing.x, body.grid().sizeX());
    around.highY = high(p.y, spacing.y, body.grid().sizeY());
    around.highZ = high(p.z, spacing.z, body.grid().sizeZ());
  }

  private int low(double centre, double spacingMm) {
    return (int) Math.max(0, Math.floor(centre - reachMm / spacingMm - 2));
  }

  private int high(double centre, double spacingMm, int size) {
    return (int) Math.max(-1, Math.min(size - 1.0, centre + reachMm / spacingMm + 2));
  }

  private void cut(IntBox box) {
    around.lowX = Math.max(around.lowX, box.lowX);
    around.lowY = Math.max(around.lowY, box.lowY);
    around.lowZ = Math.max(around.lowZ, box.lowZ);
    around.highX = Math.min(around.highX, box.highX);
    around.highY = Math.min(around.highY, box.highY);
    around.highZ = Math.min(around.highZ, box.highZ);
  }
}
