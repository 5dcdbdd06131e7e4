package org.palpate.frame;

import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;
import org.palpate.collision.CollisionScene;
import org.palpate.force.ContactForce;
import org.palpate.force.ForceLimiter;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.SkipCounters;
import org.palpate.proxy.SkipKind;

/** Counts of frames. The haptic thread alone writes; what is atomic here any thread may read. */
public final class FrameCounters {
  private final AtomicLong frames = new AtomicLong();
  private final AtomicLong forceBits = new AtomicLong();
  private final AtomicLong contactNow = new AtomicLong();
  private long contactFrames;
  private long freed;
  private long unreached;
  private double maxForceNewton;

  /** Of the solvers at the end of each turn, the present one's left out. */
  private final SkipCounters ofTurns = new SkipCounters();

  /** Of the solvers at the beginning of each turn, the first one's left out. */
  private final SkipCounters beforeTurns = new SkipCounters();

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

  public long frames() {
    return frames.get();
  }

  public boolean contactNow() {
    return contactNow.get() != 0;
  }

  public double forceNowNewton() {
    return Double.longBitsToDouble(forceBits.get());
  }

  /** Keeps what a solver skipped so far, and leaves out what the next one did before its turn. */
  void changeSolver(ProxySolver last, ProxySolver next) {
    last.addSkips(ofTurns);
    next.addSkips(beforeTurns);
  }

  private Map<String, Long> skipped(
      ProxySolver solver, CollisionScene obstacles, ContactForce force) {
    SkipCounters all = new SkipCounters();
    all.add(ofTurns);
    solver.addSkips(all);
    all.subtract(beforeTurns);
    all.add(SkipKind.FAR_OBJECTS, obstacles.skippedCubes());
    all.add(SkipKind.FRICTION, force.frictionSkipped());
    return all.byKey();
  }

  FrameStatistics counts(
      Watchdog watchdog,
      ProxySolver solver,
      CollisionScene obstacles,
      ContactForce force,
      ForceLimiter limiter) {
    return new FrameStatistics(
        frames(),
        contactFrames,
        freed,
        maxForceNewton,
        skipped(solver, obstacles, force),
        new FrameStatistics.Faults(
            watchdog.held(),
            watchdog.notFinite(),
            watchdog.backwardTimes() + watchdog.stoppedTimes(),
            watchdog.silences(),
            watchdog.gaps() + watchdog.clockSetBacks(),
            limiter.notFinite(),
            unreached));
  }
}
