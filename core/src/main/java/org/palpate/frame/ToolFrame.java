package org.palpate.frame;

import java.util.ArrayDeque;
import java.util.Map;
import java.util.Queue;
import org.palpate.body.BodyEvent;
import org.palpate.body.BodyGroups;
import org.palpate.body.BodyListener;
import org.palpate.body.BodyScene;
import org.palpate.carve.CarveSettings;
import org.palpate.carve.ToolCarver;
import org.palpate.collision.CollisionScene;
import org.palpate.device.HapticDevice;
import org.palpate.edit.EditListener;
import org.palpate.edit.EditQueue;
import org.palpate.edit.PlacementLog;
import org.palpate.edit.VoxelWriter;
import org.palpate.force.ForceSettings;
import org.palpate.force.GreyMaterials;
import org.palpate.force.HandState;
import org.palpate.force.ToolProposal;
import org.palpate.force.guide.NearestApproach;
import org.palpate.frame.HoldRequests.Request;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.ToolMotion;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.statistics.SkipCounters;
import org.palpate.statistics.SkipKind;

/**
 * The frame of a rigid tool among bodies. The device delivers poses in the world and takes force
 * and torque along the world's axes, about the tool's reference point.
 *
 * <p>A quaternion whose norm is not 1 up to {@link Quaternion#NORM_TOLERANCE}, such as a NaN or
 * zero, is no orientation: the frame keeps the last valid one. A quaternion and its negative are
 * the same orientation.
 *
 * <p>As long as the first button of the device is pressed, the hand holds the movable body that the
 * tool pressed; see {@link #requestTake}.
 *
 * <p>Threads are those of {@link HapticFrame}.
 */
public final class ToolFrame extends HapticFrame {
  private final BodyScene bodies;
  private final RigidSolver solver;
  private final Grasp grasp;
  private final EditQueue edits;
  private final VoxelWriter voxels;
  private final ToolFramePublisher publisher;
  private final ToolMotion motion;
  private final Pose devicePose = new Pose();
  private final Quaternion checked = new Quaternion();
  private final SkipCounters skippedBeforeUse = new SkipCounters();
  private final RigidPlace place;

  /** Null if the tool does not cut. */
  private ToolCarver carver;

  private int mostReduced;

  private volatile ForceSettings requestedForce;
  private final HoldRequests holdRequests = new HoldRequests();
  private volatile int heldBody = Grasp.NO_BODY;

  private final PoseRequests requestedPoses;

  private volatile int pressedBody = Grasp.NO_BODY;
  private volatile BodyGroups groups;

  private final BodyReport bodyReport;
  private final PoseSnapshot snapshot;

  /** Recorded events for the next frame. */
  private final Queue<Runnable> repetitions = new ArrayDeque<>();

  /**
   * Makes a frame that has not run yet.
   *
   * @param device read and written once a frame, never closed
   * @param bodies the solids, in the order of the segments that edits change
   * @param solver moves the tool among the bodies; belongs to the frame from now on
   * @param coupling turns the distance between device and tool into force and torque, with the
   *     stiffness of the general material of {@code settings}
   * @param settings materials, friction and limits
   * @param edits changes of the bodies' voxels, applied before the tool moves
   * @param publisher receives each frame's result
   */
  public ToolFrame(
      HapticDevice device,
      BodyScene bodies,
      RigidSolver solver,
      RigidCoupling coupling,
      FrameSettings settings,
      EditQueue edits,
      ToolFramePublisher publisher) {
    super(device, settings);
    this.bodies = bodies;
    this.solver = solver;
    motion = solver.newMotion();
    this.edits = edits;
    this.publisher = publisher;
    PlacementLog placements =
        new PlacementLog(new BodyPlacer(bodies, solver.bodies().clearCheck()));
    EditListener noted = (segment, changed) -> bodies.body(segment).voxelsChanged(changed);
    voxels = new VoxelWriter(new CollisionScene(bodies.cubes()), noted, placements);
    BodyPlacer.limitMovable(bodies, voxels);
    place = new RigidPlace(bodies, solver.newBlockingVoxels(), motion, devicePose);
    voxels.follow(place);
    grasp = new Grasp(bodies, solver, coupling, settings.force(), placements);
    requestedForce = settings.force();
    requestedPoses = new PoseRequests(bodies.count());
    groups = BodyGroups.none(bodies.count());
    bodyReport = new BodyReport(bodies, grasp);
    snapshot = new PoseSnapshot(bodies);
    solver.addSkips(skippedBeforeUse);
  }

  /**
   * Applies requests. What the hand holds changes only between strokes of undo: letting go notes a
   * placement, which must not come into the middle of one.
   */
  @Override
  void applyRequests() {
    grasp.force().change(requestedForce);
    holdRequests.takeButton(sample.buttons);
    if (!voxels.history().isMoving()) {
      applyHold(holdRequests.take());
    }
    while (!repetitions.isEmpty()) {
      repetitions.remove().run();
    }
    requestedPoses.apply(grasp, solver.bodies());
  }

  private void applyHold(Request request) {
    if (request == Request.NONE) {
      return;
    }
    boolean holds = grasp.held() != Grasp.NO_BODY;
    int touched = holds ? Grasp.NO_BODY : grasp.touched(motion);
    BodyGroups bound = groups;
    if (request == Request.TAKE && touched != Grasp.NO_BODY && !bound.isLocked(touched)) {
      grasp.take(touched, devicePose, forceOfContact(), torqueOfContact(), motion);
      holdChanged(touched, BodyEvent.TAKEN);
      joinAll(touched, bound);
    } else if (request == Request.LET_GO) {
      letGo();
    }
  }

  private void joinAll(int taken, BodyGroups bound) {
    for (int n = 0; n < bodies.count(); n++) {
      if (n != taken && bound.moveTogether(n, taken)) {
        join(n);
      }
    }
  }

  private void join(int body) {
    grasp.join(body);
    bodyReport.report(body, BodyEvent.JOINED);
  }

  /** Lets go of the body that is held, if any. */
  private void letGo() {
    int body = grasp.held();
    if (body == Grasp.NO_BODY) {
      return;
    }
    if (!grasp.letGo(motion)) {
      setFree();
    }
    holdChanged(body, BodyEvent.RELEASED);
  }

  private void holdChanged(int body, BodyEvent event) {
    grasp.force().change(requestedForce);
    heldBody = grasp.held();
    counters.noteHold(event == BodyEvent.TAKEN);
    beginEffectsAnew();
    bodyReport.report(body, event);
  }

  /**
   * Applies edits. The solver takes note of them before its next motion. They wait while a body is
   * held. If undo has moved a body, the tool is set free, and no body goes on to a requested pose.
   */
  @Override
  void applyEdits(int maxVoxels) {
    if (grasp.held() != Grasp.NO_BODY) {
      return;
    }
    edits.applyTo(voxels, maxVoxels);
    if (place.isPlaced() && solver.wasBodyMoved()) {
      solver.bodies().clearGoals();
      solver.place(motion.pose(), motion);
      grasp.restart(motion);
      setFree();
      bodyReport.reportMotions(BodyEvent.PLACED);
    }
  }

  @Override
  public VoxelWriter voxels() {
    return voxels;
  }

  @Override
  public void carve(CarveSettings settings) {
    carver = new ToolCarver(settings, bodies, place.blocking(), voxels);
  }

  /**
   * Takes materials from grey values from now on. Call it before the first frame.
   *
   * @param materials belong to the bodies at rest
   */
  public void use(GreyMaterials materials) {
    grasp.use(materials);
  }

  /**
   * Lets something propose where the tool goes. Call it before the first frame.
   *
   * @param proposal belongs to the frame from now on
   */
  public void use(ToolProposal proposal) {
    grasp.use(proposal);
  }

  /** Without a new sample bodies move all the same, and may push the tool, once it has a place. */
  @Override
  void rest() {
    if (!place.isPlaced()) {
      return;
    }
    grasp.solver().rest(motion);
    if (motion.freed()) {
      grasp.restart(motion);
      setFree();
    }
  }

  @Override
  void follow() {
    takePose();
    boolean jumped = place.isPlaced() && sample.relocated;
    boolean startsAtDevice = true;
    if (!place.isPlaced() || jumped) {
      letGo();
      startsAtDevice = solver.place(devicePose, motion);
      place.place();
      grasp.restart(motion);
    } else if (carver != null && grasp.held() == Grasp.NO_BODY) {
      carver.carve(devicePose, pressingNewton(), sinceForceNanos());
    }
    grasp.solver().follow(grasp.target(devicePose, motion, sinceForceNanos()), motion);
    if (jumped || !startsAtDevice || motion.freed()) {
      grasp.restart(motion);
      setFree();
    }
  }

  private void takePose() {
    devicePose.translation.set(sample.positionMm);
    if (checked.set(sample.orientation).isNearUnit()) {
      checked.normalize();
      devicePose.rotation.set(checked);
    } else {
      counters.countBadOrientation();
    }
  }

  @Override
  void computeForce(long sinceLastNanos) {
    Pose target = grasp.coupled(devicePose);
    grasp.force().compute(motion, target, sinceLastNanos, forceNewton, torqueNewtonMm);
    addEffects(sinceLastNanos);
    grasp.moveTorque(motion.pose(), devicePose, forceNewton, torqueNewtonMm);
  }

  @Override
  void describe(HandState dest) {
    dest.device.set(grasp.coupled(devicePose));
    dest.tool.set(motion.pose());
    dest.isRigid = true;
    dest.heldBody = grasp.held();
    dest.bodyPoses = bodies.poses();
  }

  @Override
  void describe(FrameRecord dest) {
    dest.deviceMm.set(devicePose.translation);
    dest.heldBody = grasp.held();
    dest.take(motion);
  }

  @Override
  boolean isTouching() {
    return motion.contact();
  }

  @Override
  void note(long frame, NearestApproach dest) {
    if (grasp.held() == Grasp.NO_BODY) {
      dest.noteTool(solver.shape(), motion.pose(), frame);
    }
  }

  @Override
  void publish(long frame) {
    mostReduced = Math.max(mostReduced, motion.reducedPoints());
    bodyReport.reportMotions(BodyEvent.MOVED);
    snapshot.copyIfRequested();
    pressedBody = grasp.held() == Grasp.NO_BODY ? grasp.touched(motion) : Grasp.NO_BODY;
    publisher.publish(devicePose, motion, forceNewton, torqueNewtonMm, frame);
  }

  /**
   * Changes materials and friction from the next frame on. Any thread.
   *
   * @param requested the new materials and the form of friction
   */
  public void requestForce(ForceSettings requested) {
    requestedForce = requested;
  }

  /**
   * Takes hold of the movable body that the tool presses most, in the next frame, or after an undo
   * that takes several frames. From then on the body moves with the device instead of the tool.
   * Nothing happens without one. Any thread.
   */
  public void requestTake() {
    holdRequests.request(Request.TAKE);
  }

  /** Lets go of the body in hand in the next frame; undo can take it back. Any thread. */
  public void requestLetGo() {
    holdRequests.request(Request.LET_GO);
  }

  /**
   * Moves a body towards a pose from the next frame on, by verified steps. No body moves before the
   * first sample. A pose that it cannot reach stays its goal, until another is requested, the hand
   * takes the body, or undo moves a body. A request for a body that is held has no effect. Any
   * thread; copies the pose.
   *
   * @param body the index of a body that can move
   * @param restToPresent world mm
   * @throws IllegalArgumentException if the body stands still, or the pose is not finite or has no
   *     unit quaternion
   */
  public void requestPose(int body, Pose restToPresent) {
    solver.bodies().requireGoal(body, restToPresent);
    requestedPoses.request(body, restToPresent);
  }

  /**
   * Sets who receives where bodies are put. Call it before the first frame.
   *
   * @param newListener receives each event on the haptic thread
   */
  public void listen(BodyListener newListener) {
    bodyReport.listen(newListener);
  }

  /**
   * Repeats in the next frame what happened to a body in a recorded session; see {@link
   * BodyListener#accept}. A body approaches a pose, unless the hand holds it. Allocates. Haptic
   * thread, between two frames.
   *
   * @param body the index of the body in the scene
   * @param event what happened to it
   * @param pose finite, with a unit quaternion
   * @param inHand the pose of its reference point relative to the device; only for {@link
   *     BodyEvent#TAKEN}
   * @throws IllegalArgumentException if the body cannot move
   */
  public void repeat(int body, BodyEvent event, Pose pose, Pose inHand) {
    solver.requireMovable(body);
    repetitions.add(() -> repeatNow(body, event, pose, inHand));
  }

  private void repeatNow(int body, BodyEvent event, Pose pose, Pose inHand) {
    boolean holds = grasp.held() != Grasp.NO_BODY;
    switch (event) {
      case TAKEN -> {
        if (!holds) {
          takeAgain(body, inHand);
        }
      }
      case JOINED -> {
        if (holds && !grasp.moves(body)) {
          join(body);
        }
      }
      case RELEASED -> letGo();
      case PLACED -> {
        if (!holds) { // Undo waits while a body is held.
          bodies.body(body).setPose(pose);
        }
      }
      case MOVED, HELD -> {
        if (!grasp.moves(body)) {
          solver.bodies().setGoal(body, pose);
        }
      }
    }
  }

  /**
   * Takes hold of a body as it was recorded, after the edits that came before, which now would
   * wait. Nothing is taken while a stroke is undone in part.
   */
  private void takeAgain(int body, Pose inHand) {
    applyEdits(Integer.MAX_VALUE);
    if (!voxels.history().isMoving()) {
      grasp.takeAgain(body, inHand, motion);
      holdChanged(body, BodyEvent.TAKEN);
    }
  }

  /** {@return the index of the body that is held; -1 if the hand holds the tool} Any thread. */
  public int heldBody() {
    return heldBody;
  }

  /** {@return the body that is held, or else the one that is pressed; -1 if none} Any thread. */
  public int chosenBody() {
    int held = heldBody;
    return held == Grasp.NO_BODY ? pressedBody : held;
  }

  /** {@return the poses of all bodies, which one other thread can request} */
  public PoseSnapshot snapshot() {
    return snapshot;
  }

  /** {@return which bodies are locked and which move together} Any thread. */
  public BodyGroups groups() {
    return groups;
  }

  /**
   * Changes which bodies are locked and which move together, from the next time on that the hand
   * takes hold. One thread at a time.
   *
   * @param requested locks and groups of the bodies of this frame
   * @throws IllegalArgumentException if a body that stands still is to move together with others
   */
  public void requestGroups(BodyGroups requested) {
    solver.requireMovable(requested);
    groups = requested;
  }

  /**
   * {@return the motion of the tool, or of the body that is held, in the last frame} It belongs to
   * the frame.
   */
  public ToolMotion motion() {
    return motion;
  }

  /** {@return the tool, or the sample points of the body that is held} */
  public RigidTool shape() {
    return grasp.solver().shape();
  }

  /** {@return the device pose that the last frame followed, world mm} It belongs to the frame. */
  public Pose devicePose() {
    return devicePose;
  }

  /**
   * {@return the most points that kept less than their clearance in any frame: of what is held, or
   * of all bodies against each other} Haptic thread, or any thread after the last frame.
   */
  public int mostReducedPoints() {
    return Math.max(mostReduced, solver.bodies().mostReducedPoints());
  }

  /** {@return the work of the last frame, in the units of {@link RigidSolver#work}} */
  public long work() {
    return grasp.solver().work();
  }

  @Override
  Map<String, Long> skipped() {
    SkipCounters skips = new SkipCounters();
    solver.addSkips(skips);
    skips.subtract(skippedBeforeUse);
    skips.add(SkipKind.FRICTION, grasp.force().frictionSkipped());
    return skips.byKey();
  }
}
