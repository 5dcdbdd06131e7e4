package org.palpate.benchmarks.jitter.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import jdk.jfr.Recording;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FlightRecordingTest {
  /** Far above the error of the clock map, far below the duration of the test. */
  private static final long CLOCK_ERROR_NANOS = 1_000_000;

  @TempDir Path folder;

  @Test
  void attributesARequestedCollectionToTheCollector() throws IOException {
    Samples samples = new Samples(3);
    long due;
    try (Recording recording = new Recording()) {
      FlightRecording.enable(recording);
      recording.start();
      ClockPair.emit();
      due = System.nanoTime();
      System.gc();
      long end = System.nanoTime();
      samples.add(due - 1_000_000, due - 1_000_000, due - 999_000, 0, 0, 0);
      samples.add(due, end, end, 0, 0, 0);
      samples.add(end, end, end, 0, 0, 0);
      ClockPair.emit();
      recording.stop();
      recording.dump(folder.resolve("recording.jfr"));
    }
    List<JvmEvent> events = FlightRecording.read(folder.resolve("recording.jfr"), "no thread");
    JvmEvent longest =
        events.stream()
            .filter(event -> event.kind() == JvmEvent.Kind.GC_PAUSE)
            .max((a, b) -> Long.compare(length(a), length(b)))
            .orElseThrow();
    assertTrue(longest.startNanos() >= due - CLOCK_ERROR_NANOS, longest.toString());
    assertTrue(longest.endNanos() <= samples.end(1) + CLOCK_ERROR_NANOS, longest.toString());
    Cause worst =
        new CauseFinder(events, new MachineActivity(List.of()), 1_000, true)
            .worst(samples, 1)
            .get(0);
    assertEquals(1, worst.frame());
    assertTrue(worst.evidence().contains("paused for the collector"), worst.evidence());
  }

  private static long length(JvmEvent event) {
    return event.endNanos() - event.startNanos();
  }
}
