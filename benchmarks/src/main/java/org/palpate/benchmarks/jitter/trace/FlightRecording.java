package org.palpate.benchmarks.jitter.trace;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import jdk.jfr.Recording;
import jdk.jfr.consumer.RecordedEvent;
import jdk.jfr.consumer.RecordingFile;

/** Reads a flight recording with the JDK's parser and converts its events to the loop's clock. */
public final class FlightRecording {
  static final String CLOCK_PAIR = "palpate.ClockPair";

  private static final Set<String> WANTED =
      Set.of(
          "jdk.GCPhasePause",
          "jdk.GarbageCollection",
          "jdk.SafepointBegin",
          "jdk.SafepointEnd",
          "jdk.ExecuteVMOperation",
          "jdk.ZAllocationStall",
          "jdk.Compilation",
          "jdk.Deoptimization",
          "jdk.GCPhaseConcurrent");

  private final String measuredThread;
  private final List<RecordedEvent> recorded = new ArrayList<>();
  private final List<ClockMap.Pair> pairs = new ArrayList<>();
  private final Map<Long, String> operations = new HashMap<>();
  private final List<JvmEvent> events = new ArrayList<>();

  private FlightRecording(String measuredThread) {
    this.measuredThread = measuredThread;
  }

  /** Enables the events that {@link #read} needs, without thresholds and stack traces. */
  public static void enable(Recording recording) {
    WANTED.forEach(name -> recording.enable(name).withoutThreshold().withoutStackTrace());
    recording.enable(CLOCK_PAIR).withoutStackTrace();
  }

  /**
   * Reads a recording.
   *
   * @param measuredThread the Java name of the thread that ran the loop
   * @return its events, by start
   * @throws IOException if it cannot be read or has no pair of clock readings
   */
  public static List<JvmEvent> read(Path recording, String measuredThread) throws IOException {
    return new FlightRecording(measuredThread).readAll(recording);
  }

  private List<JvmEvent> readAll(Path recording) throws IOException {
    try (RecordingFile file = new RecordingFile(recording)) {
      while (file.hasMoreEvents()) {
        sort(file.readEvent());
      }
    }
    if (pairs.isEmpty()) {
      throw new IOException("no pair of clock readings in the recording: " + recording);
    }
    ClockMap clock = ClockMap.through(pairs);
    new SafepointEvents(recorded, operations).addTo(events, clock);
    recorded.forEach(event -> addPlain(event, clock));
    events.sort(java.util.Comparator.comparingLong(JvmEvent::startNanos));
    return events;
  }

  private void sort(RecordedEvent event) {
    String name = event.getEventType().getName();
    if (name.equals(CLOCK_PAIR)) {
      pairs.add(
          new ClockMap.Pair(
              epochNanos(event.getStartTime()), event.getLong("before"), event.getLong("after")));
    } else if (name.equals("jdk.ExecuteVMOperation")) {
      operations.put(event.getLong("safepointId"), event.getString("operation"));
    } else if (WANTED.contains(name)) {
      recorded.add(event);
    }
  }

  private void addPlain(RecordedEvent event, ClockMap clock) {
    switch (event.getEventType().getName()) {
      case "jdk.GCPhasePause" -> add(JvmEvent.Kind.GC_PAUSE, event, event.getString("name"), clock);
      case "jdk.ZAllocationStall" ->
          add(JvmEvent.Kind.ALLOCATION_STALL, event, "allocation stall", clock);
      case "jdk.Compilation" -> add(JvmEvent.Kind.COMPILATION, event, method(event), clock);
      case "jdk.Deoptimization" ->
          add(JvmEvent.Kind.DEOPTIMIZATION, event, event.getString("reason"), clock);
      case "jdk.GCPhaseConcurrent" ->
          add(JvmEvent.Kind.GC_CONCURRENT, event, event.getString("name"), clock);
      default -> {
        // SafepointEvents has handled safepoints; a whole collection has events for its phases
      }
    }
  }

  private static String method(RecordedEvent compilation) {
    var method = compilation.<jdk.jfr.consumer.RecordedMethod>getValue("method");
    String name = method == null ? "a stub" : method.getType().getName() + "." + method.getName();
    return compilation.getString("compiler") + " " + name;
  }

  private void add(JvmEvent.Kind kind, RecordedEvent event, String what, ClockMap clock) {
    long start = clock.toNanoTime(epochNanos(event.getStartTime()));
    Duration length = event.getDuration();
    boolean measured =
        event.getThread() != null && measuredThread.equals(event.getThread().getJavaName());
    events.add(new JvmEvent(kind, start, start + length.toNanos(), what, measured));
  }

  static long epochNanos(Instant moment) {
    return moment.getEpochSecond() * 1_000_000_000L + moment.getNano();
  }
}
