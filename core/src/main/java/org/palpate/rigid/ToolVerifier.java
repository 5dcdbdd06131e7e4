package org.palpate.rigid;

import org.palpate.body.BodyScene;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;

/**
 * Decides whether a proposed motion of a tool is free of all bodies of a scene, and commits
 * motions. Nothing else changes the committed pose, so nothing that was not verified is ever
 * committed. Haptic thread only; allocates nothing.
 */
final class ToolVerifier {
  private final BodyVerifier[] bodies;
  private final ToolInterior interior;
  private final Pose pose = new Pose();
  private final Pose candidate = new Pose();

  /**
   * Creates a verifier of a tool that has not been placed yet.
   *
   * @param clearances one for each body
   * @param skips whether to skip space that is proved to be empty; the answers are the same
   */
  ToolVerifier(BodyScene scene, RigidTool tool, Clearance[] clearances, boolean skips) {
    bodies = new BodyVerifier[scene.count()];
    for (int n = 0; n < bodies.length; n++) {
      Barrier barrier = new Barrier(scene.body(n), clearances[n]);
      bodies[n] = new BodyVerifier(tool, barrier, n, skips);
    }
    interior = new ToolInterior(tool, bodies);
  }

  /** Returns the committed pose; not to be written. */
  Pose pose() {
    return pose;
  }

  BodyVerifier body(int index) {
    return bodies[index];
  }

  /** Returns the points looked at so far, as {@link BodyVerifier#looked} counts them. */
  long looked() {
    long sum = 0;
    for (BodyVerifier body : bodies) {
      sum += body.looked();
    }
    return sum;
  }

  /** Returns how many points keep less than the full clearance of some body. */
  int reducedCount() {
    int sum = 0;
    for (BodyVerifier body : bodies) {
      sum += body.reducedCount();
    }
    return sum;
  }

  /**
   * Puts the tool at a pose without a motion. If it returns false, place it elsewhere before any
   * motion.
   *
   * @param fullClearance whether all points must keep the full clearance
   * @return whether the pose is free
   */
  boolean place(Pose newPose, boolean fullClearance) {
    for (BodyVerifier body : bodies) {
      if (!body.place(newPose, fullClearance ? body.barrier.highest : 0)) {
        return false;
      }
    }
    if (interior.holdsSolid(newPose)) {
      return false;
    }
    pose.set(newPose);
    candidate.set(newPose);
    return true;
  }

  /** The effect of edits of the bodies on a tool, the mildest first. */
  enum EditOutcome {
    /** There was no edit. */
    NONE,

    /** No point touches a voxel. */
    FREE,

    /** A point touches a voxel: the tool must be placed anew. */
    BURIED
  }

  /** Applies the edits of all bodies since the last call; returns the gravest outcome. */
  EditOutcome takeEdits() {
    EditOutcome outcome = EditOutcome.NONE;
    for (BodyVerifier body : bodies) {
      EditOutcome ofBody = body.takeEdits();
      outcome = ofBody.compareTo(outcome) > 0 ? ofBody : outcome;
    }
    return outcome;
  }

  /** Sets the pose that is proposed. */
  void propose(Pose proposal) {
    candidate.set(proposal);
    for (BodyVerifier body : bodies) {
      body.propose(proposal);
    }
  }

  /** Whether no leg of the proposal touches a solid; see {@link BodyVerifier#isFree}. */
  boolean isFree(double turnRad, boolean firstOnly, LegHits hits) {
    boolean free = true;
    for (BodyVerifier body : bodies) {
      free &= body.isFree(turnRad, firstOnly, hits);
      if (!free && (firstOnly || hits.isFull() || turnRad != 0)) {
        return false;
      }
    }
    return free;
  }

  /** Commits the proposal. {@link #isFree} must have found it free. */
  void commit() {
    pose.set(candidate);
    for (BodyVerifier body : bodies) {
      body.commit();
    }
  }

  /** Takes the tool back to a pose at which it was committed in this frame. */
  void takeBack(Pose earlier) {
    propose(earlier);
    commit();
  }

  /**
   * Raises the {@link Barrier} levels of points that have moved away from a body. Looks at most at
   * {@code most} points for each body.
   */
  void raiseLevels(int most) {
    for (BodyVerifier body : bodies) {
      body.raiseLevels(most);
    }
  }

  /** Writes the grid coordinates of a point at the committed pose. */
  Vec3 gridPosition(int body, RigidTool tool, int point, Vec3 dest) {
    return bodies[body].from.transform(tool.point(point, dest), dest);
  }
}
