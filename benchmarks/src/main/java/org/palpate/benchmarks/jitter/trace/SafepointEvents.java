package org.palpate.benchmarks.jitter.trace;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import jdk.jfr.consumer.RecordedEvent;

/**
 * Joins the begin and the end of each safepoint to one event. The event lasts from the request to
 * stop until the threads may continue, and has the name of the safepoint's operation.
 */
final class SafepointEvents {
  private final List<RecordedEvent> recorded;
  private final Map<Long, String> operations;

  /**
   * Creates a converter.
   *
   * @param operations the operations that needed a safepoint, by the safepoint's number
   */
  SafepointEvents(List<RecordedEvent> recorded, Map<Long, String> operations) {
    this.recorded = recorded;
    this.operations = operations;
  }

  /** Adds each safepoint, as a pause of the collector if it contains one. */
  void addTo(List<JvmEvent> events, ClockMap clock) {
    Map<Long, Long> ends = new HashMap<>();
    for (RecordedEvent event : recorded) {
      if (event.getEventType().getName().equals("jdk.SafepointEnd")) {
        ends.put(event.getLong("safepointId"), FlightRecording.epochNanos(event.getEndTime()));
      }
    }
    for (RecordedEvent event : recorded) {
      if (event.getEventType().getName().equals("jdk.SafepointBegin")) {
        long id = event.getLong("safepointId");
        long start = FlightRecording.epochNanos(event.getStartTime());
        long end = ends.getOrDefault(id, FlightRecording.epochNanos(event.getEndTime()));
        long stopped = FlightRecording.epochNanos(event.getEndTime());
        events.add(safepoint(id, start, stopped, end, clock));
      }
    }
  }

  private JvmEvent safepoint(long id, long start, long stopped, long end, ClockMap clock) {
    boolean slowToStop = 2 * (stopped - start) > end - start;
    String slow = slowToStop ? ", most of it until all threads had stopped" : "";
    boolean forCollector = recorded.stream().anyMatch(event -> isPauseWithin(event, start, end));
    return new JvmEvent(
        forCollector ? JvmEvent.Kind.GC_PAUSE : JvmEvent.Kind.SAFEPOINT,
        clock.toNanoTime(start),
        clock.toNanoTime(end),
        operations.getOrDefault(id, "an operation without a name") + slow,
        false);
  }

  private static boolean isPauseWithin(RecordedEvent event, long start, long end) {
    return event.getEventType().getName().equals("jdk.GCPhasePause")
        && FlightRecording.epochNanos(event.getStartTime()) >= start
        && FlightRecording.epochNanos(event.getEndTime()) <= end;
  }
}
