package org.palpate.benchmarks.jitter.experiment;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.palpate.realtime.WaitKind;

class JvmCommandTest {
  private static final Jdk JDK_17 = new Jdk(Path.of("jdk17"), 17, "17.0.15", "");
  private static final Jdk JDK_25 = new Jdk(Path.of("jdk25"), 25, "25.0.3", "");

  @Test
  void choosesTheZgcThatAReleaseHas() {
    assertEquals(Optional.of(List.of("-XX:+UseZGC")), Collector.ZGC.flags(17));
    assertEquals(
        Optional.of(List.of("-XX:+UseZGC", "-XX:+ZGenerational")),
        Collector.GENERATIONAL_ZGC.flags(21));
    assertEquals(Optional.of(List.of("-XX:+UseZGC")), Collector.GENERATIONAL_ZGC.flags(25));
    assertEquals(Optional.empty(), Collector.ZGC.flags(25));
    assertEquals(Optional.empty(), Collector.GENERATIONAL_ZGC.flags(17));
  }

  @Test
  void givesEpsilonRoomForAllAllocations() {
    Experiment experiment =
        Experiment.of(JDK_17, 512, 10)
            .with(Collector.EPSILON)
            .with(Workload.EMPTY, BackgroundLoad.ALLOCATES);
    assertTrue(JvmCommand.heapMb(experiment) >= 100 * experiment.seconds(), experiment.key());
    assertEquals(512, JvmCommand.heapMb(experiment.with(Workload.EMPTY, BackgroundLoad.NONE)));
  }

  @Test
  void differentExperimentsHaveDifferentKeys() {
    Set<String> keys = new HashSet<>();
    Set<Experiment> experiments = new HashSet<>();
    for (ExperimentTable table : new ExperimentTables(List.of(JDK_17, JDK_25), 512, 10).all()) {
      table.experiments().forEach(experiment -> keys.add(experiment.key()));
      experiments.addAll(table.experiments());
    }
    assertEquals(experiments.size(), keys.size());
  }

  @Test
  void ratesComparesASessionWithTheControlAtEachRate() {
    ExperimentTable rates =
        new ExperimentTables(List.of(JDK_17), 512, 10)
            .all().stream().filter(table -> table.name().equals("rates")).findFirst().orElseThrow();
    for (long periodNanos : new long[] {1_000_000, 200_000, 100_000}) {
      List<Experiment> atRate =
          rates.experiments().stream().filter(e -> e.periodNanos() == periodNanos).toList();
      assertEquals(1, atRate.stream().filter(Experiment::isControl).count());
      assertEquals(2, atRate.stream().filter(e -> e.workload() == Workload.FRAME).count());
    }
  }

  @Test
  void aRateMustDivideASecondIntoWholeNanoseconds() {
    Experiment experiment = Experiment.of(JDK_17, 512, 10);
    assertThrows(IllegalArgumentException.class, () -> experiment.withRate(3_000));
    assertThrows(IllegalArgumentException.class, () -> experiment.withRate(0));
  }

  @Test
  void offersEveryTableUnderItsName() {
    List<String> names =
        new ExperimentTables(List.of(JDK_17), 512, 10)
            .all().stream().map(ExperimentTable::name).toList();
    assertEquals(ExperimentTables.NAMES, names);
  }

  @Test
  void taskIsTheSameAfterWritingAndReading() {
    ExperimentTask task =
        new ExperimentTask(
            WaitKind.HYBRID,
            Scheduling.FIFO_WITH_VM,
            Workload.FRAME,
            BackgroundLoad.BURNS,
            9_000,
            1_000_000,
            "volume /a b/c=d.nrrd\nsegment bone=>=1500",
            false);
    assertEquals(task, ExperimentTask.of(task.toProperties()));
  }
}
