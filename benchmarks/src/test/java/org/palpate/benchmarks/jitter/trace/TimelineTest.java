package org.palpate.benchmarks.jitter.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class TimelineTest {
  private static final long MILLI = 1_000_000;

  /** Returns frames at 1 kHz of which each starts 2 us late and works for its number of us. */
  private static Samples frames(int count) {
    Samples samples = new Samples(count);
    for (int n = 0; n < count; n++) {
      long due = 5_000 * MILLI + n * MILLI;
      samples.add(due, due + 2_000, due + 2_000 + n * 1_000L, 0, 0, 0);
    }
    return samples;
  }

  @Test
  void everyStretchShowsItsLatestForceAtItsMiddle() {
    Timeline timeline = Timeline.of(frames(10), 5);
    assertEquals(List.of(0.001, 0.003, 0.005, 0.007, 0.009), timeline.seconds());
    assertEquals(List.of(3.0, 5.0, 7.0, 9.0, 11.0), timeline.worstMicros());
  }

  @Test
  void noFrameIsLeftOutWhenTheyDoNotDivideEvenly() {
    for (int stretches = 1; stretches <= 7; stretches++) {
      Timeline timeline = Timeline.of(frames(7), stretches);
      assertEquals(stretches, timeline.seconds().size());
      assertEquals(8.0, timeline.worstMicros().get(stretches - 1), "the last frame is the latest");
    }
  }

  @Test
  void thereAreNoMoreStretchesThanFrames() {
    assertEquals(List.of(2.0, 3.0, 4.0), Timeline.of(frames(3), 800).worstMicros());
  }

  @Test
  void anEventOverlapsTheTimeThatItShares() {
    JvmEvent event = new JvmEvent(JvmEvent.Kind.GC_PAUSE, 10, 20, "pause", false);
    assertEquals(10, event.overlapNanos(0, 30));
    assertEquals(4, event.overlapNanos(0, 14));
    assertEquals(3, event.overlapNanos(17, 30));
    assertEquals(2, event.overlapNanos(12, 14));
    assertEquals(0, event.overlapNanos(20, 30));
    assertEquals(0, event.overlapNanos(25, 30));
    assertEquals(0, event.overlapNanos(0, 9));
  }

  @Test
  void causesAreCountedByKindWithTheMostFrequentFirst() {
    Cause outside = cause(Cause.Kind.OUTSIDE);
    Cause collector = cause(Cause.Kind.GC);
    Cause steal = cause(Cause.Kind.STEAL);
    assertEquals(
        "3 outside the JVM, 2 steal, 1 GC",
        CauseCounts.text(List.of(collector, steal, outside, outside, steal, outside)));
    assertEquals("", CauseCounts.text(List.of()));
  }

  private static Cause cause(Cause.Kind kind) {
    return new Cause(kind, 0, 0, 4, 3, "");
  }

  @Test
  void aResponseIsLatenessAndWork() {
    assertEquals(7, cause(Cause.Kind.GC).responseNanos());
    Samples samples = frames(4);
    assertEquals(2_000, samples.lateness(3));
    assertEquals(3_000, samples.work(3));
    assertEquals(5_000, samples.response(3));
  }

  @Test
  void samplesAreFullAtTheirCapacity() {
    Samples samples = new Samples(2);
    samples.add(1, 2, 3, 0, 0, 0);
    assertTrue(!samples.isFull());
    samples.add(4, 5, 6, 0, 0, 0);
    assertTrue(samples.isFull());
  }

  @Test
  void aFileThatEndsWithinAFrameIsRefused(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("samples.bin");
    Files.write(file, new byte[48 + 8]);
    IOException refused = assertThrows(IOException.class, () -> Samples.read(file));
    assertEquals("not a file of samples: " + file + " bytes=56", refused.getMessage());
    Files.write(file, new byte[0]);
    assertThrows(IOException.class, () -> Samples.read(file));
  }

  @Test
  void aPeriodOfExactlyTheLimitIsNotOverIt() {
    Samples samples = new Samples(5);
    long[] starts = {0, 1_500_000, 3_000_001, 13_000_001, 23_000_002};
    for (long start : starts) {
      samples.add(start / MILLI * MILLI, start, start + 50_000, 0, 0, 0);
    }
    DelayHistograms delays = DelayHistograms.of(samples, MILLI);
    assertEquals(3, delays.overOneAndAHalfMillis());
    assertEquals(1, delays.overTenMillis());
    assertEquals(4, delays.period().getTotalCount());
    assertEquals(50, delays.work().getValueAtPercentile(50) / 1_000);
    assertEquals(19, delays.omitted(), "of 24 deadlines from 0 to 23 ms, 5 have a frame");
  }
}
