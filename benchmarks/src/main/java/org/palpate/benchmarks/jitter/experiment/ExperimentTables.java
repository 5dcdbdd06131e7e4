package org.palpate.benchmarks.jitter.experiment;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.palpate.realtime.WaitKind;

/** The tables that the command knows, for the JDKs that there are. */
public final class ExperimentTables {
  /** Names of all tables, in their order. */
  public static final List<String> NAMES =
      List.of(
          "machine",
          "recommended",
          "simplest",
          "waits",
          "collectors",
          "workloads",
          "compilers",
          "heaps");

  private static final int TIMES_LONGER = 6;

  private final List<Jdk> jdks;
  private final int heapMb;
  private final int seconds;

  /**
   * @param jdks by release
   * @param heapMb of every cell that does not ask for another
   * @param seconds how long a cell is measured
   */
  public ExperimentTables(List<Jdk> jdks, int heapMb, int seconds) {
    this.jdks = jdks;
    this.heapMb = heapMb;
    this.seconds = seconds;
  }

  /** All tables: some eighty cells for two JDKs. */
  public List<ExperimentTable> all() {
    return List.of(
        machine(),
        recommended(),
        simplest(),
        waits(),
        collectors(),
        workloads(),
        compilers(),
        heaps());
  }

  /** A dozen cells that show what matters. */
  public List<ExperimentTable> quick() {
    List<Experiment> control =
        List.of(
            Experiment.control(WaitKind.ABSOLUTE, Scheduling.NORMAL, seconds, 0),
            Experiment.control(WaitKind.HYBRID, Scheduling.FIFO, seconds, 0));
    ExperimentTable first =
        new ExperimentTable("machine", "What is this machine's own share?", control);
    ExperimentTable second =
        forEachJdk(
            "cures",
            "From the simplest application to the recommended session: what cures what?",
            jdk -> {
              Experiment simplest =
                  Experiment.of(jdk, heapMb, seconds).with(WaitKind.SLEEP, Scheduling.NORMAL);
              Experiment busy =
                  Experiment.of(jdk, heapMb, seconds)
                      .with(Workload.EMPTY, BackgroundLoad.ALLOCATES);
              Experiment fifo = busy.with(WaitKind.HYBRID, Scheduling.FIFO);
              return List.of(
                  simplest, busy, fifo, fifo.with(Collector.zgcOf(jdk.release())), best(jdk));
            });
    return List.of(first, second);
  }

  /** The recommended cell: hybrid, FIFO, ZGC, the haptic frame, an allocating neighbour. */
  private Experiment best(Jdk jdk) {
    return Experiment.of(jdk, heapMb, seconds)
        .with(Collector.zgcOf(jdk.release()))
        .with(WaitKind.HYBRID, Scheduling.FIFO_WITH_VM)
        .with(Workload.FRAME, BackgroundLoad.ALLOCATES);
  }

  private ExperimentTable machine() {
    List<Experiment> cells = new ArrayList<>();
    for (WaitKind wait :
        List.of(WaitKind.SLEEP, WaitKind.ABSOLUTE, WaitKind.HYBRID, WaitKind.SPIN)) {
      for (Scheduling scheduling : List.of(Scheduling.NORMAL, Scheduling.FIFO)) {
        cells.add(Experiment.control(wait, scheduling, seconds, 0));
      }
    }
    cells.add(Experiment.control(WaitKind.HYBRID, Scheduling.FIFO, seconds, 1));
    return new ExperimentTable("machine", "How late is this machine without a JVM (C++)?", cells);
  }

  private ExperimentTable simplest() {
    return forEachJdk(
        "simplest",
        "The paper: delays of a few to tens of milliseconds even with the simplest Java"
            + " application. Is that so?",
        jdk -> {
          List<Experiment> cells = new ArrayList<>();
          for (Collector collector :
              List.of(Collector.SERIAL, Collector.G1, Collector.zgcOf(jdk.release()))) {
            for (BackgroundLoad neighbour : BackgroundLoad.values()) {
              cells.add(
                  Experiment.of(jdk, heapMb, seconds)
                      .with(collector)
                      .with(WaitKind.SLEEP, Scheduling.NORMAL)
                      .with(Workload.EMPTY, neighbour));
            }
          }
          return cells;
        });
  }

  private ExperimentTable waits() {
    return forEachJdk(
        "waits",
        "Which wait and which scheduling, beside a neighbour that allocates?",
        jdk -> {
          List<Experiment> cells = new ArrayList<>();
          for (WaitKind wait : WaitKind.values()) {
            for (Scheduling scheduling : List.of(Scheduling.NORMAL, Scheduling.FIFO)) {
              cells.add(
                  best(jdk).with(wait, scheduling).with(Workload.EMPTY, BackgroundLoad.ALLOCATES));
            }
          }
          cells.add(best(jdk).with(Workload.EMPTY, BackgroundLoad.ALLOCATES));
          return cells;
        });
  }

  private ExperimentTable collectors() {
    return forEachJdk(
        "collectors",
        "Which collector, beside a neighbour that allocates?",
        jdk -> {
          List<Experiment> cells = new ArrayList<>();
          for (Collector collector : Collector.values()) {
            if (collector.flags(jdk.release()).isPresent()) {
              cells.add(best(jdk).with(collector));
            }
          }
          return cells;
        });
  }

  private ExperimentTable workloads() {
    return forEachJdk(
        "workloads",
        "What do the haptic frame, the view and a neighbour cost?",
        jdk -> {
          List<Experiment> cells = new ArrayList<>();
          for (Workload workload : Workload.values()) {
            for (BackgroundLoad neighbour : BackgroundLoad.values()) {
              cells.add(best(jdk).with(workload, neighbour));
            }
          }
          return cells;
        });
  }

  private ExperimentTable compilers() {
    return forEachJdk(
        "compilers",
        "Does another compiler, or an archive of an earlier run, help?",
        jdk -> {
          List<Experiment> cells = new ArrayList<>();
          for (JitMode jit : JitMode.values()) {
            if (jit != JitMode.AOT || jdk.release() >= JitMode.FIRST_WITH_AOT) {
              cells.add(best(jdk).with(jit));
            }
          }
          return cells;
        });
  }

  private ExperimentTable heaps() {
    return forEachJdk(
        "heaps",
        "Does the size of the heap matter?",
        jdk -> List.of(best(jdk).withHeap(256), best(jdk), best(jdk).withHeap(4 * heapMb)));
  }

  private ExperimentTable recommended() {
    List<Experiment> cells = new ArrayList<>();
    cells.add(Experiment.control(WaitKind.HYBRID, Scheduling.FIFO, TIMES_LONGER * seconds, 0));
    jdks.forEach(jdk -> cells.add(best(jdk).lasting(TIMES_LONGER * seconds)));
    return new ExperimentTable(
        "recommended", "The recommended session against the same loop in C++, for longer.", cells);
  }

  private ExperimentTable forEachJdk(
      String name, String question, Function<Jdk, List<Experiment>> cells) {
    return new ExperimentTable(
        name, question, jdks.stream().flatMap(jdk -> cells.apply(jdk).stream()).toList());
  }
}
