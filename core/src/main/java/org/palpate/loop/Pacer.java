package org.palpate.loop;

/**
 * Waits for the deadline of the next frame. {@code realtime} implements this port by an absolute
 * sleep; {@link SleepThenSpinPacer} uses the JDK alone.
 */
@FunctionalInterface
public interface Pacer {
  /**
   * Returns as soon as possible after the deadline, and at once if it has passed. Haptic thread;
   * allocates nothing.
   *
   * <p>If the thread is interrupted, the method returns early and leaves the interrupt flag set.
   *
   * @param deadlineNanos on the loop's {@link NanoClock}
   */
  void awaitUntil(long deadlineNanos);
}
