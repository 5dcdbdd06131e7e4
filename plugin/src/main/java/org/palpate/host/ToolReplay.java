package org.palpate.host;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.palpate.body.BodyEvent;
import org.palpate.device.DeviceState;
import org.palpate.device.Trajectory;
import org.palpate.edit.EditSchedule;
import org.palpate.force.ToolForce;
import org.palpate.frame.FrameObserver;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.FrameStatistics;
import org.palpate.frame.ToolFrame;
import org.palpate.frame.ToolFramePublisher;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.io.table.BodyPose;
import org.palpate.rigid.BodyMover;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.ToolMotion;
import org.palpate.statistics.WorkPercentiles;

/**
 * Runs the frames of a rigid tool over a recorded trajectory in world mm, one frame a sample. It
 * uses no clock, so the same input gives the same bits. One thread.
 *
 * <p>Times and raw samples are treated as in a {@link ReplayRun}.
 */
public final class ToolReplay {
  private final ToolScene scene;
  private final Trajectory trajectory;
  private final boolean raw;
  private final EditSchedule edits;
  private final List<BodyPose> poses;
  private final Optional<FrameObserver> observer;

  /** Receives the result of each frame. */
  @FunctionalInterface
  public interface FrameSink {
    /**
     * Receives a frame.
     *
     * @param number of the frame, from 0
     * @param frame with its sample, motion, force and torque, until the next frame
     * @throws IOException if the frame cannot be written
     */
    void accept(int number, ToolFrame frame) throws IOException;
  }

  /**
   * The result of a replay.
   *
   * @param statistics of all frames
   * @param work in the units of {@link RigidSolver#work}
   * @param mostReduced the most points that kept less than their clearance in any frame
   * @param bodies what happened to bodies that move
   */
  public record Result(
      FrameStatistics statistics, WorkPercentiles work, int mostReduced, MovedBodies bodies) {}

  /**
   * The motions of bodies during a replay.
   *
   * @param movable the number of bodies that can move
   * @param motions the number of steps that bodies moved
   * @param pushes the number of those that pushed the tool
   * @param heldBack the number of frames in which a body was held back, counted for each body
   * @param elsewhere the number of recorded poses of a held body that the replay did not reach to
   *     the bit; 0 if it repeats the session
   */
  public record MovedBodies(
      int movable, long motions, long pushes, long heldBack, long elsewhere) {}

  /**
   * Creates a replay in which no body moves.
   *
   * @param scene the tool among the bodies; one frame at a time uses it
   * @param trajectory the samples, world mm
   * @param raw whether samples are treated as in a live session
   */
  public ToolReplay(ToolScene scene, Trajectory trajectory, boolean raw) {
    this(scene, trajectory, raw, EditSchedule.NONE, List.of(), Optional.empty());
  }

  /**
   * Creates a replay.
   *
   * @param scene the tool among the bodies; one frame at a time uses it
   * @param trajectory the samples, world mm
   * @param raw whether samples are treated as in a live session
   * @param edits recorded changes of voxels; the replay uses up the schedule
   * @param poses the poses that bodies approach, or what a recorded session did to them, in the
   *     order of their frames
   * @param observer receives what frames did, if given
   */
  public ToolReplay(
      ToolScene scene,
      Trajectory trajectory,
      boolean raw,
      EditSchedule edits,
      List<BodyPose> poses,
      Optional<FrameObserver> observer) {
    this.observer = observer;
    this.edits = edits;
    this.poses = poses;
    this.scene = scene;
    this.trajectory = trajectory;
    this.raw = raw;
  }

  /**
   * Measures the time of solver, force and torque over the valid samples, with nothing else inside.
   *
   * @param passes number of passes, more than {@link ReplayTiming#UNCOUNTED_PASSES}
   * @return the time of a frame over the counted passes
   */
  public ReplayTiming.NanosPerFrame time(int passes) {
    RigidSolver solver = scene.solver();
    double newtonPerMm = scene.contactScene().defaultStiffnessNewtonPerMm();
    ToolForce force =
        new ToolForce(
            scene.tool(),
            scene.bodies().shortestEdgeMm(),
            scene.coupling(newtonPerMm),
            scene.force(newtonPerMm));
    List<Pose> devices = validPoses();
    ToolMotion motion = new ToolMotion();
    Vec3 forceNewton = new Vec3();
    Vec3 torqueNewtonMm = new Vec3();
    Runnable pass =
        () -> {
          for (int n = 0; n < devices.size(); n++) {
            solver.follow(devices.get(n), motion);
            force.compute(motion, solver.target(), 0, forceNewton, torqueNewtonMm);
          }
        };
    return ReplayTiming.measure(
        passes, devices.size(), () -> solver.place(devices.get(0), motion), pass);
  }

  private List<Pose> validPoses() {
    List<Pose> poses = new ArrayList<>();
    DeviceState state = new DeviceState();
    for (int n = 0; n < trajectory.size(); n++) {
      trajectory.read(n, state);
      if (state.positionMm.isFinite() && state.orientation.isNearUnit()) {
        poses.add(new Pose().set(state.positionMm, state.orientation));
      }
    }
    return poses;
  }

  /**
   * Runs every frame once from a fresh start.
   *
   * @param sink receives each frame after it ran
   * @return the statistics of all frames, and the state at the end
   * @throws IOException if the observer fails to write
   */
  public Result run(FrameSink sink) throws IOException {
    TrajectoryDevice device = new TrajectoryDevice(trajectory, raw);
    ContactScene contact = scene.contactScene();
    double newtonPerMm = contact.defaultStiffnessNewtonPerMm();
    FrameSettings settings =
        ReplayRun.frameSettings(contact, scene.force(newtonPerMm), raw)
            .withTorque(Double.POSITIVE_INFINITY);
    ToolFrame frame =
        scene.newFrame(device, settings, scene.coupling(newtonPerMm), ToolFramePublisher.NONE);
    observer.ifPresent(frame::observe);
    long[] work = new long[trajectory.size()];
    long rawFrameNanos = ReplayRun.rawFrameNanos(trajectory, raw);
    int first = 0;
    long motions = 0;
    long elsewhere = 0;
    BodyMover bodies = scene.solver().bodies();
    for (int n = 0; n < work.length; n++) {
      edits.offerUpTo(n, scene.edits());
      int end = repeatUpTo(n, first, frame);
      frame.run(ReplayRun.frameNanos(trajectory, n, rawFrameNanos));
      elsewhere += countElsewhere(poses.subList(first, end));
      first = end;
      work[n] = frame.followed() ? frame.work() : 0;
      motions += frame.motion().bodies().count();
      sink.accept(n, frame);
    }
    ReplayRun.applyRest(edits, scene.edits(), frame);
    return new Result(
        frame.statistics(),
        WorkPercentiles.of(work),
        frame.mostReducedPoints(),
        new MovedBodies(
            movable(poses).size(), motions, bodies.pushes(), bodies.heldBack(), elsewhere));
  }

  /** Repeats the poses of a frame from an index on, and returns the index after the last. */
  private int repeatUpTo(int number, int first, ToolFrame frame) {
    int n = first;
    for (; n < poses.size() && poses.get(n).frame() <= number; n++) {
      BodyPose next = poses.get(n);
      frame.repeat(next.body(), next.event(), next.restToPresent(), next.inHand());
    }
    return n;
  }

  private long countElsewhere(List<BodyPose> recorded) {
    return recorded.stream()
        .filter(pose -> pose.event() == BodyEvent.HELD)
        .filter(pose -> !scene.bodies().body(pose.body()).pose().sameBits(pose.restToPresent()))
        .count();
  }

  /**
   * {@return the indices of the bodies that move}
   *
   * @param poses what bodies approach, or what a recorded session did to them
   */
  public static Set<Integer> movable(List<BodyPose> poses) {
    return poses.stream().map(BodyPose::body).collect(Collectors.toCollection(TreeSet::new));
  }
}
