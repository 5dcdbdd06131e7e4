package org.palpate.benchmarks.jitter;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.palpate.realtime.WaitKind;

/** The tables that the command knows, for the JDKs that there are. */
final class Tables {
  /** Names of all tables, in their order. */
  static final List<String> NAMES =
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
  Tables(List<Jdk> jdks, int heapMb, int seconds) {
    this.jdks = jdks;
    this.heapMb = heapMb;
    this.seconds = seconds;
  }

  /** All tables: some eighty cells for two JDKs. */
  List<Table> all() {
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
  List<Table> quick() {
    List<Cell> control =
        List.of(
            Cell.control(WaitKind.ABSOLUTE, Scheduling.NORMAL, seconds, 0),
            Cell.control(WaitKind.HYBRID, Scheduling.FIFO, seconds, 0));
    Table first = new Table("machine", "What is this machine's own share?", control);
    Table second =
        forEachJdk(
            "cures",
            "From the simplest application to the recommended session: what cures what?",
            jdk -> {
              Cell simplest = Cell.of(jdk, heapMb, seconds).with(WaitKind.SLEEP, Scheduling.NORMAL);
              Cell busy = Cell.of(jdk, heapMb, seconds).with(Workload.EMPTY, Neighbour.ALLOCATES);
              Cell fifo = busy.with(WaitKind.HYBRID, Scheduling.FIFO);
              return List.of(
                  simplest, busy, fifo, fifo.with(Collector.zgcOf(jdk.release())), best(jdk));
            });
    return List.of(first, second);
  }

  /** The recommended cell: hybrid, FIFO, ZGC, the haptic frame, an allocating neighbour. */
  private Cell best(Jdk jdk) {
    return Cell.of(jdk, heapMb, seconds)
        .with(Collector.zgcOf(jdk.release()))
        .with(WaitKind.HYBRID, Scheduling.FIFO_WITH_VM)
        .with(Workload.FRAME, Neighbour.ALLOCATES);
  }

  private Table machine() {
    List<Cell> cells = new ArrayList<>();
    for (WaitKind wait :
        List.of(WaitKind.SLEEP, WaitKind.ABSOLUTE, WaitKind.HYBRID, WaitKind.SPIN)) {
      for (Scheduling scheduling : List.of(Scheduling.NORMAL, Scheduling.FIFO)) {
        cells.add(Cell.control(wait, scheduling, seconds, 0));
      }
    }
    cells.add(Cell.control(WaitKind.HYBRID, Scheduling.FIFO, seconds, 1));
    return new Table("machine", "How late is this machine without a JVM (C++)?", cells);
  }

  private Table simplest() {
    return forEachJdk(
        "simplest",
        "The paper: delays of a few to tens of milliseconds even with the simplest Java"
            + " application. Is that so?",
        jdk -> {
          List<Cell> cells = new ArrayList<>();
          for (Collector collector :
              List.of(Collector.SERIAL, Collector.G1, Collector.zgcOf(jdk.release()))) {
            for (Neighbour neighbour : Neighbour.values()) {
              cells.add(
                  Cell.of(jdk, heapMb, seconds)
                      .with(collector)
                      .with(WaitKind.SLEEP, Scheduling.NORMAL)
                      .with(Workload.EMPTY, neighbour));
            }
          }
          return cells;
        });
  }

  private Table waits() {
    return forEachJdk(
        "waits",
        "Which wait and which scheduling, beside a neighbour that allocates?",
        jdk -> {
          List<Cell> cells = new ArrayList<>();
          for (WaitKind wait : WaitKind.values()) {
            for (Scheduling scheduling : List.of(Scheduling.NORMAL, Scheduling.FIFO)) {
              cells.add(best(jdk).with(wait, scheduling).with(Workload.EMPTY, Neighbour.ALLOCATES));
            }
          }
          cells.add(best(jdk).with(Workload.EMPTY, Neighbour.ALLOCATES));
          return cells;
        });
  }

  private Table collectors() {
    return forEachJdk(
        "collectors",
        "Which collector, beside a neighbour that allocates?",
        jdk -> {
          List<Cell> cells = new ArrayList<>();
          for (Collector collector : Collector.values()) {
            if (collector.flags(jdk.release()).isPresent()) {
              cells.add(best(jdk).with(collector));
            }
          }
          return cells;
        });
  }

  private Table workloads() {
    return forEachJdk(
        "workloads",
        "What do the haptic frame, the view and a neighbour cost?",
        jdk -> {
          List<Cell> cells = new ArrayList<>();
          for (Workload workload : Workload.values()) {
            for (Neighbour neighbour : Neighbour.values()) {
              cells.add(best(jdk).with(workload, neighbour));
            }
          }
          return cells;
        });
  }

  private Table compilers() {
    return forEachJdk(
        "compilers",
        "Does another compiler, or an archive of an earlier run, help?",
        jdk -> {
          List<Cell> cells = new ArrayList<>();
          for (Jit jit : Jit.values()) {
            if (jit != Jit.AOT || jdk.release() >= Jit.FIRST_WITH_AOT) {
              cells.add(best(jdk).with(jit));
            }
          }
          return cells;
        });
  }

  private Table heaps() {
    return forEachJdk(
        "heaps",
        "Does the size of the heap matter?",
        jdk -> List.of(best(jdk).withHeap(256), best(jdk), best(jdk).withHeap(4 * heapMb)));
  }

  private Table recommended() {
    List<Cell> cells = new ArrayList<>();
    cells.add(Cell.control(WaitKind.HYBRID, Scheduling.FIFO, TIMES_LONGER * seconds, 0));
    jdks.forEach(jdk -> cells.add(best(jdk).lasting(TIMES_LONGER * seconds)));
    return new Table(
        "recommended", "The recommended session against the same loop in C++, for longer.", cells);
  }

  private Table forEachJdk(String name, String question, Function<Jdk, List<Cell>> cells) {
    return new Table(
        name, question, jdks.stream().flatMap(jdk -> cells.apply(jdk).stream()).toList());
  }
}
