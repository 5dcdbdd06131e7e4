package org.palpate.loop;

/**
 * How the haptic thread waits for its next frame. The port that {@code realtime} implements by
 * absolute sleep; {@link SleepThenSpinPacer} is the one of the JDK alone.
 */
@FunctionalInterface
public interface Pacer {
  /**
   * Returns at the deadline, as near as can be and never on purpose before it; at once where it has
   * passed. Must allocate nothing. Returns early when the thread is interrupted, and leaves the
   * interrupt flag set.
   *
   * @param deadlineNanos on the loop's {@link NanoClock}
   */
  void awaitUntil(long deadlineNanos);
}
