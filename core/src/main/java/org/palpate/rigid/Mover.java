package org.palpate.rigid;

import org.palpate.body.Body;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * A rigid thing among others: the tool, a body that moves, or a body that stands still. It has a
 * committed pose and, during verification, a proposed one.
 *
 * <p>A tool has sample points and no voxels, a body that stands still has voxels and no sample
 * points, and a body that moves has both. Poses of sample points are those of their reference
 * point; see {@link ReferencePose}. Haptic thread only.
 */
final class Mover {
  /** More than the norm of the inverse of axes that are orthonormal up to the tolerance. */
  private static final double INVERSE_NORM = 1.01;

  /** The sample points; null for a body that stands still. */
  final RigidTool shape;

  /** The voxels; null for the tool. */
  final Body body;

  /** The committed pose of the sample points, their frame to world, mm. */
  final Pose pose = new Pose();

  /** The proposed pose of the sample points. */
  final Pose candidate = new Pose();

  /** The largest distance of a voxel from the reference point, mm; 0 for the tool. */
  final double reachMm;

  /** The mover along with which this one moves as if glued to it; itself if it moves alone. */
  Mover carrier = this;

  /** The error of the place of a voxel in the world, mm; see {@link #distortionMm(int)}. */
  private final double distortionMm;

  /** The number of pairs in which this has the points and whose {@link EnclosureCheck} goes on. */
  int pendingChecks;

  private final ReferencePose reference;
  private final Pose bodyCandidate = new Pose();
  private MoverBroadPhase broadPhase;
  private int index;
  private long version;
  private long motionsSeen;
  private boolean isPresent;

  private Mover(RigidTool shape, Body body) {
    this.shape = shape;
    this.body = body;
    boolean movesVoxels = shape != null && body != null;
    reference = movesVoxels ? new ReferencePose(shape.referenceMm(new Vec3())) : null;
    reachMm = movesVoxels ? reachMm(body, shape.referenceMm(new Vec3())) : 0;
    distortionMm = body == null ? 0 : distortionMm(0);
    isPresent = body != null;
    if (body != null) {
      takeBodyPose();
    }
  }

  /** Returns the tool, which is not placed yet. */
  static Mover tool(RigidTool tool) {
    return new Mover(tool, null);
  }

  /** Returns a body that stands still. */
  static Mover standing(Body body) {
    return new Mover(null, body);
  }

  /** Returns a body that moves. Its pose is snapped; see {@link ReferencePose#snap}. */
  static Mover moving(Body body, RigidTool shape) {
    return new Mover(shape, body);
  }

  private static double reachMm(Body body, Vec3 referenceMm) {
    BitCube bits = body.bits();
    Vec3 corner = new Vec3();
    double square = 0;
    for (int k = 0; k < bits.sizeZ(); k++) {
      for (int j = 0; j < bits.sizeY(); j++) {
        for (int i = 0; i < bits.sizeX(); i++) {
          if (bits.brick(i >> 2, j >> 2, k >> 2) == 0) {
            i |= 3;
          } else if (bits.get(i, j, k)) {
            body.grid().gridToWorld(corner.set(i + 0.5, j + 0.5, k + 0.5), corner);
            corner.sub(referenceMm, corner);
            square = Math.max(square, corner.dot(corner));
          }
        }
      }
    }
    return (Math.sqrt(square) + body.grid().spacingMm().length()) * (1 + 1e-12);
  }

  /**
   * Returns the largest error of the place of a voxel in the world, mm. The axes of a file are
   * orthonormal only to some digits, and verification maps the world to the grid by the transposed
   * axes. Allocates. Not for the tool.
   *
   * @param beyond the number of voxels by which voxels may lie outside of the grid
   */
  double distortionMm(int beyond) {
    VoxelGrid grid = body.grid();
    Vec3 spacing = grid.spacingMm();
    Vec3 far =
        new Vec3(
            (grid.sizeX() + 1 + beyond) * spacing.x,
            (grid.sizeY() + 1 + beyond) * spacing.y,
            (grid.sizeZ() + 1 + beyond) * spacing.z);
    return INVERSE_NORM * grid.gridMmToWorld().distortion() * far.length();
  }

  /** Returns what {@link #reachMm} leaves out, mm: the edges of a grown cell, and distortion. */
  double marginMm() {
    return body.grid().spacingMm().length() + distortionMm;
  }

  /** Whether the body can move. */
  boolean canMove() {
    return shape != null;
  }

  /** Whether this is in the scene: a tool only if it was placed and no body is held instead. */
  boolean isPresent() {
    return isPresent;
  }

  /** Puts the tool into the scene, or takes it out. */
  void setPresent(boolean present) {
    isPresent = present;
  }

  /** Returns the committed pose of the voxels, rest to present. */
  Pose bodyPose() {
    return body.pose();
  }

  /** Returns the proposed pose of the voxels, rest to present. */
  Pose bodyCandidate() {
    return bodyCandidate;
  }

  /** Moves a pose of the sample points to the nearest one that this can have. */
  Pose snap(Pose ofPoints) {
    return body == null ? ofPoints : ReferencePose.snap(ofPoints);
  }

  /** Writes the pose of the reference point that belongs to a pose from rest to present. */
  Pose toReference(Pose restToPresent, Pose dest) {
    return reference.toReference(restToPresent, dest);
  }

  /** Proposes a pose of the sample points, which is snapped. */
  void propose(Pose ofPoints) {
    candidate.set(ofPoints);
    if (body != null) {
      assert snap(bodyCandidate.set(ofPoints)).sameBits(ofPoints) : "not snapped: " + ofPoints;
      reference.toRest(ofPoints, bodyCandidate);
    }
  }

  /** Lets a broad phase follow all motions. */
  void setBroadPhase(MoverBroadPhase newBroadPhase, int ownIndex) {
    broadPhase = newBroadPhase;
    index = ownIndex;
  }

  /** Returns a number that changes with each change of the committed pose. */
  long version() {
    return version;
  }

  private void moved() {
    version++;
    if (broadPhase != null) {
      broadPhase.refit(index);
    }
  }

  /** Makes the proposed pose the committed one. */
  void commit() {
    pose.set(candidate);
    if (body != null) {
      body.setPose(bodyCandidate);
      motionsSeen = body.motions();
    }
    moved();
  }

  /** Whether somebody else set the pose of the body since it was committed. */
  boolean wasMoved() {
    return body != null && body.motions() != motionsSeen;
  }

  /** Takes the pose of the body as the committed one, unverified. */
  void takeBodyPose() {
    if (reference != null) {
      bodyCandidate.set(body.pose());
      body.setPose(ReferencePose.snap(bodyCandidate));
      reference.toReference(body.pose(), pose);
    }
    motionsSeen = body.motions();
    moved();
  }

  /** The effect of edits of the bodies on a mover, the mildest first. */
  enum EditOutcome {
    /** There was no edit. */
    NONE,

    /** No point touches a voxel. */
    FREE,

    /** A point touches a voxel, or a solid encloses one: the mover must be placed anew. */
    COLLIDING
  }
}
