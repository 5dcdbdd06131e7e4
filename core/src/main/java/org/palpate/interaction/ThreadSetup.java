package org.palpate.interaction;

import java.util.List;

/**
 * Makes the thread that calls it fit for the haptic loop: scheduling class, processor, memory lock.
 * The port that {@code realtime} implements.
 */
@FunctionalInterface
public interface ThreadSetup {
  /** Leaves the thread as the JVM made it. */
  ThreadSetup NONE = () -> Granted.NOTHING;

  /**
   * Called once by the haptic thread, before its first frame. What is refused is no failure: it is
   * told in the answer.
   */
  Granted setUp();

  /**
   * What the system granted, as the report tells it.
   *
   * @param schedulingClass such as {@code SCHED_FIFO 80}, or {@code default}
   * @param affinity such as {@code cpu 1}, or {@code any}
   * @param memoryLocked whether pages stay in memory
   * @param refusals what was asked for and not granted, and why; a line each
   */
  record Granted(
      String schedulingClass, String affinity, boolean memoryLocked, List<String> refusals) {

    /** Nothing was asked for. */
    public static final Granted NOTHING = new Granted("default", "any", false, List.of());

    public Granted {
      refusals = List.copyOf(refusals);
    }
  }
}
