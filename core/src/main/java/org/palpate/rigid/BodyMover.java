package org.palpate.rigid;

import java.util.Arrays;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.rigid.tool.SphereTree;

/**
 * Moves bodies towards goal poses, each by one verified step a frame, in the order of their
 * indices. A step follows the straight interpolation to the goal. If it is blocked, shorter ones
 * are tried, down to a sixteenth.
 *
 * <p>The work of a frame is bounded over all bodies. Once it is spent, the bodies that are left
 * wait, and the next frame begins with them. The bodies before them have no turn in that frame. So
 * the order within a frame is always the same, and poses as committed replay to the same bits.
 *
 * <p>A body that another body blocks is held back. A body that only the tool blocks pushes it: the
 * tool is carried along as if it were glued to the body, and follows its device again afterwards.
 * If the carried tool is not free, or would be pushed too far from its device, the body is held
 * back. A goal that is held back stays the goal.
 *
 * <p>Each motion is verified against all others before it is committed. Haptic thread only;
 * allocates nothing.
 */
public final class BodyMover {
  /**
   * The farthest that a push takes the tool from its device pose in the kinetic metric, shortest
   * edges of the scene.
   */
  public static final double FARTHEST_PUSH_EDGES = 16;

  /** The part of w_max that pushes may use in a frame, so that the tool can follow its device. */
  private static final double PUSHED_PART = 0.5;

  /**
   * Steps stop this much short of their limits. So a step that was limited and is repeated as a
   * goal, as a replay does, is within the limits despite rounding and is taken whole.
   */
  private static final double SHORT_OF_LIMIT = 1 - 1e-9;

  /** The smallest part of a blocked step that is tried. */
  private static final double SMALLEST_PART = 1.0 / 16;

  /** The number of points whose clearance levels are tested after a motion, for each pair. */
  private static final int LEVELS_PER_STEP = 100;

  /**
   * The work after which a frame moves no further body, in the unit of {@link WorkBudget}. A frame
   * begins the last step below it, so it exceeds the limit by less than one step.
   */
  static final long MOST_WORK = WorkBudget.LEAST_BUDGET;

  private final RigidScene scene;
  private final double maxStepMm;
  private final double farthestMm;
  private final Pose[] goals;
  private final boolean[] hasGoal;
  private final LegHits hits = new LegHits();
  private final Pose candidate = new Pose();
  private final Pose carried = new Pose();
  private final Quaternion turned = new Quaternion();
  private final Quaternion scratch = new Quaternion();
  private final Vec3 shift = new Vec3();
  private final Vec3 turn = new Vec3();
  private final Vec3 handShift = new Vec3();
  private final Vec3 handTurn = new Vec3();

  /** The index of the body with which the next frame begins. */
  private int first;

  private long work;
  private long pushes;
  private long heldBack;
  private final ClearCheck clearCheck;

  BodyMover(RigidScene scene) {
    this.scene = scene;
    clearCheck = new ClearCheck(scene);
    maxStepMm = scene.settings().maxStepMm();
    farthestMm = FARTHEST_PUSH_EDGES * scene.bodies().shortestEdgeMm();
    goals = new Pose[scene.bodies().count()];
    hasGoal = new boolean[goals.length];
    for (int n = 0; n < goals.length; n++) {
      goals[n] = new Pose();
    }
  }

  /**
   * Sets the goal of a body, which the next frames approach.
   *
   * @param body the index of the body in the scene
   * @param goal from rest to present, world mm
   * @throws IllegalArgumentException if the body cannot move, or the pose is not finite or has no
   *     unit quaternion
   */
  public void setGoal(int body, Pose goal) {
    requireGoal(body, goal);
    Mover mover = scene.verifier(body).mover;
    mover.toReference(ReferencePose.snap(candidate.set(goal)), goals[body]);
    ReferencePose.snap(goals[body]);
    hasGoal[body] = true;
  }

  /**
   * Checks that {@link #setGoal} would take a goal. Any thread.
   *
   * @param body the index of the body in the scene
   * @param goal from rest to present, world mm
   * @throws IllegalArgumentException as {@link #setGoal}
   */
  public void requireGoal(int body, Pose goal) {
    scene.requireMovable(body);
    if (!goal.isFinite() || !goal.rotation.isUnit()) {
      throw new IllegalArgumentException(
          "the goal of a body must be finite with a unit quaternion: goal=" + goal);
    }
  }

  /**
   * Lets a body stay where it is.
   *
   * @param body the index of the body in the scene
   */
  public void clearGoal(int body) {
    hasGoal[body] = false;
  }

  /** Lets all bodies stay where they are. */
  public void clearGoals() {
    Arrays.fill(hasGoal, false);
  }

  /** {@return the check whether a body would be clear of another one at a pose; for undo} */
  public ClearCheck clearCheck() {
    return clearCheck;
  }

  /** {@return the number of steps in which a body pushed the tool} */
  public long pushes() {
    return pushes;
  }

  /** {@return the number of frames in which a body was held back, counted for each body} */
  public long heldBack() {
    return heldBack;
  }

  /**
   * {@return the most sample points of bodies that kept less than their clearance from other bodies
   * at any time}
   */
  public int mostReducedPoints() {
    return scene.mostReducedPoints();
  }

  /** Whether a body has a goal that it has not reached. */
  boolean hasWork() {
    for (int n = 0; n < goals.length; n++) {
      if (isOnItsWay(n)) {
        return true;
      }
    }
    return false;
  }

  /** Returns the work of the last frame: the number of points that were tested. */
  long work() {
    return work;
  }

  /**
   * Moves each body that has not reached its goal, by one step, until the work is spent. The next
   * frame begins with the first body that had to wait.
   *
   * @param hand the index of what the device moves: the tool, or a body that is held
   * @param device the device pose that the tool follows
   * @param motion gets the motions of the bodies, and the pushes of the tool
   */
  void move(int hand, Pose device, ToolMotion motion) {
    work = 0;
    int begin = first;
    first = 0;
    for (int n = begin; n < goals.length; n++) {
      if (n != hand && isOnItsWay(n)) {
        if (work >= MOST_WORK) {
          first = n;
          return;
        }
        moveBody(n, hand, device, motion);
      }
    }
  }

  private boolean isOnItsWay(int n) {
    MoverVerifier body = scene.verifier(n);
    return hasGoal[n] && !body.isCarried() && !body.pose().sameBits(goals[n]);
  }

  private void moveBody(int index, int hand, Pose device, ToolMotion motion) {
    MoverVerifier body = scene.verifier(index);
    body.pose().differenceTo(goals[index], shift, turn, scratch);
    double part = longestPart(body);
    double shiftMm = shift.length();
    double turnRad = turn.length();
    if (body.limits.hasLargeArcs(part * shiftMm, part * turnRad)) {
      propose(index, part);
      if (isFree(body, part * shiftMm, part * turnRad)) {
        commit(index, motion, BodyMotions.NO_STEP);
        return;
      }
      part = Math.min(part, SHORT_OF_LIMIT * body.limits.largestPart(shiftMm, turnRad));
    }
    double smallest = SMALLEST_PART * part;
    for (; part >= smallest; part /= 2) {
      propose(index, part);
      if (isFree(body, 0, 0)) {
        commit(index, motion, BodyMotions.NO_STEP);
        return;
      }
      if (isFreeOfAllBut(hand, body) && push(index, part, hand, device, motion)) {
        pushes++;
        return;
      }
    }
    heldBack++;
  }

  /** Returns the part of the way to the goal on which no point travels farther than w_max. */
  private double longestPart(MoverVerifier body) {
    double pathMm = shift.length() + turn.length() * body.mover.reachMm;
    return pathMm > maxStepMm ? SHORT_OF_LIMIT * maxStepMm / pathMm : 1;
  }

  private void propose(int index, double part) {
    MoverVerifier body = scene.verifier(index);
    if (part == 1) {
      candidate.set(goals[index]);
    } else {
      body.pose().displace(shift, turn, part, scratch, candidate);
      ReferencePose.snap(candidate);
    }
    body.propose(candidate);
  }

  private boolean isFree(MoverVerifier mover, double shiftMm, double turnRad) {
    hits.clear();
    long before = mover.tested();
    boolean free = mover.isFree(shiftMm, turnRad, true, hits);
    work += mover.tested() - before;
    return free;
  }

  private boolean isFreeOfAllBut(int hand, MoverVerifier body) {
    hits.clear();
    long before = body.tested();
    boolean free = body.isFreeOfAllBut(hand, hits);
    work += body.tested() - before;
    return free;
  }

  private void commit(int index, ToolMotion motion, int toolStep) {
    MoverVerifier body = scene.verifier(index);
    motion.bodies.add(index, body.mover.bodyPose(), body.mover.bodyCandidate(), toolStep);
    body.commit();
    work += body.raiseLevels(LEVELS_PER_STEP);
  }

  /**
   * Commits the proposed step of a body together with a step that carries the tool along, if that
   * is free and not too far.
   */
  private boolean push(int index, double part, int hand, Pose device, ToolMotion motion) {
    MoverVerifier body = scene.verifier(index);
    MoverVerifier tool = scene.verifier(hand);
    setCarried(body, tool);
    tool.pose().differenceTo(carried, handShift, handTurn, scratch);
    double pathMm = handShift.length() + handTurn.length() * tool.radiusMm();
    double turnRad = Math.max(part * turn.length(), handTurn.length());
    if (!motion.canBePushed()
        || motion.pathMm + pathMm > PUSHED_PART * maxStepMm
        || isTooFar(tool, device)
        || tool.limits.hasLargeArcs(handShift.length(), handTurn.length())
        || !tool.keepsChordsWith(index, handShift.length(), part * shift.length(), turnRad)) {
      return false;
    }
    tool.proposeWith(index, carried);
    if (!isFree(tool, 0, 0)) {
      return false;
    }
    int step = motion.steps;
    tool.commit();
    motion.addPush(carried, pathMm);
    commit(index, motion, step);
    return true;
  }

  /** Sets the pose of a tool that moves with the proposed step of a body as if glued to it. */
  private void setCarried(MoverVerifier body, MoverVerifier tool) {
    body.pose().rotation.conjugate(scratch);
    candidate.rotation.multiply(scratch, turned);
    tool.pose().translation.sub(body.pose().translation, carried.translation);
    turned.rotate(carried.translation, carried.translation);
    carried.translation.add(candidate.translation, carried.translation);
    turned.multiply(tool.pose().rotation, carried.rotation);
    carried.rotation.normalize();
    tool.mover.snap(carried);
  }

  /** Whether the carried tool would be too far from its device, and farther than it is now. */
  private boolean isTooFar(MoverVerifier tool, Pose device) {
    double awayMm = tool.mover.shape.metric().distance(carried, device);
    return awayMm > farthestMm && awayMm > tool.mover.shape.metric().distance(tool.pose(), device);
  }

  /**
   * Checks whether a body at a pose would keep its whole clearance from another one, and neither
   * would enclose the other. Each call checks a part. The other stays where it is; if it moves
   * meanwhile, or a voxel of the two changes, the answer means nothing. Haptic thread, between two
   * frames.
   */
  public static final class ClearCheck {
    /** More than the rounding of the place of a node, cells. */
    private static final double MARGIN_CELLS = 0.5;

    private final RigidScene scene;
    private final ExactRayCaster caster = new ExactRayCaster();
    private final Pose ofPoints = new Pose();
    private final Pose ofVoxels = new Pose();
    private final AffineMap toCells = new AffineMap();
    private final EnclosureCheck.Rows rows = new EnclosureCheck.Rows();
    private final Pose reference = new Pose();
    private final Vec3 position = new Vec3();
    private BodyVerifier pair;

    /** The node of the tree with which the check goes on. */
    private int node;

    private Answer answer = Answer.CLEAR;

    /** The finding of a check so far. */
    public enum Answer {
      /** Nothing, but points or voxels are left. */
      UNDECIDED,

      /** The body would be clear of the other one. */
      CLEAR,

      /** The body would not be clear of the other one. */
      BLOCKED
    }

    private ClearCheck(RigidScene scene) {
      this.scene = scene;
    }

    /**
     * {@return whether a body at a pose may be near another one where that is now; false only if
     * balls around the two are apart} Looks at no point.
     *
     * @param body the index of a body that can move
     * @param restToPresent the pose of that body, world mm
     * @param other the index of the other body
     */
    public boolean isNear(int body, Pose restToPresent, int other) {
      Mover one = scene.mover(body);
      Mover two = scene.mover(other);
      if (!two.canMove()) {
        return true;
      }
      position.set(one.toReference(restToPresent, reference).translation);
      // Undo may have set the pose of the body, and the mover not have taken it yet.
      position.sub(two.toReference(two.bodyPose(), reference).translation, position);
      ClearanceLevels levels = scene.pair(body, other).levels;
      double growthMm = levels.reachVoxels() * levels.body.grid().spacingMm().length();
      return !(position.length() > radiusMm(one) + radiusMm(two) + growthMm);
    }

    /** Returns the radius of a ball around the voxels and the sample points of a body, mm. */
    private static double radiusMm(Mover body) {
      return Math.max(body.reachMm, body.shape.radiusMm()) + body.marginMm();
    }

    /**
     * Begins a check. The last one is forgotten.
     *
     * @param body the index of a body that can move
     * @param restToPresent the pose of that body, world mm
     * @param other the index of the other body
     */
    public void begin(int body, Pose restToPresent, int other) {
      pair = scene.pair(body, other);
      boolean carriesPoints = pair.points == scene.mover(body);
      Pose ofOther = scene.bodies().body(other).pose();
      pair.points.toReference(carriesPoints ? restToPresent : ofOther, ofPoints);
      ofVoxels.set(carriesPoints ? ofOther : restToPresent);
      pair.levels.takeEdits();
      pair.levels.body.toolToGrid(ofVoxels, ofPoints, toCells);
      pair.levels.toCells(toCells, pair.levels.highest, toCells);
      node = 0;
      rows.begin();
      answer = Answer.UNDECIDED;
    }

    /** {@return what the check has found so far} */
    public Answer answer() {
      return answer;
    }

    /**
     * Goes on with the check. Looks at points first, then at enclosed voxels, as many as the check
     * of a frame may.
     *
     * @param mostPoints the most points and nodes of their tree to look at, up to one leaf more
     * @return the number of those that it looked at; {@code mostPoints} if it looked at voxels
     */
    public int goOn(int mostPoints) {
      int looked = lookAtPoints(mostPoints);
      if (answer != Answer.UNDECIDED || node < pair.points.shape.tree().nodes()) {
        return looked;
      }
      if (!pair.enclosure().canEnclose()) {
        answer = Answer.CLEAR;
        return looked;
      }
      answer =
          switch (pair.enclosure().examine(ofPoints, ofVoxels, rows)) {
            case UNDECIDED -> Answer.UNDECIDED;
            case NOTHING -> Answer.CLEAR;
            case ENCLOSED -> Answer.BLOCKED;
          };
      return mostPoints;
    }

    private int lookAtPoints(int most) {
      SphereTree tree = pair.points.shape.tree();
      int looked = 0;
      while (node < tree.nodes() && looked < most) {
        looked++;
        if (isEmptyAround(tree)) {
          node = tree.skip(node);
        } else if (tree.isLeaf(node)) {
          looked += tree.end(node) - tree.first(node);
          if (leafTouches(tree)) {
            answer = Answer.BLOCKED;
            return looked;
          }
          node = tree.skip(node);
        } else {
          node++;
        }
      }
      return looked;
    }

    /** Whether all around the points of the present node is empty. */
    private boolean isEmptyAround(SphereTree tree) {
      position.set(tree.x(node), tree.y(node), tree.z(node));
      toCells.transform(position, position);
      double around = pair.levels.clearance.at(position.x, position.y, position.z);
      return around > tree.radius(node) / pair.levels.cellMm + MARGIN_CELLS;
    }

    private boolean leafTouches(SphereTree tree) {
      for (int n = tree.first(node); n < tree.end(node); n++) {
        toCells.transform(pair.points.shape.point(n, position), position);
        if (pair.levels.touchesInCells(position, pair.levels.highest, caster)) {
          return true;
        }
      }
      return false;
    }
  }
}
