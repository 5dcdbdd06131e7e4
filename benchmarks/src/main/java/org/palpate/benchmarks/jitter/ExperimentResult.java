package org.palpate.benchmarks.jitter;

import java.io.IOException;
import java.nio.file.Files;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.TreeMap;
import org.palpate.benchmarks.jitter.experiment.Experiment;
import org.palpate.benchmarks.jitter.experiment.ExperimentLoop;
import org.palpate.benchmarks.jitter.experiment.ExperimentRunner;
import org.palpate.benchmarks.jitter.trace.Cause;
import org.palpate.benchmarks.jitter.trace.CauseFinder;
import org.palpate.benchmarks.jitter.trace.DelayHistograms;
import org.palpate.benchmarks.jitter.trace.ExperimentFolder;
import org.palpate.benchmarks.jitter.trace.FlightRecording;
import org.palpate.benchmarks.jitter.trace.JvmEvent;
import org.palpate.benchmarks.jitter.trace.JvmEvent.Kind;
import org.palpate.benchmarks.jitter.trace.MachineActivity;
import org.palpate.benchmarks.jitter.trace.MachineSampler;
import org.palpate.benchmarks.jitter.trace.Samples;
import org.palpate.benchmarks.jitter.trace.Timeline;

/**
 * What one cell found.
 *
 * @param cell what was run
 * @param delays its histograms
 * @param causes of its ten worst frames, the worst first
 * @param timeline the latest force in stretches of time
 * @param firstDueNanos when the first frame was due, the zero of the timeline
 * @param answers what the process told; see {@link ExperimentLoop#answers}
 * @param machine what the kernel counted meanwhile
 * @param events how many events of each kind lay in the measured time
 * @param longestPauseNanos the longest that all Java threads stood still in that time
 */
record ExperimentResult(
    Experiment cell,
    DelayHistograms delays,
    List<Cause> causes,
    Timeline timeline,
    long firstDueNanos,
    Properties answers,
    MachineActivity machine,
    Map<Kind, Long> events,
    long longestPauseNanos) {

  private static final int WORST = 10;
  private static final int STRETCHES = 800;

  /** Works a cell's files out. */
  static ExperimentResult of(Experiment cell, ExperimentFolder folder) throws IOException {
    Samples samples = Samples.read(folder.samples());
    MachineActivity machine = MachineSampler.read(folder.machine());
    List<JvmEvent> events = eventsOf(folder);
    boolean realtime = cell.scheduling().isRealtime();
    long from = samples.due(0);
    long to = samples.end(samples.count() - 1);
    List<JvmEvent> measured =
        events.stream().filter(e -> e.startNanos() <= to && e.endNanos() >= from).toList();
    DelayHistograms delays = DelayHistograms.of(samples, ExperimentRunner.PERIOD_NANOS);
    long usualWork = delays.work().getValueAtPercentile(50);
    return new ExperimentResult(
        cell,
        delays,
        new CauseFinder(measured, machine, usualWork, realtime).worst(samples, WORST),
        Timeline.of(samples, STRETCHES),
        from,
        folder.readOutcome(),
        machine,
        counts(measured),
        longestPause(measured));
  }

  private static List<JvmEvent> eventsOf(ExperimentFolder folder) throws IOException {
    return Files.exists(folder.recording())
        ? FlightRecording.read(folder.recording(), ExperimentLoop.THREAD_NAME)
        : List.of();
  }

  private static Map<Kind, Long> counts(List<JvmEvent> events) {
    Map<Kind, Long> counts = new TreeMap<>();
    events.forEach(event -> counts.merge(event.kind(), 1L, Long::sum));
    return counts;
  }

  private static long longestPause(List<JvmEvent> events) {
    return events.stream()
        .filter(event -> event.kind() == Kind.GC_PAUSE || event.kind() == Kind.SAFEPOINT)
        .mapToLong(event -> event.endNanos() - event.startNanos())
        .max()
        .orElse(0);
  }

  /** How many events of a kind lay in the measured time. */
  long count(Kind kind) {
    return events.getOrDefault(kind, 0L);
  }

  /** What the process told, or nothing. */
  String answer(String name) {
    return answers.getProperty(name, "");
  }
}
