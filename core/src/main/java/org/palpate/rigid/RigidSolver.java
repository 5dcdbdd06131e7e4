package org.palpate.rigid;

import org.palpate.body.BodyGroups;
import org.palpate.body.BodyScene;
import org.palpate.geometry.Pose;
import org.palpate.rigid.Mover.EditOutcome;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.statistics.SkipCounters;
import org.palpate.statistics.SkipKind;

/**
 * Moves a rigid tool after a device, once a frame: towards the pose that is nearest to the device
 * pose, in the kinetic metric, among those that the contacts allow.
 *
 * <p>Guarantee: the tool moves by steps whose legs {@link MoverVerifier} has verified exactly. It
 * does not depend on contacts or on floating-point mathematics.
 *
 * <p>Rest: each frame has a potential, the distance from the device plus the cost of the contacts'
 * depth. While the device rests, a frame is kept only if it lowers the potential; otherwise it is
 * taken back. A frame that lowers it by less than a fixed amount creeps, and at most {@link
 * #MOST_CREEPING_FRAMES} frames may creep. The others lower it by that amount, so there are
 * finitely many. Hence the tool comes to rest, bit for bit. While the device moves, the potential
 * may rise a little.
 *
 * <p>{@link WorkBudget} bounds the work. A frame that has spent it ends, and the next one goes on.
 * Haptic thread only; allocates nothing.
 */
public final class RigidSolver {
  /** The most frames that may lower the potential by less than {@link #CREEP_EDGES}. */
  static final int MOST_CREEPING_FRAMES = 40;

  /** The number of frames in a row that are taken back before the tool rests. */
  private static final int FAILED_FRAMES_TO_REST = 3;

  /** A frame creeps if it lowers the potential by less than this, edges. */
  private static final double CREEP_EDGES = 0.05;

  /** A frame that creeps must lower the potential by this at least, edges. */
  private static final double LEAST_FALL_EDGES = 1e-6;

  /** The most that the potential may rise in a frame, edges; half the device's motion if less. */
  private static final double MOST_RISE_EDGES = 0.1;

  /** The longest approach of a frame in contact, edges; 1.5 times the device's motion if more. */
  private static final double CATCH_UP_EDGES = 2;

  /** While the device moves, later steps of a frame that are shorter are left out, edges. */
  private static final double CORRECTION_EDGES = 0.01;

  /** A step that lowers the potential by less than this ends its frame, edges. */
  private static final double LEAST_GAIN_EDGES = 1e-3;

  /** Contacts that lie deeper than this below the smooth surface contradict each other, edges. */
  private static final double DEEP_EDGES = 0.1;

  /** A frame that lowers the potential by less than this is stuck, edges. */
  private static final double STUCK_EDGES = 0.02;

  /** While the device moves, a body takes steps along faces only this near to the device, edges. */
  private static final double FACES_WITHIN_EDGES = 4;

  /** The number of points whose clearance levels are tested in a frame. */
  private static final int LEVELS_PER_FRAME = 400;

  final WorkBudget budget;

  private final RigidScene scene;
  private final int hand;
  private final RigidTool tool;
  private final MoverVerifier verifier;
  private final BodyMover bodies;
  private final RigidStepper stepper;
  private final FreePoseSearch freeing;
  private final boolean leavesSurface;
  private final DevicePoseFilter device = new DevicePoseFilter();
  private final Pose lastTarget = new Pose();
  private final Pose start = new Pose();
  private final double edgeMm;
  private final double maxStepMm;
  private boolean hasTarget;
  private int failedFrames;
  private int creepingFrames;
  private long work;
  private long rests;

  /**
   * Creates a solver for a tool that stands nowhere yet, among bodies that stand still; see {@link
   * #place}.
   *
   * @param bodies the bodies at their present poses
   * @param tool the sample points of the tool
   * @param settings clearances by body and limits
   */
  public RigidSolver(BodyScene bodies, RigidTool tool, RigidSettings settings) {
    this(new RigidScene(bodies, tool, MovableShapes.none(bodies), settings));
  }

  /**
   * Creates a solver for the tool of a scene, which stands nowhere yet; see {@link #place}.
   *
   * @param scene belongs to this solver and those that {@link #ofBody} makes
   */
  public RigidSolver(RigidScene scene) {
    this(scene, scene.toolIndex(), false);
  }

  private RigidSolver(RigidScene scene, int hand, boolean leavesSurface) {
    this.scene = scene;
    this.leavesSurface = leavesSurface;
    this.hand = hand;
    verifier = scene.verifier(hand);
    tool = verifier.mover.shape;
    maxStepMm = scene.settings().maxStepMm();
    edgeMm = scene.bodies().shortestEdgeMm();
    budget = new WorkBudget(verifier);
    stepper = new RigidStepper(verifier, budget, edgeMm);
    freeing = new FreePoseSearch(verifier, edgeMm);
    bodies = scene.bodyMover();
  }

  /**
   * {@return a solver that moves a body of the same scene as the tool of the hand, once {@link
   * #takeOver} was called} Allocates.
   *
   * @param body the index of the body in the scene
   * @throws IllegalArgumentException if the body stands still
   */
  public RigidSolver ofBody(int body) {
    return ofBody(body, true);
  }

  /**
   * {@return a solver as {@link #ofBody(int)} makes it}
   *
   * @param body the index of the body in the scene
   * @param leavesSurface whether it may take steps along faces of voxels while the device moves
   */
  public RigidSolver ofBody(int body, boolean leavesSurface) {
    requireMovable(body);
    return new RigidSolver(scene, body, leavesSurface);
  }

  /**
   * {@return whether a body of the scene can move}
   *
   * @param body the index of the body in the scene
   */
  public boolean canMove(int body) {
    return scene.verifier(body) != null;
  }

  /**
   * Checks that a body of the scene can move. Any thread.
   *
   * @param body the index of the body in the scene
   * @throws IllegalArgumentException if it stands still
   */
  public void requireMovable(int body) {
    scene.requireMovable(body);
  }

  /**
   * Checks that every body of the scene that moves together with others can move. Any thread.
   *
   * @param groups the groups of the bodies of the scene
   * @throws IllegalArgumentException if such a body stands still
   */
  public void requireMovable(BodyGroups groups) {
    for (int n = 0; n < scene.bodies().count(); n++) {
      if (groups.size(n) > 1) {
        requireMovable(n);
      }
    }
  }

  /** {@return what this solver moves: its sample points and its metric} */
  public RigidTool shape() {
    return tool;
  }

  /**
   * Takes a body in hand where it is, bit for bit, even if an edit has just put a solid there. The
   * tool leaves the scene until its own solver places it again.
   *
   * @param motion receives the pose of the body; it was made by {@link #newMotion}
   */
  public void takeOver(ToolMotion motion) {
    scene.takeEdits(); // or the next frame would take them as edits at a tool, and set it free
    scene.verifier(scene.toolIndex()).mover.setPresent(false);
    bodies.clearGoal(hand);
    motion.freed = false;
    reset(motion);
  }

  /**
   * Lets a body move along with the one in hand as if glued to it, until {@link #carryNone}. Each
   * of the two is verified against all others.
   *
   * @param body the index of the body in the scene
   * @throws IllegalArgumentException if the body stands still
   */
  public void carry(int body) {
    requireMovable(body);
    bodies.clearGoal(body);
    verifier.carry(scene.verifier(body));
  }

  /** Lets every body that moves along stay where it is. */
  public void carryNone() {
    verifier.carryNone();
  }

  /** {@return whether the tool must be placed again: a body's pose was set unverified} */
  public boolean wasBodyMoved() {
    return scene.wasBodyMoved();
  }

  /** {@return what moves the bodies of the scene towards their goals} */
  public BodyMover bodies() {
    return bodies;
  }

  /** {@return a motion of the tool for this solver} */
  public ToolMotion newMotion() {
    return new ToolMotion(scene.bodies().count());
  }

  /**
   * Places the tool at a pose, or at a free pose near it with the same orientation.
   *
   * @param pose finite, with a quaternion that can be normalized
   * @param motion receives the pose at which the tool was placed
   * @return whether the pose itself was free
   * @throws IllegalArgumentException if the pose is not finite or has no rotation
   */
  public boolean place(Pose pose, ToolMotion motion) {
    start.set(pose);
    if (!pose.isFinite() || !start.rotation.normalize()) {
      throw new IllegalArgumentException(
          "the pose of a tool must be finite with a rotation: pose=" + pose);
    }
    if (scene.wasBodyMoved()) {
      scene.takeBodyPoses();
    }
    boolean free = verifier.place(start, false);
    if (!free) {
      freeing.find(start);
    }
    reset(motion);
    motion.freed = !free;
    return free;
  }

  private void reset(ToolMotion motion) {
    motion.placeAt(verifier.pose());
    motion.depthMm = 0;
    motion.reducedPoints = verifier.reducedCount();
    stepper.reset();
    hasTarget = false;
    budget.allowLifts();
    beginApproach();
  }

  /** {@return a finder of the voxels that block the tool} It shares the haptic thread. */
  public BlockingVoxels newBlockingVoxels() {
    return new BlockingVoxels(scene.bodies(), tool, verifier);
  }

  /**
   * {@return the last valid device pose; the identity before the first} Do not write to it. Of the
   * two quaternions of norm 1 that state its orientation, it has the one nearer to the tool's.
   */
  public Pose target() {
    return device.target();
  }

  /**
   * {@return the work of following the device in the last frame: the number of points that were
   * tested, and other work in its equivalent} Motions of other bodies do not count.
   */
  public long work() {
    return work;
  }

  /**
   * Adds the work that frames skipped without changing their answers.
   *
   * @param dest receives the counts
   */
  public void addSkips(SkipCounters dest) {
    verifier.addSkips(dest);
    dest.add(SkipKind.REST, rests);
  }

  /**
   * Runs one frame.
   *
   * @param devicePose the device pose, tool frame to world; one that is not finite or has no
   *     rotation is ignored
   * @param motion the tool's motion, which {@link #place} has set
   * @throws IllegalStateException if somebody else moved a body since the tool was placed, because
   *     that motion was not verified
   */
  public void follow(Pose devicePose, ToolMotion motion) {
    begin(motion);
    device.take(devicePose, verifier.pose());
    verifier.mover.snap(device.target());
    moveBodies(motion);
    if (!device.isKnown()) {
      return;
    }
    boolean moved = !hasTarget || !device.target().sameBits(lastTarget);
    if (moved || failedFrames < FAILED_FRAMES_TO_REST) {
      budget.begin();
      followTarget(motion, moved);
      work = budget.work();
    } else {
      rests++;
    }
    end(motion);
  }

  /**
   * Runs one frame without a new device pose: bodies move, and may push the tool.
   *
   * @param motion the motion of the last frame; receives that of this one
   * @throws IllegalStateException as {@link #follow} does
   */
  public void rest(ToolMotion motion) {
    if (!bodies.hasWork()) {
      scene.growEdits();
      motion.rest();
      return;
    }
    begin(motion);
    moveBodies(motion);
    end(motion);
  }

  private void begin(ToolMotion motion) {
    if (scene.wasBodyMoved()) {
      throw new IllegalStateException("a body was moved: place the tool again");
    }
    motion.rest();
    work = 0;
    takeEdits(motion);
  }

  /** Moves the bodies. If one moved, the approach begins anew, because contacts may be others. */
  private void moveBodies(ToolMotion motion) {
    bodies.move(hand, device.isKnown() ? device.target() : verifier.pose(), motion);
    if (motion.bodies.count() > 0) {
      beginApproach();
    }
  }

  private void end(ToolMotion motion) {
    scene.continueEnclosureCheck();
    motion.depthMm = stepper.depthMm();
    motion.reducedPoints = verifier.reducedCount();
  }

  private void takeEdits(ToolMotion motion) {
    EditOutcome outcome = verifier.takeEdits();
    scene.takeEdits();
    if (outcome == EditOutcome.COLLIDING) {
      freeing.find(verifier.pose());
      reset(motion);
      motion.freed = true;
    } else if (outcome == EditOutcome.FREE) {
      beginApproach();
    }
  }

  private void beginApproach() {
    creepingFrames = 0;
    failedFrames = 0;
  }

  private void followTarget(ToolMotion motion, boolean moved) {
    Pose target = device.target();
    double motionMm = hasTarget && moved ? tool.metric().distance(target, lastTarget) : 0;
    boolean first = !hasTarget;
    hasTarget = true;
    lastTarget.set(target);
    if (moved) {
      beginApproach();
    }
    stepper.aim(target, motion);
    double depthBefore = stepper.depthMm();
    double pushedMm = motion.pathMm;
    double before = potentialMm();
    double riseMm = Math.min(MOST_RISE_EDGES * edgeMm, 0.5 * motionMm);
    approach(motion, first ? Double.POSITIVE_INFINITY : motionMm, riseMm);
    double fallMm = before - potentialMm();
    boolean arrived = verifier.pose().sameBits(target);
    boolean isKept = motion.hasFollowed() && (arrived || isAcceptable(fallMm, moved, riseMm));
    if (!isKept && motion.hasFollowed()) {
      takeBack(motion, pushedMm, depthBefore);
    } else if (motion.hasFollowed()) {
      verifier.raiseLevels(LEVELS_PER_FRAME);
    }
    failedFrames = isKept ? 0 : failedFrames + 1;
    budget.endLifts(fallMm >= STUCK_EDGES * edgeMm);
    motion.contact = !arrived && (stepper.hasContacts() || !isKept);
    if (!motion.contact) {
      motion.contacts.clear();
    }
  }

  private double potentialMm() {
    return stepper.distanceMm() + ContactConstraints.DEPTH_COST * stepper.depthMm();
  }

  /** Whether a frame that lowers the potential by some mm is kept. */
  private boolean isAcceptable(double fallMm, boolean moved, double riseMm) {
    if (moved) {
      return fallMm >= -riseMm;
    }
    if (fallMm >= CREEP_EDGES * edgeMm) {
      return true;
    }
    return creepingFrames++ < MOST_CREEPING_FRAMES && fallMm >= LEAST_FALL_EDGES * edgeMm;
  }

  private void takeBack(ToolMotion motion, double pushedMm, double depthBefore) {
    verifier.takeBack(motion.path[motion.pushes]);
    motion.withdraw(pushedMm);
    stepper.setDepthMm(depthBefore);
  }

  /**
   * Takes steps until the tool arrives, a step gains nothing, or the work or the path is spent.
   *
   * @param motionMm the motion of the device since the last frame, mm in the kinetic metric
   * @param riseMm the most that the potential may rise, mm
   */
  private void approach(ToolMotion motion, double motionMm, double riseMm) {
    double catchUpMm = Math.max(CATCH_UP_EDGES * edgeMm, 1.5 * motionMm);
    double before = stepper.distanceMm();
    double startMm = potentialMm();
    budget.beginApproach(motionMm > 0);
    while (canContinue(motion) && !verifier.pose().sameBits(lastTarget)) {
      double pathLeftMm = maxStepMm - motion.pathMm;
      double mostMm =
          stepper.hasContacts()
              ? catchUpMm - (before - stepper.distanceMm())
              : Double.POSITIVE_INFINITY;
      if (mostMm <= 0) {
        return;
      }
      double last = potentialMm();
      if (stepper.stepStraight(mostMm, pathLeftMm)) {
        continue;
      }
      double shortestMm = (motion.hasFollowed() && motionMm > 0 ? CORRECTION_EDGES : 1e-9) * edgeMm;
      double mostRiseMm = Math.min(riseMm, Math.max(0, startMm + riseMm - last));
      boolean gained = stepper.step(mostRiseMm, mostMm, pathLeftMm, shortestMm) && hasGained(last);
      if (!gained && canContinue(motion) && mayHaveRoom(motionMm, startMm)) {
        gained = stepper.stepOnFaces(mostMm, maxStepMm - motion.pathMm) && hasGained(last);
      }
      if (!gained && !(isStuck(startMm) && canContinue(motion) && lift(motion))) {
        return;
      }
    }
  }

  /** Whether a frame has hardly lowered the potential at which it began. */
  private boolean isStuck(double startMm) {
    return startMm - potentialMm() < STUCK_EDGES * edgeMm;
  }

  /**
   * Whether contacts on the smooth surface contradict each other, so that there may be room between
   * it and the voxels. While the device moves, only a body in hand goes there, if stuck near it.
   */
  private boolean mayHaveRoom(double motionMm, double startMm) {
    return motionMm == 0
        ? stepper.depthMm() > DEEP_EDGES * edgeMm
        : leavesSurface
            && budget.hasFaces()
            && stepper.distanceMm() <= FACES_WITHIN_EDGES * edgeMm
            && isStuck(startMm)
            && stepper.contacts.pushApart();
  }

  private boolean hasGained(double potentialBefore) {
    return potentialMm() <= potentialBefore - LEAST_GAIN_EDGES * edgeMm;
  }

  private boolean canContinue(ToolMotion motion) {
    return !motion.isFull()
        && motion.pathMm < maxStepMm
        && !(motion.hasFollowed() && budget.isSpent());
  }

  private boolean lift(ToolMotion motion) {
    return budget.hasLift() && stepper.lift(budget.nextPull(), maxStepMm - motion.pathMm);
  }
}
