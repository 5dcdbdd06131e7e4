package org.palpate.rigid;

import org.palpate.body.Body;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.volume.BitCube;

/**
 * Checks whether the solid of sample points encloses solid voxels of a body. Sample points that
 * keep their clearance say that no solid crosses the surface of their solid. They do not say that
 * none lies inside. Only pairs with a clearance are checked.
 *
 * <p>While some points keep less than the clearance, a solid may pass between them into the other.
 * So once all points keep it again, all voxels are examined, some in each frame. As long as all
 * points keep the clearance, a connected solid stays inside or outside. Therefore the result holds
 * although the two move between the frames of an examination.
 *
 * <p>Keeps scratch: haptic thread only.
 */
final class EnclosureCheck {
  /** About the number of solid voxels that are examined in a frame. */
  private static final int VOXELS_PER_FRAME = 2000;

  /** The number of rows of voxels that are examined in a frame. */
  private static final int ROWS_PER_FRAME = 500;

  private final BodyVerifier pair;
  private final RigidTool tool;
  private final Body body;
  private final double reachMm;
  private final Vec3 p = new Vec3();
  private final IntBox around = new IntBox();
  private final Rows rows = new Rows();
  private boolean isPending;
  private int examined;

  /** The finding of an examination so far. */
  enum Found {
    /** Nothing, but voxels are left. */
    UNDECIDED,

    /** No voxel is enclosed. */
    NOTHING,

    /** A voxel is enclosed. */
    ENCLOSED
  }

  /** The row of voxels with which an examination goes on. */
  static final class Rows {
    private int nextJ;
    private int nextK;

    /** Begins with the first row. */
    void begin() {
      nextJ = 0;
      nextK = 0;
    }

    /** Finds the next row of voxels that meets a box; false if there is none. */
    private boolean find(IntBox box) {
      if (nextK < box.lowZ) {
        nextK = box.lowZ;
        nextJ = box.lowY;
      }
      if (nextJ > box.highY) {
        nextK++;
        nextJ = box.lowY;
      }
      nextJ = Math.max(nextJ, box.lowY);
      return !box.isEmpty() && nextK <= box.highZ;
    }
  }

  EnclosureCheck(BodyVerifier pair) {
    this.pair = pair;
    tool = pair.points.shape;
    body = pair.levels.body;
    reachMm = tool.isCovered() ? tool.radiusMm() + tool.coverRadiusMm() : tool.radiusMm();
  }

  /** Whether an examination has not ended, so that a solid may be enclosed. */
  boolean isPending() {
    return isPending;
  }

  /**
   * Notes that the points were placed where nothing is enclosed. An examination begins if some of
   * them keep less than their clearance; otherwise none is pending.
   */
  void beginOrEnd() {
    if (pair.reducedCount() > 0) {
      begin();
    } else {
      setPending(false);
    }
  }

  private void setPending(boolean pending) {
    if (pending != isPending) {
      isPending = pending;
      pair.points.pendingChecks += pending ? 1 : -1;
    }
  }

  /** Begins the examination anew, because a solid may have passed between the points. */
  void begin() {
    setPending(canEnclose());
    rows.begin();
  }

  /** Whether the points have a clearance and a solid, so that they may enclose something. */
  boolean canEnclose() {
    return pair.levels.highest > 0 && tool.solid() != null;
  }

  /** Whether the solid encloses the centre of a solid voxel at these poses. */
  boolean enclosesAny(Pose ofPoints, Pose ofBody) {
    if (!canEnclose()) {
      return false;
    }
    setVoxelsAround(ofPoints, ofBody);
    return enclosesInBox(ofPoints, ofBody);
  }

  /** Whether the solid encloses the centre of a voxel that the last edit changed. */
  private boolean enclosesEdited() {
    if (!canEnclose()) {
      return false;
    }
    setVoxelsAround(pair.points.pose, pair.solid.bodyPose());
    cut(pair.editedVoxels());
    return enclosesInBox(pair.points.pose, pair.solid.bodyPose());
  }

  /** Whether the solid encloses the centre of voxel (i,j,k) at the committed poses. */
  boolean encloses(int i, int j, int k) {
    return canEnclose() && encloses(pair.points.pose, pair.solid.bodyPose(), i, j, k);
  }

  /** Applies the edits of the pair's body, and checks whether added voxels are enclosed. */
  Mover.EditOutcome takeEdits() {
    boolean enclosedNothing = !isPending && pair.reducedCount() == 0;
    Mover.EditOutcome outcome = pair.takeEdits();
    if (outcome != Mover.EditOutcome.FREE) {
      return outcome;
    }
    if (enclosedNothing && enclosesEdited()) {
      return Mover.EditOutcome.COLLIDING;
    }
    if (isPending || pair.reducedCount() > 0) {
      begin();
    }
    return Mover.EditOutcome.FREE;
  }

  private boolean enclosesInBox(Pose ofPoints, Pose ofBody) {
    for (int k = around.lowZ; k <= around.highZ; k++) {
      for (int j = around.lowY; j <= around.highY; j++) {
        if (enclosesInRow(ofPoints, ofBody, j, k)) {
          return true;
        }
      }
    }
    return false;
  }

  /** Whether the examination can go on, because all points keep their clearance. */
  boolean canContinue() {
    return isPending && pair.reducedCount() == 0;
  }

  /** Goes on with the examination. It begins anew if it finds that a solid is enclosed. */
  void continueCheck() {
    Found found = examine(pair.points.pose, pair.solid.bodyPose(), rows);
    if (found == Found.ENCLOSED) {
      begin();
    } else if (found == Found.NOTHING) {
      setPending(false);
    }
  }

  /**
   * Examines as many rows of voxels as a frame may.
   *
   * @param next the row with which it goes on; moved on
   */
  Found examine(Pose ofPoints, Pose ofBody, Rows next) {
    examined = 0;
    setVoxelsAround(ofPoints, ofBody);
    for (int row = 0; row < ROWS_PER_FRAME && examined < VOXELS_PER_FRAME; row++) {
      if (!next.find(around)) {
        return Found.NOTHING;
      }
      if (enclosesInRow(ofPoints, ofBody, next.nextJ++, next.nextK)) {
        return Found.ENCLOSED;
      }
    }
    return Found.UNDECIDED;
  }

  private boolean enclosesInRow(Pose ofPoints, Pose ofBody, int j, int k) {
    BitCube bits = body.bits();
    for (int i = around.lowX; i <= around.highX; i++) {
      if (bits.brick(i >> 2, j >> 2, k >> 2) == 0) {
        i |= 3;
      } else if (bits.get(i, j, k) && encloses(ofPoints, ofBody, i, j, k)) {
        return true;
      }
    }
    return false;
  }

  private boolean encloses(Pose ofPoints, Pose ofBody, int i, int j, int k) {
    examined++;
    body.grid().gridToWorld(p.set(i + 0.5, j + 0.5, k + 0.5), p);
    ofBody.transform(p, p);
    ofPoints.inverseTransform(p, p);
    return tool.solid().contains(p.x, p.y, p.z);
  }

  /** Sets the voxels of the body around the points, cut to its grid. */
  private void setVoxelsAround(Pose ofPoints, Pose ofBody) {
    ofBody.inverseTransform(ofPoints.translation, p);
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
