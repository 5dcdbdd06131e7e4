package org.palpate.frame;

import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;
import org.palpate.collision.CollisionScene;
import org.palpate.force.ContactForce;
import org.palpate.force.ForceLimiter;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.statistics.SkipCounters;
import org.palpate.statistics.SkipKind;

/**
 * Counts the frames of a session and what happened in them; {@link FrameStatistics} is a copy.
 *
 * <p>The haptic thread alone writes. Any thread may read the atomic fields while frames run.
 */
final class FrameCounters {
  private final AtomicLong frames = new AtomicLong();
  private final AtomicLong forceBits = new AtomicLong();
  private final AtomicLong contact = new AtomicLong();
  private long contactFrames;
  private long freed;
  private long unreached;
  private double maxForceNewton;

  /** Sums what each former solver had skipped when the next one replaced it. */
  private final SkipCounters skippedByFormer = new SkipCounters();

  /** Sums what each later solver had already skipped when it came into use. */
  private final SkipCounters skippedBeforeUse = new SkipCounters();

  /** Counts a frame. Haptic thread. */
  void countFrame(InteractionPoint point, Vec3 forceNewton, boolean wasFreed) {
    double newton = forceNewton.length();
    contactFrames += point.contact ? 1 : 0;
    freed += wasFreed ? 1 : 0;
    maxForceNewton = Math.max(maxForceNewton, newton);
    contact.lazySet(point.contact ? 1 : 0);
    forceBits.lazySet(Double.doubleToRawLongBits(newton));
    frames.lazySet(frames.getPlain() + 1);
  }

  /** Counts a force that did not reach the device. Haptic thread. */
  void countUnreached() {
    unreached++;
  }

  /** Keeps the counts of a solver that is replaced. Haptic thread. */
  void changeSolver(ProxySolver former, ProxySolver next) {
    former.addSkips(skippedByFormer);
    next.addSkips(skippedBeforeUse);
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

  /** Returns the length of the last force, N. Any thread. */
  double forceNewton() {
    return Double.longBitsToDouble(forceBits.get());
  }

  /**
   * Returns a copy of all counts, with those that the parts of a frame keep for themselves.
   * Allocates. Haptic thread, or any thread after the last frame.
   */
  FrameStatistics statistics(
      Watchdog watchdog,
      ProxySolver solver,
      CollisionScene scene,
      ContactForce force,
      ForceLimiter limiter) {
    return new FrameStatistics(
        frames(),
        contactFrames,
        freed,
        maxForceNewton,
        skipped(solver, scene, force),
        new FrameStatistics.Faults(
            watchdog.held(),
            watchdog.notFinite(),
            watchdog.backwardTimes() + watchdog.stoppedTimes(),
            watchdog.silences(),
            watchdog.gaps() + watchdog.clockSetBacks(),
            limiter.notFinite(),
            unreached));
  }

  private Map<String, Long> skipped(ProxySolver solver, CollisionScene scene, ContactForce force) {
    SkipCounters all = new SkipCounters();
    all.add(skippedByFormer);
    solver.addSkips(all);
    all.subtract(skippedBeforeUse);
    scene.addSkips(all);
    all.add(SkipKind.FRICTION, force.frictionSkipped());
    return all.byKey();
  }
}
