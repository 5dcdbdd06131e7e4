package org.palpate.frame;

import java.util.Map;
import java.util.OptionalLong;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import org.palpate.geometry.Vec3;

/**
 * Counts the frames of a session and what happened in them; {@link FrameStatistics} is a copy.
 *
 * <p>The haptic thread alone writes. Any thread may read the atomic fields while frames run.
 */
final class FrameCounters {
  private static final long NO_FRAME = -1;

  private final AtomicLong frames = new AtomicLong();
  private final AtomicLong forceBits = new AtomicLong();
  private final AtomicLong contact = new AtomicLong();
  private final AtomicBoolean exerting = new AtomicBoolean();
  private long contactFrames;
  private long freed;
  private long unreached;
  private long badOrientations;
  private long firstHold = NO_FRAME;
  private double maxForceNewton;
  private double maxTorqueNewtonMm;

  /** Counts a frame. Haptic thread. */
  void countFrame(boolean touches, Vec3 forceNewton, boolean wasFreed) {
    double newton = forceNewton.length();
    contactFrames += touches ? 1 : 0;
    freed += wasFreed ? 1 : 0;
    maxForceNewton = Math.max(maxForceNewton, newton);
    contact.lazySet(touches ? 1 : 0);
    forceBits.lazySet(Double.doubleToRawLongBits(newton));
    frames.lazySet(frames.getPlain() + 1);
  }

  /** Takes note of a torque. Haptic thread. */
  void countTorque(Vec3 torqueNewtonMm) {
    maxTorqueNewtonMm = Math.max(maxTorqueNewtonMm, torqueNewtonMm.length());
  }

  /** Notes whether the device may exert a force or a torque after a write. Haptic thread. */
  void noteForce(boolean mayExert) {
    exerting.lazySet(mayExert);
  }

  /** Notes whether the present frame, which is not counted yet, took a body. Haptic thread. */
  void noteHold(boolean tookBody) {
    if (tookBody && firstHold == NO_FRAME) {
      firstHold = lastFrame() + 1;
    }
  }

  /** Counts a force that did not reach the device. Haptic thread. */
  void countUnreached() {
    unreached++;
  }

  /** Counts a sample without a valid orientation. Haptic thread. */
  void countBadOrientation() {
    badOrientations++;
  }

  /** Returns the number of the last counted frame, from 0. Haptic thread. */
  long lastFrame() {
    return frames.getPlain() - 1;
  }

  /** Returns the number of frames so far. Any thread. */
  long frames() {
    return frames.get();
  }

  /** Whether the last frame ended in contact. Any thread. */
  boolean contact() {
    return contact.get() != 0;
  }

  /** Whether the device may exert a force or a torque. Any thread. */
  boolean mayExertForce() {
    return exerting.get();
  }

  /** Returns the length of the last force, N. Any thread. */
  double forceNewton() {
    return Double.longBitsToDouble(forceBits.get());
  }

  /**
   * Returns a copy of all counts, with those that the parts of a frame keep for themselves.
   * Allocates. Haptic thread, or any thread after the last frame.
   */
  FrameStatistics statistics(Watchdog watchdog, Map<String, Long> skipped, long forceNotFinite) {
    return new FrameStatistics(
        frames(),
        contactFrames,
        freed,
        maxForceNewton,
        maxTorqueNewtonMm,
        firstHold == NO_FRAME ? OptionalLong.empty() : OptionalLong.of(firstHold),
        skipped,
        new FrameStatistics.Faults(
            watchdog.held(),
            watchdog.notFinite(),
            badOrientations,
            watchdog.backwardTimes() + watchdog.stoppedTimes(),
            watchdog.silences(),
            watchdog.gaps() + watchdog.clockSetBacks(),
            forceNotFinite,
            unreached));
  }
}
