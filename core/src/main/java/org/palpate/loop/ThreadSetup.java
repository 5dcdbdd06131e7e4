package org.palpate.loop;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

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
   * @param others what else was asked for or noticed, by name, in words: {@code timer_slack} with
   *     {@code 1 ns} or {@code refused}, {@code throttling} with {@code 950 of 1000 ms}
   * @param refusals what was asked for and not granted, and why; a line each
   */
  record Granted(
      String schedulingClass,
      String affinity,
      boolean memoryLocked,
      Map<String, String> others,
      List<String> refusals) {

    /** Nothing was asked for. */
    public static final Granted NOTHING = new Granted("default", "any", false, Map.of(), List.of());

    public Granted {
      others = Collections.unmodifiableMap(new LinkedHashMap<>(others));
      refusals = List.copyOf(refusals);
    }
  }
}
