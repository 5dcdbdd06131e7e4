package org.palpate.benchmarks.jitter.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MachineActivityTest {
  private static final long MILLI = 1_000_000;

  /** Samples every 20 ms; the hypervisor steals 3 ms in the second interval and 5 in the fourth. */
  private static MachineActivity activity(long stolenBefore) {
    return new MachineActivity(
        List.of(
            new MachineSample(0, stolenBefore, 0, 0),
            new MachineSample(20 * MILLI, stolenBefore, 10 * MILLI, 10 * MILLI),
            new MachineSample(40 * MILLI, stolenBefore + 3 * MILLI, 20 * MILLI, 17 * MILLI),
            new MachineSample(60 * MILLI, stolenBefore + 3 * MILLI, 30 * MILLI, 27 * MILLI),
            new MachineSample(80 * MILLI, stolenBefore + 8 * MILLI, 40 * MILLI, 32 * MILLI)));
  }

  private static long stolenMillis(MachineActivity activity, long from, long to) {
    return activity.stolenBetween(from * MILLI, to * MILLI) / MILLI;
  }

  @Test
  void countsWhatWasStolenFromTheSampleBeforeToTheSampleAfter() {
    MachineActivity activity = activity(7 * MILLI);
    assertEquals(0, stolenMillis(activity, 1, 19));
    assertEquals(3, stolenMillis(activity, 21, 22));
    assertEquals(3, stolenMillis(activity, 5, 45));
    assertEquals(8, stolenMillis(activity, 25, 75));
    assertEquals(5, stolenMillis(activity, 41, 500));
  }

  @Test
  void findsTheFirstTimeThatIsStolenSinceTheMachineBegan() {
    MachineActivity activity = activity(0);
    assertEquals(3, stolenMillis(activity, 21, 22));
    assertEquals(8, stolenMillis(activity, 25, 75));
    assertEquals(8, stolenMillis(activity, 5, 75));
  }

  @Test
  void aFrameThatBeginsAtASampleIsCountedFromThere() {
    MachineActivity activity = activity(7 * MILLI);
    assertEquals(3, stolenMillis(activity, 20, 40));
    assertEquals(0, stolenMillis(activity, 40, 60));
  }

  @Test
  void aFrameBeforeTheFirstSampleIsCountedFromThatSample() {
    assertEquals(3, stolenMillis(activity(7 * MILLI), -9, 30));
    assertEquals(0, new MachineActivity(List.of()).stolenBetween(0, MILLI));
  }

  @Test
  void fractionsAreOfStolenBusyAndIdleTimeTogether() {
    MachineActivity activity = activity(7 * MILLI);
    assertEquals(8 / 80.0, activity.stolenFraction(), 1e-15);
    assertEquals(40 / 80.0, activity.busyFraction(), 1e-15);
    MachineActivity one = new MachineActivity(List.of(new MachineSample(0, 1, 2, 3)));
    assertEquals(0, one.stolenFraction());
    assertEquals(0, one.busyFraction());
  }

  @Test
  void aLineOfTheKernelIsReadByItsColumns() {
    MachineSample sample =
        MachineSampler.parse(99, "cpu  1 20 300 4000 50000 600000 7000000 80000000 0 0")
            .orElseThrow();
    long tick = 10 * MILLI;
    assertEquals(new MachineSample(99, 80_000_000 * tick, 7_600_321 * tick, 54_000 * tick), sample);
    assertTrue(MachineSampler.parse(99, "cpu0 1 2 3 4 5 6 7 8 0 0").isEmpty());
    assertTrue(MachineSampler.parse(99, "cpu 1 2 3 4 5 6 7").isEmpty());
  }

  @Test
  void aFileOfSamplesIsReadByItsColumns(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("machine.csv");
    assertEquals(0, MachineSampler.read(file).busyFraction());
    Files.writeString(
        file, "nanos,stolen_nanos,busy_nanos,idle_nanos\n1000,10,200,3000\n2000,20,230,3060\n");
    MachineActivity activity = MachineSampler.read(file);
    assertEquals(0.1, activity.stolenFraction(), 1e-15);
    assertEquals(0.3, activity.busyFraction(), 1e-15);
    assertEquals(10, activity.stolenBetween(1_500, 1_600));
  }
}
