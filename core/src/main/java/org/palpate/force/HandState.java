package org.palpate.force;

import java.util.List;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

/**
 * The motion of the hand and its contact in a frame: the input of a {@link HapticEffect}.
 *
 * <p>Frame: world mm for a rigid tool, and grid millimetres for a point. Thread: the haptic thread.
 * Writer: the frame alone.
 */
public final class HandState {
  private static final double NANOS_PER_SECOND = 1e9;
  private static final double SMOOTHING_SECONDS = ContactDamping.SMOOTHING_MS / 1e3;

  /**
   * The pose that the hand asks for: that of the device, or for a body in hand the pose that the
   * body is to reach.
   */
  public final Pose device = new Pose();

  /**
   * The pose of the tool, of the body in hand, or of the interaction point, which does not turn.
   */
  public final Pose tool = new Pose();

  /** The speed of {@link #device}, mm/s, smoothed over 4 ms. */
  public final Vec3 velocityMmPerSecond = new Vec3();

  /** The angular speed of {@link #device}, rad/s, smoothed likewise. */
  public final Vec3 spinRadPerSecond = new Vec3();

  /** The force of contact on the hand in this frame, N, before limits and effects. */
  public final Vec3 contactNewton = new Vec3();

  /** The torque of contact on the hand in this frame, N mm, likewise. */
  public final Vec3 contactTorqueNewtonMm = new Vec3();

  /** Whether a solid holds the tool back. */
  public boolean contact;

  /** Whether the hand holds a rigid tool or a body, which feel torque; false for a point. */
  public boolean isRigid;

  /** The index of the body in hand; -1 if the hand holds the tool. */
  public int heldBody = -1;

  /**
   * The pose of each body, from rest to present, world mm; not to be written. Empty for a point,
   * whose bodies stay at rest.
   */
  public List<Pose> bodyPoses = List.of();

  /** The time since the last frame that computed a force, s; 0 in the first one. */
  public double seconds;

  private final Pose lastDevice = new Pose();
  private final Vec3 motion = new Vec3();
  private final Vec3 turn = new Vec3();
  private final Quaternion scratch = new Quaternion();
  private boolean known;

  /** Forgets the last frame: speeds begin at zero. */
  public void forget() {
    known = false;
    velocityMmPerSecond.set(0, 0, 0);
    spinRadPerSecond.set(0, 0, 0);
  }

  /**
   * Updates time and speeds after {@link #device} was written.
   *
   * @param elapsedNanos time since the last call; 0 or less leaves the speeds as they were
   */
  public void advance(long elapsedNanos) {
    seconds = Math.max(0, elapsedNanos) / NANOS_PER_SECOND;
    if (known && elapsedNanos > 0) {
      lastDevice.differenceTo(device, motion, turn, scratch);
      ContactDamping.smooth(motion, seconds, SMOOTHING_SECONDS, velocityMmPerSecond);
      ContactDamping.smooth(turn, seconds, SMOOTHING_SECONDS, spinRadPerSecond);
    }
    lastDevice.set(device);
    known = true;
  }
}
