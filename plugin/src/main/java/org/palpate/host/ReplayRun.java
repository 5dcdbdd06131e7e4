package org.palpate.host;

import java.io.IOException;
import org.palpate.device.HapticDevice;
import org.palpate.device.Trajectory;
import org.palpate.force.ForceRamp;
import org.palpate.force.ForceSettings;
import org.palpate.frame.FramePublisher;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.FrameStatistics;
import org.palpate.frame.HapticFrame;
import org.palpate.frame.Watchdog;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;

/**
 * The frames of a session from a trajectory: a frame a sample, without a clock, so that the same
 * input gives the same bits. One thread.
 *
 * <p>Time is the trajectory's, and every sample is followed. Met raw, as a live session would meet
 * them, frames come a millisecond apart, a sample that is no position or comes from the past is
 * held, and silences are noticed.
 */
public final class ReplayRun {
  private static final double NANOS_PER_MS = 1e6;

  private final ContactScene scene;
  private final Trajectory trajectory;
  private final boolean world;
  private final boolean raw;

  /** Takes what a frame did. */
  @FunctionalInterface
  public interface FrameSink {
    /**
     * Takes a frame. The vectors are the run's own and change with the next.
     *
     * @param frame its number, from 0
     * @param device as the trajectory has it
     * @param point p in the trajectory's coordinates
     * @param forceNewton on the hand, along the axes of the trajectory's coordinates
     * @param state p with the legs of the frame, grid coordinates
     * @param freed whether the point was set free before the legs
     */
    void accept(
        int frame, Vec3 device, Vec3 point, Vec3 forceNewton, InteractionPoint state, boolean freed)
        throws IOException;
  }

  /**
   * A replay that has not run.
   *
   * @param world whether the trajectory is in world mm; grid coordinates else
   * @param raw whether to meet samples as a live session would
   */
  public ReplayRun(ContactScene scene, Trajectory trajectory, boolean world, boolean raw) {
    this.scene = scene;
    this.trajectory = trajectory;
    this.world = world;
    this.raw = raw;
  }

  /** Runs every frame once, from a fresh start, and gives the counts over all of them. */
  public FrameStatistics run(FrameSink sink) throws IOException {
    TrajectoryDevice device = new TrajectoryDevice(trajectory, raw);
    HapticDevice inGrid = world ? new GridDevice(device, scene.grid()) : device;
    HapticFrame frame = scene.newFrame(inGrid, frameSettings(), FramePublisher.NONE);
    Vec3 point = new Vec3();
    Vec3 force = new Vec3();
    for (int n = 0; n < trajectory.size(); n++) {
      frame.run(raw ? n * TrajectoryDevice.FRAME_NANOS : timeNanos(n));
      toTrajectory(frame, point, force);
      sink.accept(n, device.lastPosition(), point, force, frame.point(), frame.wasFreed());
    }
    return frame.statistics();
  }

  private long timeNanos(int sample) {
    return Math.round(trajectory.timeMs(sample) * NANOS_PER_MS);
  }

  private FrameSettings frameSettings() {
    return new FrameSettings(
        scene.force(ForceSettings.DEFAULT_STIFFNESS_NEWTON_PER_MM),
        scene.settings().maxForceNewton().orElse(Double.POSITIVE_INFINITY),
        Double.POSITIVE_INFINITY,
        ForceRamp.DEFAULT_NANOS,
        raw ? Watchdog.MIN_SILENCE_NANOS : FrameSettings.NO_SILENCE,
        FrameSettings.DEFAULT_EDIT_VOXELS_A_FRAME);
  }

  private void toTrajectory(HapticFrame frame, Vec3 point, Vec3 force) {
    point.set(frame.point().position);
    force.set(frame.forceNewton());
    if (world) {
      scene.grid().gridToWorld(point, point);
      scene.grid().gridMmToWorld().rotate(force, force);
    }
  }
}
