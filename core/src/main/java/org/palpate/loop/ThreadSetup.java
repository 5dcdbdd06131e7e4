package org.palpate.loop;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Prepares the calling thread for the haptic loop: scheduling class, processor, memory lock. {@code
 * realtime} implements this port.
 */
@FunctionalInterface
public interface ThreadSetup {
  /** Leaves the thread as the JVM made it. */
  ThreadSetup NONE = () -> Granted.NOTHING;

  /**
   * Prepares the thread. The haptic thread calls it once, before its first frame. A denied request
   * is no failure: the result reports it.
   *
   * @return what the system granted
   */
  Granted setUp();

  /**
   * The outcome of the requests, as the report prints it.
   *
   * @param schedulingClass for example {@code SCHED_FIFO 80}, or {@code default}
   * @param affinity for example {@code cpu 1}, or {@code any}
   * @param memoryLocked whether pages stay in memory
   * @param others other requests and facts of the system, by name: {@code timer_slack} with {@code
   *     1 ns} or {@code refused}, {@code throttling} with {@code 950 of 1000 ms}
   * @param refusals the denied requests with their reasons, a line each
   */
  record Granted(
      String schedulingClass,
      String affinity,
      boolean memoryLocked,
      Map<String, String> others,
      List<String> refusals) {

    /** The outcome without any request. */
    public static final Granted NOTHING = new Granted("default", "any", false, Map.of(), List.of());

    /** Copies the map, in its order, and the list. */
    public Granted {
      others = Collections.unmodifiableMap(new LinkedHashMap<>(others));
      refusals = List.copyOf(refusals);
    }
  }
}
