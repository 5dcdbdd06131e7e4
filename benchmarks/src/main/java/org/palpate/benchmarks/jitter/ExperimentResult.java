package org.palpate.benchmarks.jitter;

import java.io.IOException;
import java.nio.file.Files;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.TreeMap;
import org.palpate.benchmarks.jitter.experiment.Experiment;
import org.palpate.benchmarks.jitter.experiment.ExperimentLoop;
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
 * The result of one experiment.
 *
 * @param experiment the experiment that ran
 * @param delays the histograms of its frames
 * @param causes the causes of its ten worst frames, the worst first
 * @param timeline the latest force in each stretch of time
 * @param firstDueNanos the deadline of the first frame, which is the zero of the timeline
 * @param outcome the properties that the process reported; see {@link ExperimentLoop#outcome}
 * @param machine the kernel's counters during the experiment
 * @param events the number of events of each kind in the measured time
 * @param longestPauseNanos the longest time in which all Java threads were stopped
 */
record ExperimentResult(
    Experiment experiment,
    DelayHistograms delays,
    List<Cause> causes,
    Timeline timeline,
    long firstDueNanos,
    Properties outcome,
    MachineActivity machine,
    Map<Kind, Long> events,
    long longestPauseNanos) {

  private static final int WORST = 10;
  private static final int STRETCHES = 800;

  /** Evaluates the files of an experiment. */
  static ExperimentResult of(Experiment experiment, ExperimentFolder folder) throws IOException {
    Samples samples = Samples.read(folder.samples());
    MachineActivity machine = MachineSampler.read(folder.machine());
    List<JvmEvent> events = eventsOf(folder);
    boolean realtime = experiment.scheduling().isRealtime();
    long from = samples.due(0);
    long to = samples.end(samples.count() - 1);
    List<JvmEvent> measured =
        events.stream().filter(e -> e.startNanos() <= to && e.endNanos() >= from).toList();
    DelayHistograms delays = DelayHistograms.of(samples, experiment.periodNanos());
    long typicalWork = delays.work().getValueAtPercentile(50);
    return new ExperimentResult(
        experiment,
        delays,
        new CauseFinder(measured, machine, typicalWork, realtime).worst(samples, WORST),
        Timeline.of(samples, STRETCHES),
        from,
        folder.readOutcome(),
        machine,
        counts(measured),
        longestPause(measured));
  }

  private static List<JvmEvent> eventsOf(ExperimentFolder folder) throws IOException {
    return Files.exists(folder.recording())
        ? FlightRecording.read(folder.recording(), Experiment.THREAD_NAME)
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

  /** Returns the number of events of a kind in the measured time. */
  long count(Kind kind) {
    return events.getOrDefault(kind, 0L);
  }

  /** Returns a property that the process reported; empty if it did not. */
  String outcome(String name) {
    return outcome.getProperty(name, "");
  }
}
