package org.palpate.host;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import org.palpate.device.Trajectory;
import org.palpate.edit.EditQueue;
import org.palpate.edit.EditSchedule;
import org.palpate.elastic.ElasticBody;
import org.palpate.elastic.RecordedUpdate;
import org.palpate.elastic.RecordedUpdates;
import org.palpate.elastic.SynchronousUpdates;
import org.palpate.force.ForceRamp;
import org.palpate.force.ForceSettings;
import org.palpate.force.MassiveContact;
import org.palpate.frame.FrameObserver;
import org.palpate.frame.FramePublisher;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.FrameStatistics;
import org.palpate.frame.GridDevice;
import org.palpate.frame.HapticFrame;
import org.palpate.frame.PointFrame;
import org.palpate.frame.Watchdog;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.statistics.WorkPercentiles;

/**
 * Runs the frames of a session over a recorded trajectory, one frame a sample. It uses no clock, so
 * the same input gives the same bits. One thread.
 *
 * <p>Time is the trajectory's, and every sample is followed. In raw mode samples are treated as in
 * a live session: frames come a millisecond apart, or less if the samples do. Invalid positions and
 * backward times keep the last sample, and silences are detected.
 */
public final class ReplayRun {
  private static final double NANOS_PER_MS = 1e6;

  /** Samples that usually come more often than this are those of a rate above 1 kHz. */
  private static final double SHORT_STEP_MS = 0.75;

  private final ContactScene scene;
  private final Trajectory trajectory;
  private final boolean world;
  private final boolean raw;
  private final EditSchedule edits;
  private final Optional<Elastic> elastic;
  private final Optional<FrameObserver> observer;

  /** Makes elastic segments at rest, and what updates them before each frame. */
  private record Elastic(Supplier<ElasticBody> bodies, Function<ElasticBody, Runnable> updates) {}

  /** Receives the result of each frame. */
  @FunctionalInterface
  public interface FrameSink {
    /**
     * Receives a frame. The vectors belong to the run and change with the next frame.
     *
     * @param frame its number, from 0
     * @param device the device position as the trajectory gives it
     * @param point the present position of the interaction point in the trajectory's coordinates
     * @param forceNewton force on the hand along the axes of the trajectory's coordinates, N
     * @param state the interaction point with the legs of the frame, grid coordinates; material
     *     coordinates if segments are elastic
     * @param freed whether the frame set the interaction point free before its legs
     * @throws IOException if the frame cannot be written
     */
    void accept(
        int frame, Vec3 device, Vec3 point, Vec3 forceNewton, InteractionPoint state, boolean freed)
        throws IOException;
  }

  private ReplayRun(
      ContactScene scene,
      Trajectory trajectory,
      boolean world,
      boolean raw,
      EditSchedule edits,
      Optional<Elastic> elastic,
      Optional<FrameObserver> observer) {
    this.edits = edits;
    this.elastic = elastic;
    this.observer = observer;
    this.scene = scene;
    this.trajectory = trajectory;
    this.world = world;
    this.raw = raw;
  }

  /**
   * {@return a replay of a trajectory in world mm}
   *
   * @param scene the segments and their contact settings
   * @param trajectory the samples, world mm
   */
  public static ReplayRun inWorld(ContactScene scene, Trajectory trajectory) {
    return new ReplayRun(
        scene, trajectory, true, false, EditSchedule.NONE, Optional.empty(), Optional.empty());
  }

  /**
   * {@return a replay of a trajectory in grid coordinates}
   *
   * @param scene the segments and their contact settings
   * @param trajectory the samples, grid coordinates
   */
  public static ReplayRun inGrid(ContactScene scene, Trajectory trajectory) {
    return new ReplayRun(
        scene, trajectory, false, false, EditSchedule.NONE, Optional.empty(), Optional.empty());
  }

  /** {@return this replay in raw mode, which treats samples as a live session does} */
  public ReplayRun inRawMode() {
    return new ReplayRun(scene, trajectory, world, true, edits, elastic, observer);
  }

  /**
   * {@return this replay with recorded changes of voxels; it uses up the schedule}
   *
   * @param recorded the changes of voxels, by frame
   */
  public ReplayRun withEdits(EditSchedule recorded) {
    return new ReplayRun(scene, trajectory, world, raw, recorded, elastic, observer);
  }

  /**
   * {@return this replay with elastic segments, which are updated every {@link
   * SynchronousUpdates#FRAMES} frames of a millisecond}
   *
   * @param bodies makes a body at rest for each run
   */
  public ReplayRun withElastic(Supplier<ElasticBody> bodies) {
    return with(new Elastic(bodies, this::updates));
  }

  /**
   * {@return this replay with elastic segments, which are updated as in a recorded session}
   *
   * @param bodies makes a body at rest for each run
   * @param recorded the updates of the session, in their order
   */
  public ReplayRun withElastic(Supplier<ElasticBody> bodies, List<RecordedUpdate> recorded) {
    return with(new Elastic(bodies, body -> new RecordedUpdates(body, recorded)::beforeFrame));
  }

  private Runnable updates(ElasticBody body) {
    return new SynchronousUpdates(body, frameMs(trajectory))::beforeFrame;
  }

  private ReplayRun with(Elastic segments) {
    return new ReplayRun(scene, trajectory, world, raw, edits, Optional.of(segments), observer);
  }

  /**
   * {@return this replay with an observer of its frames, if one is given}
   *
   * @param newObserver receives the record of each frame; empty for none
   */
  public ReplayRun withObserver(Optional<FrameObserver> newObserver) {
    return new ReplayRun(scene, trajectory, world, raw, edits, elastic, newObserver);
  }

  /**
   * The result of a replay.
   *
   * @param statistics of all frames
   * @param work in the units of {@link ProxySolver#steps}
   * @param elastic the elastic segments as the run left them, if there are any
   * @param mass the body that the point followed, if it had a mass
   */
  public record Result(
      FrameStatistics statistics,
      WorkPercentiles work,
      Optional<ElasticBody> elastic,
      Optional<MassiveContact> mass) {}

  /**
   * Runs every frame once from a fresh start.
   *
   * @param sink receives each frame after it ran
   * @return the statistics of all frames, and the state at the end
   * @throws IOException if the observer fails to write
   */
  public Result run(FrameSink sink) throws IOException {
    TrajectoryDevice device = new TrajectoryDevice(trajectory, raw);
    GridDevice gridDevice =
        world ? GridDevice.fromWorld(device, scene.grid()) : GridDevice.inGridCoordinates(device);
    ForceSettings contact = scene.force(scene.defaultStiffnessNewtonPerMm());
    PointFrame frame =
        scene.newFrame(gridDevice, frameSettings(scene, contact, raw), FramePublisher.NONE);
    observer.ifPresent(frame::observe);
    long frameNanos = Math.round(frameMs(trajectory) * NANOS_PER_MS);
    Optional<ElasticBody> body = elastic.map(segments -> segments.bodies().get());
    body.ifPresent(made -> frame.deform(made.contact().paced(frameNanos)));
    Runnable updates = elastic.map(e -> e.updates().apply(body.orElseThrow())).orElse(() -> {});
    Vec3 point = new Vec3();
    Vec3 force = new Vec3();
    long[] work = new long[trajectory.size()];
    long rawFrameNanos = rawFrameNanos(trajectory, raw);
    for (int n = 0; n < work.length; n++) {
      edits.offerUpTo(n, scene.edits());
      updates.run();
      frame.run(frameNanos(trajectory, n, rawFrameNanos));
      work[n] = frame.followed() ? frame.work() : 0;
      toTrajectory(frame, point, force);
      sink.accept(n, device.lastPosition(), point, force, frame.point(), frame.wasFreed());
    }
    applyRest(edits, scene.edits(), frame);
    return new Result(frame.statistics(), WorkPercentiles.of(work), body, frame.mass());
  }

  /** Applies the changes that a session made after its last sample. */
  static void applyRest(EditSchedule edits, EditQueue queue, HapticFrame frame) {
    edits.offerUpTo(Long.MAX_VALUE, queue);
    queue.applyTo(frame.voxels(), Integer.MAX_VALUE);
  }

  /** Returns the time between two frames of a live session with such samples, ms, at most 1. */
  private static double frameMs(Trajectory trajectory) {
    double stepMs = trajectory.usualStepMs();
    return stepMs < SHORT_STEP_MS ? stepMs : TrajectoryDevice.FRAME_NANOS / NANOS_PER_MS;
  }

  /** Returns the time between two frames in raw mode, ns; 0 without it. */
  static long rawFrameNanos(Trajectory trajectory, boolean raw) {
    return raw ? Math.max(1, Math.round(frameMs(trajectory) * NANOS_PER_MS)) : 0;
  }

  /**
   * Returns the time at which the frame of a sample begins.
   *
   * @param rawFrameNanos as {@link #rawFrameNanos} returned it
   */
  static long frameNanos(Trajectory trajectory, int sample, long rawFrameNanos) {
    return rawFrameNanos > 0
        ? sample * rawFrameNanos
        : Math.round(trajectory.timeMs(sample) * NANOS_PER_MS);
  }

  /** Returns the settings for the frames of a replay. */
  static FrameSettings frameSettings(ContactScene scene, ForceSettings force, boolean raw) {
    return new FrameSettings(
        force,
        scene.settings().maxForceNewton().orElse(Double.POSITIVE_INFINITY),
        Double.POSITIVE_INFINITY,
        ForceRamp.DEFAULT_NANOS,
        raw ? Watchdog.MIN_SILENCE_NANOS : FrameSettings.NO_SILENCE,
        Integer.MAX_VALUE);
  }

  private void toTrajectory(PointFrame frame, Vec3 point, Vec3 force) {
    point.set(frame.presentPosition());
    force.set(frame.forceNewton());
    if (world) {
      scene.grid().gridToWorld(point, point);
      scene.grid().gridMmToWorld().rotate(force, force);
    }
  }
}
