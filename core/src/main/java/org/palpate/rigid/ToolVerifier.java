package org.palpate.rigid;

import org.palpate.body.BodyScene;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.statistics.SkipCounters;

/**
 * Verifies proposed motions of a tool against all bodies of a scene, and commits them. Nothing else
 * changes the committed pose, so only verified motions are ever committed.
 *
 * <p>Haptic thread only; allocates nothing.
 */
final class ToolVerifier {
  private final BodyVerifier[] bodies;
  private final EnclosureCheck enclosure;
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
      ClearanceLevels levels = new ClearanceLevels(scene.body(n), clearances[n]);
      bodies[n] = new BodyVerifier(tool, levels, n, skips);
    }
    enclosure = new EnclosureCheck(tool, bodies);
  }

  /** Returns the committed pose; not to be written. */
  Pose pose() {
    return pose;
  }

  /** Returns the verifier of a body by the body's index. */
  BodyVerifier body(int index) {
    return bodies[index];
  }

  /** Returns the number of points tested so far; see {@link BodyVerifier#tested}. */
  long tested() {
    long sum = 0;
    for (BodyVerifier body : bodies) {
      sum += body.tested();
    }
    return sum;
  }

  /** Adds the work that was skipped for all bodies. */
  void addSkips(SkipCounters dest) {
    for (BodyVerifier body : bodies) {
      body.addSkips(dest);
    }
  }

  /**
   * Returns the number of points that keep less than the full clearance of some body. Returns at
   * least 1 as long as it is not known that the tool encloses no solid.
   */
  int reducedCount() {
    int reduced = reducedPoints();
    return reduced == 0 && enclosure.isPending() ? 1 : reduced;
  }

  private int reducedPoints() {
    int sum = 0;
    for (BodyVerifier body : bodies) {
      sum += body.reducedCount();
    }
    return sum;
  }

  /**
   * Places the tool at a pose without a motion. If it returns false, the tool must be placed
   * elsewhere before any motion.
   *
   * @param newPose finite, with a unit quaternion
   * @param fullClearance whether all points must keep the full clearance
   * @return whether the pose is free
   */
  boolean place(Pose newPose, boolean fullClearance) {
    for (BodyVerifier body : bodies) {
      if (!body.place(newPose, fullClearance ? body.levels.highest : 0)) {
        return false;
      }
    }
    if (enclosure.enclosesAny(newPose)) {
      return false;
    }
    pose.set(newPose);
    candidate.set(newPose);
    beginOrEndEnclosureCheck();
    return true;
  }

  /** Solids may pass between points that keep less than their clearance, and only there. */
  private void beginOrEndEnclosureCheck() {
    if (reducedPoints() > 0) {
      enclosure.begin();
    } else {
      enclosure.end();
    }
  }

  /** The effect of edits of the bodies on a tool, the mildest first. */
  enum EditOutcome {
    /** There was no edit. */
    NONE,

    /** No point touches a voxel. */
    FREE,

    /** A point touches a voxel, or the tool encloses one: the tool must be placed anew. */
    COLLIDING
  }

  /** Applies the edits of all bodies since the last call, and returns the gravest outcome. */
  EditOutcome takeEdits() {
    boolean enclosedNothing = !enclosure.isPending() && reducedPoints() == 0;
    EditOutcome outcome = EditOutcome.NONE;
    for (BodyVerifier body : bodies) {
      EditOutcome ofBody = body.takeEdits();
      outcome = ofBody.compareTo(outcome) > 0 ? ofBody : outcome;
    }
    if (outcome != EditOutcome.FREE) {
      return outcome;
    }
    if (enclosedNothing && enclosure.enclosesEdited(pose)) {
      return EditOutcome.COLLIDING;
    }
    if (enclosure.isPending() || reducedPoints() > 0) {
      enclosure.begin();
    }
    return EditOutcome.FREE;
  }

  /** Proposes a motion from the committed pose to another. */
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
   * Raises the {@link ClearanceLevels} of points that have moved away from a body. Tests at most
   * {@code most} points for each body.
   */
  void raiseLevels(int most) {
    for (BodyVerifier body : bodies) {
      body.raiseLevels(most);
    }
  }

  /** Goes on to examine whether the tool encloses a solid, once no point is reduced any more. */
  void continueEnclosureCheck() {
    if (enclosure.isPending() && reducedPoints() == 0) {
      enclosure.continueAt(pose);
    }
  }

  /** Writes the grid coordinates of a point at the committed pose. */
  Vec3 gridPosition(int body, RigidTool tool, int point, Vec3 dest) {
    return bodies[body].from.transform(tool.point(point, dest), dest);
  }
}
