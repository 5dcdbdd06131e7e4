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
 * <p>A mover may carry others along as if they were glued to it. Each of them is verified against
 * all others in the same way, and those that move together against each other, because poses are
 * rounded. The number of a pair is the index in the group of the mover that is carried, times the
 * number of all movers, plus the index of the other mover. A mover that carries none has index 0,
 * so that its pairs have the indices of the others.
 *
 * <p>Haptic thread only; allocates nothing.
 */
final class MoverVerifier {
  /** Shortens a step to its limit, against the rounding of a square root. */
  private static final double SHORTER = 1 - 1e-9;

  final Mover mover;

  private final BodyVerifier[] pairs;
  private final ContactField[] fields;
  private final double edgeMm;
  private final double sagittaMm;

  /** The distance from the reference point within which points of pairs can touch the mover, mm. */
  private final double soleReachMm;

  private final boolean hasSoleVoxels;

  /** This, and those that it carries along. */
  private final MoverVerifier[] group;

  /** The pose of each of the group in the frame of this one's sample points. */
  private final Pose[] inFrame;

  /** The pose that each of the group had when this one stood at {@link #joinedAt}. */
  private final Pose[] joined;

  private final Pose joinedAt = new Pose();
  private int groupSize = 1;
  private double largestTurn;
  private double radiusMm;
  private double reachMm;
  private boolean hasOwnVoxels;

  /** The numbers of the pairs; one that the group has twice stands here once. */
  private final int[] numbers;

  private int count;
  private final LegHits within = new LegHits();
  private final Pose carried = new Pose();
  private final ArcBound pointsTurn = new ArcBound();
  private final ArcBound bodyTurns = new ArcBound();
  private final Vec3 centre = new Vec3();

  /**
   * Creates a verifier.
   *
   * @param pairs by the index of the other mover; null where the two never move against each other
   * @param fields the surface of each pair
   * @param edgeMm the shortest voxel edge of the scene
   */
  MoverVerifier(Mover mover, BodyVerifier[] pairs, ContactField[] fields, double edgeMm) {
    this.mover = mover;
    this.pairs = pairs;
    this.fields = fields;
    this.edgeMm = edgeMm;
    group = new MoverVerifier[pairs.length];
    numbers = new int[pairs.length * pairs.length];
    inFrame = new Pose[pairs.length];
    joined = new Pose[pairs.length];
    for (int m = 0; m < pairs.length; m++) {
      inFrame[m] = new Pose();
      joined[m] = new Pose();
    }
    group[0] = this;
    sagittaMm = StepLimits.SAGITTA_EDGES * edgeMm;
    double growthMm = 0;
    boolean voxels = false;
    for (BodyVerifier pair : pairs) {
      if (pair != null && pair.solid == mover) {
        voxels = true;
        growthMm = Math.max(growthMm, pair.levels.growthMm());
      }
    }
    hasSoleVoxels = voxels;
    soleReachMm = mover.reachMm + growthMm;
    updateGroup();
  }

  /** Carries another mover along from now on, where it is. It must move alone so far. */
  void carry(MoverVerifier other) {
    assert other.mover.carrier == other.mover && other.groupSize == 1 : "moves with others already";
    joinedAt.set(pose());
    group[groupSize] = other;
    other.mover.carrier = mover;
    ReferencePose.relative(pose(), other.pose(), inFrame[groupSize++]);
    for (int m = 1; m < groupSize; m++) {
      joined[m].set(group[m].pose()); // those that joined before may have moved since
    }
    updateGroup();
  }

  /** Carries no other along from now on; all stay where they are. */
  void carryNone() {
    while (groupSize > 1) {
      Mover other = group[--groupSize].mover;
      other.carrier = other;
    }
    updateGroup();
  }

  /** Finds how far the group reaches from the reference point, and its pairs. */
  private void updateGroup() {
    count = 0;
    radiusMm = 0;
    reachMm = 0;
    hasOwnVoxels = false;
    for (int m = 0; m < groupSize; m++) {
      MoverVerifier each = group[m];
      pose().inverseTransform(each.pose().translation, centre);
      double awayMm = m == 0 ? 0 : centre.length() * (1 + 1e-9);
      radiusMm = Math.max(radiusMm, awayMm + each.mover.shape.radiusMm());
      reachMm = Math.max(reachMm, awayMm + each.soleReachMm);
      hasOwnVoxels |= each.hasSoleVoxels;
      for (int n = 0; n < pairs.length; n++) {
        BodyVerifier pair = each.pairs[n];
        if (pair != null && (pair.points == each.mover || !isWithin(pair))) {
          numbers[count++] = m * pairs.length + n;
        }
      }
    }
    largestTurn = StepLimits.largestTurn(radiusMm, edgeMm);
  }

  /** Whether this moves along with another. */
  boolean isCarried() {
    return mover.carrier != mover;
  }

  /** Returns the largest distance of a sample point of the group from the reference point, mm. */
  double radiusMm() {
    return radiusMm;
  }

  /** Returns the committed pose of the reference point; not to be written. */
  Pose pose() {
    return mover.pose;
  }

  /** Returns a pair by its number; null if the two never meet. */
  BodyVerifier pair(int number) {
    return group[number / pairs.length].pairs[number % pairs.length];
  }

  /** Returns the surface of a pair by its number. */
  ContactField field(int number) {
    return group[number / pairs.length].fields[number % pairs.length];
  }

  /** Returns the index of the mover that a pair has outside the group. */
  int other(int number) {
    return number % pairs.length;
  }

  /** Whether a mover belongs to the group. */
  private boolean moves(Mover one) {
    return one.carrier == mover;
  }

  private boolean isWithin(BodyVerifier pair) {
    return moves(pair.points) && moves(pair.solid);
  }

  /** Returns the number of points tested so far; see {@link BodyVerifier#tested}. */
  long tested() {
    long sum = 0;
    for (int n = 0; n < count; n++) {
      sum += pair(numbers[n]).tested();
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
    for (int n = 0; n < count; n++) {
      BodyVerifier pair = pair(numbers[n]);
      if (pair.isPresent()) {
        sum += pair.reducedCount();
        pending |= pair.enclosure().isPending();
      }
    }
    return sum == 0 && pending ? 1 : sum;
  }

  /**
   * Places the mover, which carries no other, at a pose without a motion. If it returns false, it
   * must be placed elsewhere before any motion.
   *
   * @param newPose finite, with a unit quaternion
   * @param fullClearance whether all points must keep the full clearance
   * @return whether the pose is free
   */
  boolean place(Pose newPose, boolean fullClearance) {
    mover.setPresent(true);
    mover.propose(newPose);
    for (BodyVerifier pair : pairs) {
      if (isPresent(pair)) {
        int least = fullClearance ? pair.levels.highest : 0;
        if (!pair.place(poseOfPoints(pair), poseOfVoxels(pair), least)) {
          return false;
        }
      }
    }
    for (BodyVerifier pair : pairs) {
      if (isPresent(pair) && pair.enclosure().enclosesAny(poseOfPoints(pair), poseOfVoxels(pair))) {
        return false;
      }
    }
    mover.commit();
    for (BodyVerifier pair : pairs) {
      if (isPresent(pair)) {
        pair.enclosure().beginOrEnd();
      }
    }
    return true;
  }

  private static boolean isPresent(BodyVerifier pair) {
    return pair != null && pair.isPresent();
  }

  private Pose poseOfPoints(BodyVerifier pair) {
    return moves(pair.points) ? pair.points.candidate : pair.points.pose;
  }

  private Pose poseOfVoxels(BodyVerifier pair) {
    return moves(pair.solid) ? pair.solid.bodyCandidate() : pair.solid.bodyPose();
  }

  /** Applies the edits of all pairs since the last call, and returns the gravest outcome. */
  Mover.EditOutcome takeEdits() {
    Mover.EditOutcome outcome = Mover.EditOutcome.NONE;
    for (BodyVerifier pair : pairs) {
      Mover.EditOutcome ofPair = isPresent(pair) ? takeEdits(pair) : Mover.EditOutcome.NONE;
      outcome = ofPair.compareTo(outcome) > 0 ? ofPair : outcome;
    }
    return outcome;
  }

  private static Mover.EditOutcome takeEdits(BodyVerifier pair) {
    EnclosureCheck enclosure = pair.enclosure();
    boolean enclosedNothing = !enclosure.isPending() && pair.reducedCount() == 0;
    Mover.EditOutcome outcome = pair.takeEdits();
    if (outcome != Mover.EditOutcome.FREE) {
      return outcome;
    }
    if (enclosedNothing && enclosure.enclosesEdited()) {
      return Mover.EditOutcome.COLLIDING;
    }
    if (enclosure.isPending() || pair.reducedCount() > 0) {
      enclosure.begin();
    }
    return Mover.EditOutcome.FREE;
  }

  /** Proposes a motion from the committed pose to another, while the others stand still. */
  void propose(Pose proposal) {
    mover.propose(proposal);
    for (int m = 1; m < groupSize; m++) {
      group[m].mover.propose(carriedPose(m, proposal));
    }
    for (int n = 0; n < count; n++) {
      BodyVerifier pair = pair(numbers[n]);
      if (pair.isPresent()) {
        pair.propose(poseOfPoints(pair), poseOfVoxels(pair));
      }
    }
  }

  /** Whether a device takes announcements; see {@link #announce}. */
  boolean takesAnnouncements() {
    boolean takes = false;
    for (int n = 0; n < count && !takes; n++) {
      takes = pair(numbers[n]).screen.takesAnnouncements();
    }
    return takes;
  }

  /**
   * Announces the present proposal to devices, so that they judge it in the launch for another one.
   *
   * @param first whether to forget those that were announced before
   */
  void announce(boolean first) {
    for (int n = 0; n < count; n++) {
      pair(numbers[n]).announce(first);
    }
  }

  /** Returns the pose of one of the group if this one has a pose. */
  private Pose carriedPose(int member, Pose own) {
    return own.sameBits(joinedAt)
        ? joined[member]
        : ReferencePose.glued(own, inFrame[member], carried);
  }

  /**
   * Proposes a motion together with that of another mover, which has proposed its own. Only the
   * pair of the two sees both. Neither carries others.
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
   * They never do for a group.
   *
   * @param shiftMm the motion of this mover's reference point
   * @param otherShiftMm the motion of the other's
   * @param turnRad the larger of both rotations
   */
  boolean keepsChordsWith(int other, double shiftMm, double otherShiftMm, double turnRad) {
    if (groupSize > 1) {
      return false;
    }
    BodyVerifier pair = pairs[other];
    double pointsMm = pair.points.shape.radiusMm();
    double shiftsMm = shiftMm + otherShiftMm + turnRad * pointsMm;
    double farMm = pair.solid.reachMm + pair.levels.growthMm() + shiftsMm;
    double arcMm = ArcBound.ofTurningBody(shiftsMm, turnRad, farMm + pointsMm);
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
    for (int n = 0; n < count; n++) {
      BodyVerifier pair = pair(numbers[n]);
      if (!pair.isPresent()) {
        continue;
      }
      if (isWithin(pair)) {
        within.clear();
        if (!pair.isFree(null, true, within)) {
          return false; // Rounding alone moves the two against each other: no contact could help.
        }
      } else {
        hits.setBody(numbers[n]);
        free &= pair.isFree(arcs(pair, shiftMm, turnRad), firstOnly, hits);
        if (!free && (firstOnly || hits.isFull() || turnRad != 0)) {
          return false;
        }
      }
    }
    return free;
  }

  /**
   * Whether no leg of the proposal touches a solid in any pair but the one with another mover. This
   * one carries no others.
   */
  boolean isFreeOfAllBut(int other, LegHits hits) {
    for (int n = 0; n < pairs.length; n++) {
      if (n != other && isPresent(pairs[n])) {
        hits.setBody(n);
        if (!pairs[n].isFree(null, true, hits)) {
          return false;
        }
      }
    }
    return true;
  }

  private ArcBound arcs(BodyVerifier pair, double shiftMm, double turnRad) {
    if (turnRad == 0) {
      return null;
    }
    pair.points.pose.inverseTransform(mover.pose.translation, centre);
    if (moves(pair.points)) {
      pointsTurn.setPointsTurn(turnRad, centre);
      return pointsTurn;
    }
    bodyTurns.setBodyTurns(shiftMm, turnRad, centre);
    return bodyTurns;
  }

  /** Whether the leg of one point of a pair touches no solid. */
  boolean isPointFree(int number, int point, LegHits hits) {
    hits.setBody(number);
    return pair(number).isPointFree(point, hits);
  }

  /** Commits the proposal. {@link #isFree} must have found it free. */
  void commit() {
    for (int m = 0; m < groupSize; m++) {
      group[m].mover.commit();
    }
    for (int n = 0; n < count; n++) {
      BodyVerifier pair = pair(numbers[n]);
      if (pair.isPresent()) {
        pair.commit();
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
    for (int n = 0; n < count; n++) {
      BodyVerifier pair = pair(numbers[n]);
      if (pair.isPresent()) {
        sum += pair.raiseLevels(most);
      }
    }
    return sum;
  }

  /** Converts a position from the frame of a pair's points to the frame of this mover, mm. */
  Vec3 ownPosition(int number, Vec3 position, Vec3 dest) {
    Mover points = pair(number).points;
    return points == mover
        ? dest.set(position)
        : mover.pose.inverseTransform(points.pose.transform(position, dest), dest);
  }

  /**
   * Returns the sign of the direction in which a contact pushes this mover: 1 along the normal of
   * the surface if the group carries the points, else -1.
   */
  int pushSign(int number) {
    return moves(pair(number).points) ? 1 : -1;
  }
}
