package org.palpate.benchmarks.jitter.experiment;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.palpate.realtime.WaitKind;

/** Makes the tables of the command for the JDKs of this machine. */
public final class ExperimentTables {
  /** The names of all tables, in their order. */
  public static final List<String> NAMES =
      List.of(
          "machine",
          "recommended",
          "rates",
          "simplest",
          "waits",
          "collectors",
          "workloads",
          "compilers",
          "heaps");

  private static final int LONG_FACTOR = 6;
  private static final List<Integer> RATES_HZ = List.of(1_000, 5_000, 10_000);

  private final List<Jdk> jdks;
  private final int heapMb;
  private final int seconds;

  /**
   * Creates the tables.
   *
   * @param jdks the Java installations, by release
   * @param heapMb the heap of every experiment that does not need another
   * @param seconds the measured time of an experiment
   */
  public ExperimentTables(List<Jdk> jdks, int heapMb, int seconds) {
    this.jdks = jdks;
    this.heapMb = heapMb;
    this.seconds = seconds;
  }

  /** Returns all tables: about eighty experiments for two JDKs. */
  public List<ExperimentTable> all() {
    return List.of(
        machine(),
        recommended(),
        rates(),
        simplest(),
        waits(),
        collectors(),
        workloads(),
        compilers(),
        heaps());
  }

  /** Returns a dozen experiments that show the main effects. */
  public List<ExperimentTable> quick() {
    List<Experiment> control =
        List.of(
            Experiment.control(WaitKind.ABSOLUTE, Scheduling.NORMAL, seconds, 0),
            Experiment.control(WaitKind.HYBRID, Scheduling.FIFO, seconds, 0));
    ExperimentTable first =
        new ExperimentTable("machine", "How much of the delay is this machine's own?", control);
    ExperimentTable second =
        forEachJdk(
            "cures",
            "From the simplest application to the recommended session: what removes which delay?",
            jdk -> {
              Experiment simplest =
                  Experiment.of(jdk, heapMb, seconds).with(WaitKind.SLEEP, Scheduling.NORMAL);
              Experiment busy =
                  Experiment.of(jdk, heapMb, seconds)
                      .with(Workload.EMPTY, BackgroundLoad.ALLOCATES);
              Experiment fifo = busy.with(WaitKind.HYBRID, Scheduling.FIFO);
              return List.of(
                  simplest,
                  busy,
                  fifo,
                  fifo.with(Collector.zgcOf(jdk.release())),
                  recommendedExperiment(jdk));
            });
    return List.of(first, second);
  }

  /** Returns the recommended session: hybrid, FIFO, ZGC, the haptic frame, an allocating load. */
  private Experiment recommendedExperiment(Jdk jdk) {
    return Experiment.of(jdk, heapMb, seconds)
        .with(Collector.zgcOf(jdk.release()))
        .with(WaitKind.HYBRID, Scheduling.FIFO_WITH_VM)
        .with(Workload.FRAME, BackgroundLoad.ALLOCATES);
  }

  private ExperimentTable machine() {
    List<Experiment> experiments = new ArrayList<>();
    for (WaitKind wait :
        List.of(WaitKind.SLEEP, WaitKind.ABSOLUTE, WaitKind.HYBRID, WaitKind.SPIN)) {
      for (Scheduling scheduling : List.of(Scheduling.NORMAL, Scheduling.FIFO)) {
        experiments.add(Experiment.control(wait, scheduling, seconds, 0));
      }
    }
    experiments.add(Experiment.control(WaitKind.HYBRID, Scheduling.FIFO, seconds, 1));
    return new ExperimentTable(
        "machine", "How late is this machine without a JVM (C++)?", experiments);
  }

  private ExperimentTable simplest() {
    return forEachJdk(
        "simplest",
        "The paper reports delays of a few to tens of milliseconds even with the simplest Java"
            + " application. Does it reproduce?",
        jdk -> {
          List<Experiment> experiments = new ArrayList<>();
          for (Collector collector :
              List.of(Collector.SERIAL, Collector.G1, Collector.zgcOf(jdk.release()))) {
            for (BackgroundLoad load : BackgroundLoad.values()) {
              experiments.add(
                  Experiment.of(jdk, heapMb, seconds)
                      .with(collector)
                      .with(WaitKind.SLEEP, Scheduling.NORMAL)
                      .with(Workload.EMPTY, load));
            }
          }
          return experiments;
        });
  }

  private ExperimentTable waits() {
    return forEachJdk(
        "waits",
        "Which wait and which scheduling, beside a load that allocates?",
        jdk -> {
          List<Experiment> experiments = new ArrayList<>();
          for (WaitKind wait : WaitKind.values()) {
            for (Scheduling scheduling : List.of(Scheduling.NORMAL, Scheduling.FIFO)) {
              experiments.add(
                  recommendedExperiment(jdk)
                      .with(wait, scheduling)
                      .with(Workload.EMPTY, BackgroundLoad.ALLOCATES));
            }
          }
          experiments.add(
              recommendedExperiment(jdk).with(Workload.EMPTY, BackgroundLoad.ALLOCATES));
          return experiments;
        });
  }

  private ExperimentTable collectors() {
    return forEachJdk(
        "collectors",
        "Which collector, beside a load that allocates?",
        jdk -> {
          List<Experiment> experiments = new ArrayList<>();
          for (Collector collector : Collector.values()) {
            if (collector.flags(jdk.release()).isPresent()) {
              experiments.add(recommendedExperiment(jdk).with(collector));
            }
          }
          return experiments;
        });
  }

  private ExperimentTable workloads() {
    return forEachJdk(
        "workloads",
        "What do the haptic frame, the view and a background load cost?",
        jdk -> {
          List<Experiment> experiments = new ArrayList<>();
          for (Workload workload : Workload.values()) {
            for (BackgroundLoad load : BackgroundLoad.values()) {
              experiments.add(recommendedExperiment(jdk).with(workload, load));
            }
          }
          return experiments;
        });
  }

  private ExperimentTable compilers() {
    return forEachJdk(
        "compilers",
        "Does another compiler, or an archive of an earlier run, help?",
        jdk -> {
          List<Experiment> experiments = new ArrayList<>();
          for (JitMode jit : JitMode.values()) {
            if (jit != JitMode.AOT || jdk.release() >= JitMode.FIRST_WITH_AOT) {
              experiments.add(recommendedExperiment(jdk).with(jit));
            }
          }
          return experiments;
        });
  }

  private ExperimentTable heaps() {
    return forEachJdk(
        "heaps",
        "Does the size of the heap matter?",
        jdk ->
            List.of(
                recommendedExperiment(jdk).withHeap(256),
                recommendedExperiment(jdk),
                recommendedExperiment(jdk).withHeap(4 * heapMb)));
  }

  private ExperimentTable recommended() {
    List<Experiment> experiments = new ArrayList<>();
    experiments.add(Experiment.control(WaitKind.HYBRID, Scheduling.FIFO, LONG_FACTOR * seconds, 0));
    jdks.forEach(
        jdk -> experiments.add(recommendedExperiment(jdk).withSeconds(LONG_FACTOR * seconds)));
    return new ExperimentTable(
        "recommended",
        "The recommended session against the same loop in C++, for longer.",
        experiments);
  }

  private ExperimentTable rates() {
    List<Experiment> experiments = new ArrayList<>();
    for (int rateHz : RATES_HZ) {
      experiments.add(
          Experiment.control(WaitKind.HYBRID, Scheduling.FIFO, seconds, 0).withRate(rateHz));
      for (Jdk jdk : jdks) {
        Experiment session = recommendedExperiment(jdk).withRate(rateHz);
        experiments.add(session.with(Workload.FRAME, BackgroundLoad.NONE));
        experiments.add(session);
      }
    }
    return new ExperimentTable(
        "rates",
        "The recommended session against the same loop in C++, at 1, 5 and 10 kHz.",
        experiments);
  }

  private ExperimentTable forEachJdk(
      String name, String question, Function<Jdk, List<Experiment>> experiments) {
    return new ExperimentTable(
        name, question, jdks.stream().flatMap(jdk -> experiments.apply(jdk).stream()).toList());
  }
}
