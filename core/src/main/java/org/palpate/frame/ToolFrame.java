package org.palpate.frame;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.palpate.body.BodyScene;
import org.palpate.carve.CarveSettings;
import org.palpate.carve.ToolCarver;
import org.palpate.collision.CollisionScene;
import org.palpate.device.HapticDevice;
import org.palpate.edit.EditQueue;
import org.palpate.edit.VoxelWriter;
import org.palpate.force.ForceSettings;
import org.palpate.force.ToolForce;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.ToolMotion;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.statistics.SkipCounters;
import org.palpate.statistics.SkipKind;
import org.palpate.volume.BitCube;

/**
 * The frame of a rigid tool among bodies. The device delivers poses in the world and takes force
 * and torque along the world's axes, about the tool's reference point.
 *
 * <p>A quaternion whose norm is not 1 up to {@link Quaternion#NORM_TOLERANCE}, such as a NaN or
 * zero, is no orientation: the frame keeps the last valid one. A quaternion and its negative are
 * the same orientation.
 *
 * <p>Threads are those of {@link HapticFrame}.
 */
public final class ToolFrame extends HapticFrame {
  private final BodyScene bodies;
  private final RigidSolver solver;
  private final ToolForce force;
  private final EditQueue edits;
  private final VoxelWriter voxels;
  private final ToolFramePublisher publisher;
  private final ToolMotion motion;
  private final Pose devicePose = new Pose();
  private final Quaternion checked = new Quaternion();
  private final SkipCounters skippedBeforeUse = new SkipCounters();
  private boolean placed;

  /** Null if the tool does not cut. */
  private ToolCarver carver;

  private int mostReduced;

  private volatile ForceSettings requestedForce;

  /**
   * Makes a frame that has not run yet.
   *
   * @param device read and written once a frame, never closed
   * @param bodies the solids, in the order of the segments that edits change
   * @param solver moves {@code tool} among the bodies; belongs to the frame from now on
   * @param coupling turns the distance between device and tool into force and torque, with the
   *     stiffness of the general material of {@code settings}
   * @param edits changes of the bodies' voxels, applied before the tool moves
   * @param publisher receives each frame's result
   */
  public ToolFrame(
      HapticDevice device,
      BodyScene bodies,
      RigidTool tool,
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
    voxels = new VoxelWriter(new CollisionScene(cubesOf(bodies)), this::noteEdit);
    force = new ToolForce(tool, bodies.shortestEdgeMm(), coupling, settings.force());
    requestedForce = settings.force();
    solver.addSkips(skippedBeforeUse);
  }

  private static List<BitCube> cubesOf(BodyScene bodies) {
    List<BitCube> cubes = new ArrayList<>();
    for (int n = 0; n < bodies.count(); n++) {
      cubes.add(bodies.body(n).bits());
    }
    return cubes;
  }

  @Override
  void applyRequests() {
    force.change(requestedForce);
  }

  /** Applies edits. The solver takes note of them before its next motion. */
  @Override
  void applyEdits(int maxVoxels) {
    edits.applyTo(voxels, maxVoxels);
  }

  private void noteEdit(int segment, IntBox changed) {
    bodies.body(segment).voxelsChanged(changed);
  }

  @Override
  public VoxelWriter voxels() {
    return voxels;
  }

  @Override
  public void carve(CarveSettings settings) {
    carver = new ToolCarver(settings, bodies, solver.newBlockingVoxels(), voxels);
  }

  /** Without a new sample bodies move all the same, and may push the tool. */
  @Override
  void rest() {
    solver.rest(motion);
    if (motion.freed()) {
      force.reset();
      setFree();
    }
  }

  @Override
  void follow() {
    takePose();
    boolean jumped = placed && sample.relocated;
    boolean startsAtDevice = true;
    if (!placed || jumped) {
      startsAtDevice = solver.place(devicePose, motion);
      placed = true;
    } else if (carver != null) {
      carver.carve(devicePose, forceNewton.length(), sinceForceNanos());
    }
    solver.follow(devicePose, motion);
    if (jumped || !startsAtDevice || motion.freed()) {
      force.reset();
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
    force.compute(motion, solver.target(), sinceLastNanos, forceNewton, torqueNewtonMm);
  }

  @Override
  boolean isTouching() {
    return motion.contact();
  }

  @Override
  void publish(long frame) {
    mostReduced = Math.max(mostReduced, motion.reducedPoints());
    publisher.publish(devicePose, motion, forceNewton, torqueNewtonMm, frame);
  }

  /** Changes materials and friction from the next frame on. Any thread. */
  public void requestForce(ForceSettings requested) {
    requestedForce = requested;
  }

  /** Returns the tool's motion in the last frame. It belongs to the frame. */
  public ToolMotion motion() {
    return motion;
  }

  /** Returns the device pose that the last frame followed, world mm. It belongs to the frame. */
  public Pose devicePose() {
    return devicePose;
  }

  /**
   * Returns the most points that kept less than their clearance in any frame. Haptic thread, or any
   * thread after the last frame.
   */
  public int mostReducedPoints() {
    return mostReduced;
  }

  /** Returns the work of the last frame, in the units of {@link RigidSolver#work}. */
  public long work() {
    return solver.work();
  }

  @Override
  Map<String, Long> skipped() {
    SkipCounters skips = new SkipCounters();
    solver.addSkips(skips);
    skips.subtract(skippedBeforeUse);
    skips.add(SkipKind.FRICTION, force.frictionSkipped());
    return skips.byKey();
  }
}
