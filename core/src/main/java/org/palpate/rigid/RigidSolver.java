package org.palpate.rigid;

import org.palpate.body.BodyScene;
import org.palpate.geometry.Pose;
import org.palpate.rigid.ToolVerifier.EditOutcome;
import org.palpate.rigid.tool.RigidTool;

/**
 * Moves a rigid tool after a device pose, once a frame: to the pose nearest to the device, in the
 * kinetic metric, that the contacts allow.
 *
 * <p>Guarantee: the tool moves by steps whose legs were all verified exactly, see {@link
 * ToolVerifier}, whatever the contacts say.
 *
 * <p>Rest: a frame counts only if it lowers a potential, the distance to the device plus the priced
 * depth of the contacts, by a least amount; else it is taken back. While the device moves the
 * potential may rise by a little. For a device at rest the least amount grows from frame to frame
 * that creeps, so the tool rests, bit for bit, after at most {@link #MOST_CREEPING_FRAMES} of
 * those; frames that do not creep lower the potential by a fixed amount, so there are finitely
 * many.
 *
 * <p>Work is bounded by {@link WorkBudget}; a frame that has spent it goes on in the next one.
 * Haptic thread only; allocates nothing.
 */
public final class RigidSolver {
  /** The number of frames that may lower the potential by less than {@link #CREEP_EDGES}. */
  static final int MOST_CREEPING_FRAMES = 40;

  /** Frames that count for nothing, one after the other, until the tool rests. */
  private static final int FAILED_FRAMES_TO_REST = 3;

  private static final double CREEP_EDGES = 0.05;
  private static final double LEAST_FALL_EDGES = 1e-6;

  /** The potential may rise by a half of the device's motion, and no more than this, edges. */
  private static final double MOST_RISE_EDGES = 0.1;

  /** In contact, a frame comes nearer by this or by 1.5 times the device's motion, edges. */
  private static final double CATCH_UP_EDGES = 2;

  /** While the device moves, corrections shorter than this wait for the next frame, edges. */
  private static final double CORRECTION_EDGES = 0.01;

  /** Steps that gain less than this end a frame, edges. */
  private static final double LEAST_GAIN_EDGES = 1e-3;

  /** A frame that lowers the potential by less than this is stuck, edges. */
  private static final double STUCK_EDGES = 0.02;

  /** The most frames between two that try a relief while the device moves. */
  private static final int MOST_PATIENCE = 16;

  /** The fraction of the distance to the device that each relief of a frame requests. */
  private static final double[] PULLS = {0.02, 0, 0.1};

  /** The number of points with a reduced clearance that are looked at in a frame. */
  private static final int RAISED_PER_FRAME = 400;

  private final BodyScene scene;
  private final RigidTool tool;
  private final ToolVerifier verifier;
  private final WorkBudget budget;
  private final RigidStepper stepper;
  private final FreePoseSearch freeing;
  private final DevicePoseFilter device = new DevicePoseFilter();
  private final Pose lastTarget = new Pose();
  private final Pose start = new Pose();
  private final double edgeMm;
  private final double maxStepMm;
  private long bodyMotions;
  private boolean hasTarget;
  private int failedFrames;
  private int creepingFrames;
  private int reliefPatience = 1;
  private int reliefWait;
  private long work;

  /**
   * Creates a solver for a tool that stands nowhere yet; see {@link #place}.
   *
   * @param settings clearances by body and limits
   */
  public RigidSolver(BodyScene scene, RigidTool tool, RigidSettings settings) {
    this.scene = scene;
    this.tool = tool;
    maxStepMm = settings.maxStepMm();
    edgeMm = scene.shortestEdgeMm();
    verifier = new ToolVerifier(scene, tool, settings.clearancesOf(scene), settings.skips());
    budget = new WorkBudget(verifier);
    ContactField[] fields = new ContactField[scene.count()];
    for (int n = 0; n < fields.length; n++) {
      fields[n] = new ContactField(verifier.body(n).levels, settings.grey(n));
    }
    stepper = new RigidStepper(scene, tool, verifier, fields, budget);
    freeing = new FreePoseSearch(verifier, edgeMm);
  }

  /**
   * Puts the tool at a pose, or at a free pose near it with the same orientation.
   *
   * @param pose finite, with a quaternion that can be normalized
   * @return whether the pose itself was free
   * @throws IllegalArgumentException if the pose is none
   */
  public boolean place(Pose pose, ToolMotion motion) {
    start.set(pose);
    if (!pose.isFinite() || !start.rotation.normalize()) {
      throw new IllegalArgumentException(
          "the pose of a tool must be finite with a rotation: pose=" + pose);
    }
    bodyMotions = scene.motions();
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
    beginApproach();
  }

  /**
   * Returns the last device pose that was one, with a quaternion of norm 1 on the tool's side; not
   * to be written. The identity before the first.
   */
  public Pose target() {
    return device.target();
  }

  /** Returns the work of the last frame, in points looked at. */
  public long work() {
    return work;
  }

  /**
   * Runs one frame.
   *
   * @param devicePose where the device is, tool frame to world; anything, also what is no pose
   * @param motion the tool's motion, which {@link #place} has set
   * @throws IllegalStateException if a body was moved since the tool was placed, because the
   *     relative motion was not verified
   */
  public void follow(Pose devicePose, ToolMotion motion) {
    if (scene.motions() != bodyMotions) {
      throw new IllegalStateException("a body was moved: place the tool again");
    }
    motion.rest();
    work = 0;
    takeEdits(motion);
    device.take(devicePose, verifier.pose());
    if (!device.isKnown()) {
      return;
    }
    boolean moved = !hasTarget || !device.target().sameBits(lastTarget);
    if (moved || failedFrames < FAILED_FRAMES_TO_REST) {
      budget.begin();
      followTarget(motion, moved);
      work = budget.work();
    }
    verifier.continueEnclosureCheck();
    motion.depthMm = stepper.depthMm();
    motion.reducedPoints = verifier.reducedCount();
  }

  private void takeEdits(ToolMotion motion) {
    EditOutcome outcome = verifier.takeEdits();
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
    double before = potentialMm();
    double riseMm = Math.min(MOST_RISE_EDGES * edgeMm, 0.5 * motionMm);
    approach(motion, first ? Double.POSITIVE_INFINITY : motionMm, riseMm);
    double fallMm = before - potentialMm();
    boolean arrived = verifier.pose().sameBits(target);
    boolean counts = motion.steps > 0 && (arrived || isEnough(fallMm, moved, riseMm));
    if (!counts && motion.steps > 0) {
      takeBack(motion, depthBefore);
    } else if (motion.steps > 0) {
      verifier.raiseLevels(RAISED_PER_FRAME);
    }
    failedFrames = counts ? 0 : failedFrames + 1;
    planReliefs(fallMm);
    motion.contact = !arrived && (stepper.hasContacts() || !counts);
  }

  /** Reliefs that do not help are tried less and less often while the device moves. */
  private void planReliefs(double fallMm) {
    if (fallMm >= STUCK_EDGES * edgeMm) {
      reliefPatience = 1;
      reliefWait = 0;
    } else if (reliefWait < 0) {
      reliefPatience = Math.min(MOST_PATIENCE, 2 * reliefPatience);
      reliefWait = reliefPatience;
    }
  }

  private double potentialMm() {
    return stepper.distanceMm() + ContactRows.DEPTH_PRICE * stepper.depthMm();
  }

  private boolean isEnough(double fallMm, boolean moved, double riseMm) {
    if (moved) {
      return fallMm >= -riseMm;
    }
    if (fallMm >= CREEP_EDGES * edgeMm) {
      return true;
    }
    return creepingFrames++ < MOST_CREEPING_FRAMES && fallMm >= LEAST_FALL_EDGES * edgeMm;
  }

  private void takeBack(ToolMotion motion, double depthBefore) {
    verifier.takeBack(motion.path[0]);
    motion.steps = 0;
    motion.pathMm = 0;
    stepper.setDepthMm(depthBefore);
  }

  /** Takes steps until the target is reached, nothing is gained, or work or path is spent. */
  private void approach(ToolMotion motion, double motionMm, double riseMm) {
    double catchUpMm = Math.max(CATCH_UP_EDGES * edgeMm, 1.5 * motionMm);
    double before = stepper.distanceMm();
    double ceilingMm = potentialMm() + riseMm;
    int pulls = motionMm == 0 || reliefWait-- <= 0 ? PULLS.length : 0;
    int reliefs = 0;
    while (canGoOn(motion) && !verifier.pose().sameBits(lastTarget)) {
      boolean first = motion.steps == 0;
      double pathLeftMm = maxStepMm - motion.pathMm;
      double mostMm =
          stepper.hasContacts()
              ? catchUpMm - (before - stepper.distanceMm())
              : Double.POSITIVE_INFINITY;
      if (mostMm <= 0) {
        return;
      }
      double last = potentialMm();
      if (stepper.goStraight(mostMm, pathLeftMm)) {
        continue;
      }
      double shortestMm = (first || motionMm == 0 ? 1e-9 : CORRECTION_EDGES) * edgeMm;
      double mostRiseMm = Math.min(riseMm, Math.max(0, ceilingMm - last));
      boolean stepped = stepper.step(mostRiseMm, mostMm, pathLeftMm, shortestMm);
      boolean gained = stepped && potentialMm() <= last - LEAST_GAIN_EDGES * edgeMm;
      boolean stuck = !gained && ceilingMm - riseMm - potentialMm() < STUCK_EDGES * edgeMm;
      if (!gained && !(stuck && reliefs < pulls && relieve(motion, PULLS[reliefs++]))) {
        return;
      }
    }
  }

  private boolean canGoOn(ToolMotion motion) {
    return !motion.isFull() && motion.pathMm < maxStepMm && !(motion.steps > 0 && budget.isSpent());
  }

  private boolean relieve(ToolMotion motion, double pull) {
    return canGoOn(motion) && stepper.relieve(pull, maxStepMm - motion.pathMm);
  }
}
