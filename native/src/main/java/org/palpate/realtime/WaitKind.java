package org.palpate.realtime;

import java.nio.file.Path;
import org.palpate.realtime.os.OperatingSystem;
import org.palpate.realtime.os.PreciseSleep;
import org.palpate.realtime.os.Throttling;

/** The ways in which a thread can wait for its next frame. */
public enum WaitKind {
  /** {@code LockSupport.parkNanos} of what is left, as most Java programs do. */
  PARK,
  /** {@code Thread.sleep} of what is left; whole milliseconds on a JDK before 21. */
  SLEEP,
  /** The system's sleep to an absolute moment. */
  ABSOLUTE,
  /** The same to a little before the moment, then a spin; how little is measured. */
  HYBRID,
  /** Looks at the clock all the time, and keeps a processor busy. */
  SPIN;

  /**
   * Makes the wait. Called by the thread that will wait, under the scheduling it will have, since
   * {@link #HYBRID} measures for a fifth of a second how late this thread wakes.
   */
  public DeadlineWait create() {
    return switch (this) {
      case PARK -> new ParkWait();
      case SLEEP -> new SleepWait();
      case ABSOLUTE -> new AbsoluteWait(OperatingSystem.sleep());
      case HYBRID -> hybrid();
      case SPIN -> new SpinWait();
    };
  }

  private static HybridWait hybrid() {
    PreciseSleep sleep = OperatingSystem.sleep();
    return new HybridWait(sleep, SpinWindow.measureNanos(sleep), Throttling.read(Path.of("/")));
  }

  /** Whether a thread that waits so sleeps in every frame that is done in time. */
  public boolean sleeps() {
    return this != SPIN;
  }
}
