package org.palpate.realtime;

import java.nio.file.Path;
import org.palpate.realtime.os.OperatingSystem;
import org.palpate.realtime.os.PreciseSleep;
import org.palpate.realtime.os.Throttling;

/** Kinds of waits for the next frame. */
public enum WaitKind {
  /** {@code LockSupport.parkNanos} for the remaining time, as most Java programs do. */
  PARK,
  /** {@code Thread.sleep} for the remaining time; whole milliseconds on a JDK before 21. */
  SLEEP,
  /** The system's sleep to an absolute time. */
  ABSOLUTE,
  /** An absolute sleep until shortly before the deadline, then a spin; the window is measured. */
  HYBRID,
  /** A loop that reads the clock all the time and keeps a processor busy. */
  SPIN;

  /**
   * Creates the wait. Call it in the thread that will wait, under its final scheduling, because
   * {@link #HYBRID} measures the lateness of that thread's wake-ups for 200 periods.
   *
   * @param periodNanos time between two deadlines
   */
  public DeadlineWait create(long periodNanos) {
    return switch (this) {
      case PARK -> new ParkWait();
      case SLEEP -> new SleepWait();
      case ABSOLUTE -> new AbsoluteWait(OperatingSystem.sleep());
      case HYBRID -> hybrid(periodNanos);
      case SPIN -> new SpinWait();
    };
  }

  private static HybridWait hybrid(long periodNanos) {
    PreciseSleep sleep = OperatingSystem.sleep();
    long windowNanos = SpinWindow.measureNanos(sleep, periodNanos);
    return new HybridWait(sleep, windowNanos, Throttling.read(Path.of("/")));
  }

  /** Whether the thread sleeps in every frame that ends in time. */
  public boolean sleeps() {
    return this != SPIN;
  }
}
