package org.palpate.rigid;

import org.palpate.geometry.ArcBound;
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
  private static final int NOBODY = -1;

  final Mover mover;

  /** Limits of the steps of the mover and of those that it carries along. */
  final StepLimits limits;

  private final BodyVerifier[] pairs;
  private final ContactField[] fields;
  private final MoverBroadPhase broadPhase;
  private final boolean skips;

  /** The distance from the reference point within which points of pairs can touch the mover, mm. */
  private final double soleReachMm;

  private final boolean hasSoleVoxels;

  /** This, and those that it carries along. */
  private final MoverGroup group;

  private double radiusMm;

  /** The radius of the ball around the reference point that holds the group, mm. */
  private double boundMm;

  private boolean hasOwnVoxels;

  /** The numbers of the pairs; one that the group has twice stands here once. */
  private final int[] numbers;

  private int count;

  /** The bits of the movers that the proposal may touch, by index. */
  private final long[] found;

  /** The numbers of the pairs that the proposal concerns. */
  private final int[] proposed;

  private int proposedCount;
  private long tested;
  private final LegHits within = new LegHits();
  private final ArcBound pointsTurn = new ArcBound();
  private final ArcBound bodyTurns = new ArcBound();
  private final Vec3 centre = new Vec3();

  /**
   * Creates a verifier.
   *
   * @param pairs by the index of the other mover; null where the two never move against each other
   * @param fields the surface of each pair
   * @param broadPhase the broad phase of the scene
   * @param limits the limits of steps, which this sets
   * @param skips whether to leave out pairs that the broad phase does not find; answers are the
   *     same
   */
  MoverVerifier(
      Mover mover,
      BodyVerifier[] pairs,
      ContactField[] fields,
      MoverBroadPhase broadPhase,
      StepLimits limits,
      boolean skips) {
    this.mover = mover;
    this.pairs = pairs;
    this.fields = fields;
    this.broadPhase = broadPhase;
    this.limits = limits;
    this.skips = skips;
    found = new long[(pairs.length + 63) / 64];
    proposed = new int[pairs.length * pairs.length];
    group = new MoverGroup(this, pairs.length);
    numbers = new int[pairs.length * pairs.length];
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
    group.add(other);
    updateGroup();
  }

  /** Carries no other along from now on; all stay where they are. */
  void carryNone() {
    group.dissolve();
    updateGroup();
  }

  /** Whether this carries others along. */
  boolean carriesOthers() {
    return group.size() > 1;
  }

  /** Finds how far the group reaches from the reference point, and its pairs. */
  private void updateGroup() {
    count = 0;
    proposedCount = 0;
    radiusMm = 0;
    boundMm = 0;
    double reachMm = 0;
    hasOwnVoxels = false;
    for (int m = 0; m < group.size(); m++) {
      MoverVerifier each = group.member(m);
      double awayMm = group.awayMm(m);
      radiusMm = Math.max(radiusMm, awayMm + each.mover.shape.radiusMm());
      reachMm = Math.max(reachMm, awayMm + each.soleReachMm);
      boundMm = Math.max(boundMm, awayMm + each.soleBoundMm());
      hasOwnVoxels |= each.hasSoleVoxels;
      for (int n = 0; n < pairs.length; n++) {
        BodyVerifier pair = each.pairs[n];
        if (pair != null && (pair.points == each.mover || !isWithin(pair))) {
          numbers[count++] = m * pairs.length + n;
        }
      }
    }
    limits.set(radiusMm, reachMm, hasOwnVoxels);
  }

  private double soleBoundMm() {
    double pointsMm = mover.shape.radiusMm() * (1 + 1e-9);
    return hasSoleVoxels ? Math.max(pointsMm, soleReachMm + mover.marginMm()) : pointsMm;
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
    return group.member(number / pairs.length).pairs[number % pairs.length];
  }

  /** Returns the surface of a pair by its number. */
  ContactField field(int number) {
    return group.member(number / pairs.length).fields[number % pairs.length];
  }

  /** Returns the index of the mover that a pair has outside the group. */
  int other(int number) {
    return number % pairs.length;
  }

  private boolean isWithin(BodyVerifier pair) {
    return group.contains(pair.points) && group.contains(pair.solid);
  }

  /** Returns the number of points tested so far; see {@link BodyVerifier#tested}. */
  long tested() {
    return tested;
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
    proposedCount = 0;
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
    return group.contains(pair.points) ? pair.points.candidate : pair.points.pose;
  }

  private Pose poseOfVoxels(BodyVerifier pair) {
    return group.contains(pair.solid) ? pair.solid.bodyCandidate() : pair.solid.bodyPose();
  }

  /** Applies the edits of all pairs since the last call, and returns the gravest outcome. */
  Mover.EditOutcome takeEdits() {
    broadPhase.takeEdits();
    Mover.EditOutcome outcome = Mover.EditOutcome.NONE;
    for (BodyVerifier pair : pairs) {
      Mover.EditOutcome ofPair =
          isPresent(pair) ? pair.enclosure().takeEdits() : Mover.EditOutcome.NONE;
      outcome = ofPair.compareTo(outcome) > 0 ? ofPair : outcome;
    }
    return outcome;
  }

  /** Proposes a motion from the committed pose to another, while the others stand still. */
  void propose(Pose proposal) {
    propose(proposal, NOBODY);
  }

  /**
   * Proposes a motion.
   *
   * @param always the index of a mover that counts as found
   */
  private void propose(Pose proposal, int always) {
    group.propose(proposal);
    find(proposal, always);
    for (int n = 0; n < proposedCount; n++) {
      BodyVerifier pair = pair(proposed[n]);
      pair.propose(poseOfPoints(pair), poseOfVoxels(pair));
    }
  }

  /** Finds the pairs that a motion concerns: those that may touch or, without skips, all. */
  private void find(Pose proposal, int always) {
    broadPhase.find(pose().translation, proposal.translation, sweptRadiusMm(proposal), found);
    if (always != NOBODY) {
      found[always >> 6] |= 1L << always;
    }
    proposedCount = 0;
    for (int n = 0; n < count; n++) {
      if ((!skips || isFound(numbers[n])) && pair(numbers[n]).isPresent()) {
        proposed[proposedCount++] = numbers[n];
      }
    }
  }

  /** Whether the broad phase finds the other mover of a pair for the proposal. */
  boolean isFound(int number) {
    int other = other(number);
    return (found[other >> 6] >>> other & 1) != 0;
  }

  /**
   * Returns the radius of a ball about the reference point. What stays outside it while its centre
   * moves to a proposed pose touches nothing of the group.
   */
  private double sweptRadiusMm(Pose proposal) {
    double shiftMm = proposal.translation.sub(pose().translation, centre).length();
    return hasOwnVoxels
        ? ArcBound.sweptRadiusMm(boundMm, shiftMm, pose().rotation, proposal.rotation)
        : boundMm;
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
    for (int n = 0; n < proposedCount; n++) {
      pair(proposed[n]).announce(first);
    }
  }

  /**
   * Proposes a motion together with that of another mover, which has proposed its own. Only the
   * pair of the two sees both. Neither carries others.
   */
  void proposeWith(int other, Pose proposal) {
    propose(proposal, other);
    BodyVerifier pair = pairs[other];
    pair.propose(pair.points.candidate, pair.solid.bodyCandidate());
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
    if (carriesOthers()) {
      return false;
    }
    BodyVerifier pair = pairs[other];
    double pointsMm = pair.points.shape.radiusMm();
    double shiftsMm = shiftMm + otherShiftMm + turnRad * pointsMm;
    double farMm = pair.solid.reachMm + pair.levels.growthMm() + shiftsMm;
    return limits.keepsChords(ArcBound.ofTurningBody(shiftsMm, turnRad, farMm + pointsMm));
  }

  /**
   * Whether no leg of the proposal touches a solid; see {@link BodyVerifier#isFree}.
   *
   * @param shiftMm the motion of the reference point
   * @param turnRad the rotation, if chords cannot stand for arcs; else 0
   */
  boolean isFree(double shiftMm, double turnRad, boolean firstOnly, LegHits hits) {
    boolean free = true;
    for (int n = 0; n < proposedCount; n++) {
      int number = proposed[n];
      BodyVerifier pair = pair(number);
      if (isWithin(pair)) {
        within.clear();
        if (!isFree(number, null, true, within)) {
          return false; // Rounding alone moves the two against each other: no contact could help.
        }
      } else {
        hits.setBody(number);
        free &= isFree(number, arcs(pair, shiftMm, turnRad), firstOnly, hits);
        if (!free && (firstOnly || hits.isFull() || turnRad != 0)) {
          return false;
        }
      }
    }
    return free;
  }

  /**
   * Whether no leg of a pair touches a solid. Without skips a pair that is not found is verified
   * too. Its work does not count, as with skips, and its arcs are known to be free.
   */
  private boolean isFree(int number, ArcBound arcs, boolean firstOnly, LegHits hits) {
    BodyVerifier pair = pair(number);
    boolean counts = isFound(number);
    long before = pair.tested();
    boolean free = pair.isFree(counts ? arcs : null, firstOnly, hits);
    tested += counts ? pair.tested() - before : 0;
    return free;
  }

  /**
   * Whether no leg of the proposal touches a solid in any pair but the one with another mover. This
   * one carries no others.
   */
  boolean isFreeOfAllBut(int other, LegHits hits) {
    for (int n = 0; n < proposedCount; n++) {
      if (proposed[n] != other) {
        hits.setBody(proposed[n]);
        if (!isFree(proposed[n], null, true, hits)) {
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
    if (group.contains(pair.points)) {
      pointsTurn.setPointsTurn(turnRad, centre);
      return pointsTurn;
    }
    bodyTurns.setBodyTurns(shiftMm, turnRad, centre);
    return bodyTurns;
  }

  /** Whether the leg of one point of a pair touches no solid. */
  boolean isPointFree(int number, int point, LegHits hits) {
    hits.setBody(number);
    tested++;
    return (skips && !isFound(number)) || pair(number).isPointFree(point, hits);
  }

  /** Commits the proposal. {@link #isFree} must have found it free. */
  void commit() {
    group.commit();
    for (int n = 0; n < proposedCount; n++) {
      pair(proposed[n]).commit();
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
    return group.contains(pair(number).points) ? 1 : -1;
  }
}
