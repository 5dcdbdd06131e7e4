package org.palpate.benchmarks.jitter.experiment;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.palpate.realtime.WaitKind;

class ExperimentWordsTest {
  private static final Experiment FIFO =
      Experiment.control(WaitKind.HYBRID, Scheduling.FIFO, 10, 0);
  private static final Experiment AGAIN =
      Experiment.control(WaitKind.HYBRID, Scheduling.FIFO, 10, 1);
  private static final Experiment NORMAL =
      Experiment.control(WaitKind.HYBRID, Scheduling.NORMAL, 10, 0);

  @Test
  void namesOnlyTheSettingsThatDiffer() {
    Map<String, String> names = ExperimentWords.differences(List.of(FIFO, NORMAL));
    assertEquals(List.of("C++, SCHED_FIFO", "C++, normal priority"), List.copyOf(names.values()));
  }

  @Test
  void namesRatesThatDiffer() {
    Map<String, String> names = ExperimentWords.differences(List.of(FIFO, FIFO.withRate(10_000)));
    assertEquals(List.of("C++, 1000 Hz", "C++, 10000 Hz"), List.copyOf(names.values()));
  }

  @Test
  void numbersARepetition() {
    Map<String, String> names = ExperimentWords.differences(List.of(FIFO, AGAIN));
    assertEquals(List.of("C++", "C++ (2)"), List.copyOf(names.values()));
  }

  @Test
  void namesEverySettingOfOne() {
    assertEquals("C++, sleep, then spin, SCHED_FIFO, 1000 Hz, 10 s", ExperimentWords.all(FIFO));
  }
}
