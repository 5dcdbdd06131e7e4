package org.palpate.interaction;

import java.util.concurrent.atomic.AtomicLong;
import org.palpate.force.ContactForce;
import org.palpate.force.ForceLimiter;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;

/** Counts of frames. The haptic thread alone writes; what is atomic here any thread may read. */
final class FrameTally {
  private final AtomicLong frames = new AtomicLong();
  private final AtomicLong forceBits = new AtomicLong();
  private final AtomicLong contactNow = new AtomicLong();
  private long contactFrames;
  private long freed;
  private long unreached;
  private double maxForceNewton;

  void count(InteractionPoint point, Vec3 forceNewton, boolean wasFreed) {
    double newton = forceNewton.length();
    contactFrames += point.contact ? 1 : 0;
    freed += wasFreed ? 1 : 0;
    maxForceNewton = Math.max(maxForceNewton, newton);
    contactNow.lazySet(point.contact ? 1 : 0);
    forceBits.lazySet(Double.doubleToRawLongBits(newton));
    frames.lazySet(frames.getPlain() + 1);
  }

  void countUnreached() {
    unreached++;
  }

  /** The number of the frame that was counted last, from 0. */
  long lastFrame() {
    return frames.getPlain() - 1;
  }

  long frames() {
    return frames.get();
  }

  boolean contactNow() {
    return contactNow.get() != 0;
  }

  double forceNowNewton() {
    return Double.longBitsToDouble(forceBits.get());
  }

  FrameCounts counts(Watchdog watchdog, ContactForce force, ForceLimiter limiter) {
    return new FrameCounts(
        frames(),
        contactFrames,
        freed,
        maxForceNewton,
        force.frictionSkipped(),
        new FrameCounts.Faults(
            watchdog.held(),
            watchdog.notFinite(),
            watchdog.backwardTimes() + watchdog.stoppedTimes(),
            watchdog.silences(),
            watchdog.gaps() + watchdog.clockSetBacks(),
            limiter.notFinite(),
            unreached));
  }
}
