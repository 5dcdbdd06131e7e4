package org.palpate.benchmarks.jitter.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class DelayHistogramsTest {
  private static final long MILLI = 1_000_000;

  @Test
  void countsTheFramesThatADelayedLoopOmitted() {
    Samples samples = new Samples(4);
    samples.add(0, 0, 100, 0, 0, 0);
    samples.add(
        MILLI, 5 * MILLI, 5 * MILLI + 100, 0, 0, 0); // 4 ms late: 2, 3, 4 pass, 5 is on time
    samples.add(5 * MILLI, 5 * MILLI + 200, 5 * MILLI + 300, 0, 0, 0);
    samples.add(6 * MILLI, 6 * MILLI, 6 * MILLI + 100, 0, 0, 0);
    DelayHistograms delays = DelayHistograms.of(samples, MILLI);
    assertEquals(3, delays.omitted());
    assertEquals(4, delays.lateness().getTotalCount());
    assertEquals(
        7, delays.corrected().getTotalCount(), "4, and the 3, 2 and 1 ms of those omitted");
    assertEquals(1, delays.overOneAndAHalfMillis());
    assertEquals(0, delays.overTenMillis());
  }

  @Test
  void countsAnEarlyFrameAsPunctual() {
    Samples samples = new Samples(1);
    samples.add(MILLI, MILLI - 500, MILLI, 0, 0, 0);
    assertEquals(0, DelayHistograms.of(samples, MILLI).lateness().getMaxValue());
  }

  @Test
  void samplesAreTheSameAfterWritingAndReading(@TempDir Path folder) throws IOException {
    Samples samples = new Samples(3);
    samples.add(1, 2, 3, 4, 5, 6);
    samples.add(7, 8, 9, 10, 11, 12);
    samples.write(folder.resolve("samples.bin"));
    Samples read = Samples.read(folder.resolve("samples.bin"));
    assertEquals(2, read.count());
    assertEquals(7, read.due(1));
    assertEquals(2, read.response(1));
    assertEquals(6, read.delayed(1));
    assertEquals(6, read.faults(1));
    assertEquals(0, read.delayed(0), "nothing is known of the time before the first frame");
  }
}
