package org.palpate.rigid;

import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.statistics.SkipCounters;

/**
 * Verifies proposed motions of one mover against all others, and commits them. Nothing else changes
 * a committed pose, so only verified motions are ever committed.
 *
 * <p>There are two roles. Against a body, the mover carries the sample points, or it has the voxels
 * and the other carries the points. The role belongs to the pair and does not depend on who moves.
 * Others are numbered as the bodies of the scene; the tool comes last.
 *
 * <p>Haptic thread only; allocates nothing.
 */
final class MoverVerifier {
  /** Shortens a step to its limit, against the rounding of a square root. */
  private static final double SHORTER = 1 - 1e-9;

  final Mover mover;

  private final BodyVerifier[] pairs;
  private final double largestTurn;
  private final double sagittaMm;

  /** The distance from the reference point within which other points can touch the mover, mm. */
  private final double reachMm;

  private final boolean hasOwnVoxels;
  private final ArcBound pointsTurn = new ArcBound();
  private final ArcBound bodyTurns = new ArcBound();
  private final Vec3 centre = new Vec3();

  /**
   * Creates a verifier.
   *
   * @param pairs by the index of the other mover; null where the two never move against each other
   * @param edgeMm the shortest voxel edge of the scene
   */
  MoverVerifier(Mover mover, BodyVerifier[] pairs, double edgeMm) {
    this.mover = mover;
    this.pairs = pairs;
    largestTurn = StepLimits.largestTurn(mover.shape.radiusMm(), edgeMm);
    sagittaMm = StepLimits.SAGITTA_EDGES * edgeMm;
    double growthMm = 0;
    boolean voxels = false;
    for (BodyVerifier pair : pairs) {
      if (pair != null && pair.solid == mover) {
        voxels = true;
        growthMm = Math.max(growthMm, pair.levels.growthMm());
      }
    }
    hasOwnVoxels = voxels;
    reachMm = mover.reachMm + growthMm;
  }

  /** Returns the committed pose of the reference point; not to be written. */
  Pose pose() {
    return mover.pose;
  }

  /** Returns the pair with another mover by the other's index; null if the two never meet. */
  BodyVerifier pair(int other) {
    return pairs[other];
  }

  private boolean isPresent(int other) {
    return pairs[other] != null && pairs[other].isPresent();
  }

  private boolean carriesPoints(int other) {
    return pairs[other].points == mover;
  }

  /** Returns the number of points tested so far; see {@link BodyVerifier#tested}. */
  long tested() {
    long sum = 0;
    for (BodyVerifier pair : pairs) {
      sum += pair == null ? 0 : pair.tested();
    }
    return sum;
  }

  /** Adds the work that was skipped for all pairs. */
  void addSkips(SkipCounters dest) {
    for (BodyVerifier pair : pairs) {
      if (pair != null) {
        pair.addSkips(dest);
      }
    }
  }

  /**
   * Returns the number of points that keep less than the full clearance in some pair. A pair counts
   * as at least 1 as long as it is not known that no solid is enclosed.
   */
  int reducedCount() {
    int sum = 0;
    boolean pending = false;
    for (int n = 0; n < pairs.length; n++) {
      if (isPresent(n)) {
        sum += pairs[n].reducedCount();
        pending |= pairs[n].enclosure().isPending();
      }
    }
    return sum == 0 && pending ? 1 : sum;
  }

  /**
   * Places the mover at a pose without a motion. If it returns false, it must be placed elsewhere
   * before any motion.
   *
   * @param newPose finite, with a unit quaternion
   * @param fullClearance whether all points must keep the full clearance
   * @return whether the pose is free
   */
  boolean place(Pose newPose, boolean fullClearance) {
    mover.setPresent(true);
    mover.propose(newPose);
    for (int n = 0; n < pairs.length; n++) {
      if (isPresent(n) && !placePair(n, fullClearance)) {
        return false;
      }
    }
    for (int n = 0; n < pairs.length; n++) {
      if (isPresent(n) && enclosesAny(n)) {
        return false;
      }
    }
    mover.commit();
    for (int n = 0; n < pairs.length; n++) {
      if (isPresent(n)) {
        pairs[n].enclosure().beginOrEnd();
      }
    }
    return true;
  }

  private boolean placePair(int n, boolean fullClearance) {
    BodyVerifier pair = pairs[n];
    return pair.place(poseOfPoints(n), poseOfVoxels(n), fullClearance ? pair.levels.highest : 0);
  }

  private boolean enclosesAny(int n) {
    return pairs[n].enclosure().enclosesAny(poseOfPoints(n), poseOfVoxels(n));
  }

  private Pose poseOfPoints(int n) {
    return carriesPoints(n) ? mover.candidate : pairs[n].points.pose;
  }

  private Pose poseOfVoxels(int n) {
    return carriesPoints(n) ? pairs[n].solid.bodyPose() : mover.bodyCandidate();
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

  /** Applies the edits of all pairs since the last call, and returns the gravest outcome. */
  EditOutcome takeEdits() {
    EditOutcome outcome = EditOutcome.NONE;
    for (int n = 0; n < pairs.length; n++) {
      EditOutcome ofPair = isPresent(n) ? takeEdits(pairs[n]) : EditOutcome.NONE;
      outcome = ofPair.compareTo(outcome) > 0 ? ofPair : outcome;
    }
    return outcome;
  }

  private static EditOutcome takeEdits(BodyVerifier pair) {
    EnclosureCheck enclosure = pair.enclosure();
    boolean enclosedNothing = !enclosure.isPending() && pair.reducedCount() == 0;
    EditOutcome outcome = pair.takeEdits();
    if (outcome != EditOutcome.FREE) {
      return outcome;
    }
    if (enclosedNothing && enclosure.enclosesEdited()) {
      return EditOutcome.COLLIDING;
    }
    if (enclosure.isPending() || pair.reducedCount() > 0) {
      enclosure.begin();
    }
    return EditOutcome.FREE;
  }

  /** Proposes a motion from the committed pose to another, while the others stand still. */
  void propose(Pose proposal) {
    mover.propose(proposal);
    for (int n = 0; n < pairs.length; n++) {
      if (isPresent(n)) {
        pairs[n].propose(poseOfPoints(n), poseOfVoxels(n));
      }
    }
  }

  /**
   * Proposes a motion together with that of another mover, which has proposed its own. Only the
   * pair of the two sees both.
   */
  void proposeWith(int other, Pose proposal) {
    propose(proposal);
    BodyVerifier pair = pairs[other];
    pair.propose(pair.points.candidate, pair.solid.bodyCandidate());
  }

  /**
   * Whether chords cannot stand for the arcs of a step.
   *
   * @param shiftMm the motion of the reference point
   */
  boolean hasLargeArcs(double shiftMm, double turnRad) {
    return turnRad > largestTurn || (hasOwnVoxels && ownArcMm(shiftMm, turnRad) > sagittaMm);
  }

  /** Returns the largest part of a step, at most 1, whose chords can stand for its arcs. */
  double largestPart(double shiftMm, double turnRad) {
    double part = turnRad > largestTurn ? largestTurn / turnRad : 1;
    double arcMm = hasOwnVoxels ? ownArcMm(shiftMm, turnRad) : 0;
    return arcMm > sagittaMm ? Math.min(part, SHORTER * Math.sqrt(sagittaMm / arcMm)) : part;
  }

  private double ownArcMm(double shiftMm, double turnRad) {
    return ArcBound.ofTurningBody(shiftMm, turnRad, reachMm + shiftMm);
  }

  /**
   * Whether chords stand for the arcs in the pair with another mover, if both move in one step.
   *
   * @param shiftMm the motion of this mover's reference point
   * @param otherShiftMm the motion of the other's
   * @param turnRad the larger of both rotations
   */
  boolean keepsChordsWith(int other, double shiftMm, double otherShiftMm, double turnRad) {
    BodyVerifier pair = pairs[other];
    double radiusMm = pair.points.shape.radiusMm();
    double shiftsMm = shiftMm + otherShiftMm + turnRad * radiusMm;
    double farMm = pair.solid.reachMm + pair.levels.growthMm() + shiftsMm;
    double arcMm = ArcBound.ofTurningBody(shiftsMm, turnRad, farMm + radiusMm);
    return arcMm <= sagittaMm;
  }

  /**
   * Whether no leg of the proposal touches a solid; see {@link BodyVerifier#isFree}.
   *
   * @param shiftMm the motion of the reference point
   * @param turnRad the rotation, if chords cannot stand for arcs; else 0
   */
  boolean isFree(double shiftMm, double turnRad, boolean firstOnly, LegHits hits) {
    boolean free = true;
    for (int n = 0; n < pairs.length; n++) {
      if (isPresent(n)) {
        hits.setBody(n);
        free &= pairs[n].isFree(arcs(n, shiftMm, turnRad), firstOnly, hits);
        if (!free && (firstOnly || hits.isFull() || turnRad != 0)) {
          return false;
        }
      }
    }
    return free;
  }

  /** Whether no leg of the proposal touches a solid in any pair but the one with another mover. */
  boolean isFreeOfAllBut(int other, LegHits hits) {
    for (int n = 0; n < pairs.length; n++) {
      if (n != other && isPresent(n)) {
        hits.setBody(n);
        if (!pairs[n].isFree(null, true, hits)) {
          return false;
        }
      }
    }
    return true;
  }

  private ArcBound arcs(int n, double shiftMm, double turnRad) {
    if (turnRad == 0) {
      return null;
    }
    if (carriesPoints(n)) {
      pointsTurn.setPointsTurn(turnRad);
      return pointsTurn;
    }
    pairs[n].points.pose.inverseTransform(mover.pose.translation, centre);
    bodyTurns.setBodyTurns(shiftMm, turnRad, centre.x, centre.y, centre.z);
    return bodyTurns;
  }

  /** Whether the leg of one point of the pair with another mover touches no solid. */
  boolean isPointFree(int other, int point, LegHits hits) {
    hits.setBody(other);
    return pairs[other].isPointFree(point, hits);
  }

  /** Commits the proposal. {@link #isFree} must have found it free. */
  void commit() {
    mover.commit();
    for (int n = 0; n < pairs.length; n++) {
      if (isPresent(n)) {
        pairs[n].commit();
      }
    }
  }

  /** Returns the mover to an earlier committed pose. Nothing else may have moved since then. */
  void takeBack(Pose earlier) {
    propose(earlier);
    commit();
  }

  /**
   * Raises the {@link ClearanceLevels} of points that have moved away from a body. Tests at most
   * {@code most} points for each pair, and returns the number of points tested.
   */
  int raiseLevels(int most) {
    int sum = 0;
    for (int n = 0; n < pairs.length; n++) {
      if (isPresent(n)) {
        sum += pairs[n].raiseLevels(most);
      }
    }
    return sum;
  }

  /** Writes the grid coordinates of a point of the pair with another mover, at present. */
  Vec3 gridPosition(int other, int point, Vec3 dest) {
    BodyVerifier pair = pairs[other];
    return pair.from.transform(pair.points.shape.point(point, dest), dest);
  }

  /** Writes the position of a point of the pair with another mover in the frame of this one, mm. */
  Vec3 ownPosition(int other, int point, Vec3 dest) {
    Mover points = pairs[other].points;
    points.shape.point(point, dest);
    return points == mover
        ? dest
        : mover.pose.inverseTransform(points.pose.transform(dest, dest), dest);
  }

  /**
   * Returns the sign of the direction in which a contact pushes this mover: 1 along the normal of
   * the surface if it carries the points, else -1.
   */
  int pushSign(int other) {
    return carriesPoints(other) ? 1 : -1;
  }
}
