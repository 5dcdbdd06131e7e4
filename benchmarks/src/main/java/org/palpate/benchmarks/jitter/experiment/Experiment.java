package org.palpate.benchmarks.jitter.experiment;

import java.util.Locale;
import java.util.Objects;
import org.palpate.realtime.WaitKind;

/**
 * One measurement: what runs, how it waits and competes, in which JVM. A cell without a JDK is a
 * control cell: the same loop in C++.
 *
 * @param jdk null for a control cell
 * @param collector of a JVM
 * @param waiting how the loop waits for its next frame
 * @param scheduling how its thread competes
 * @param workload what a frame does
 * @param neighbour what else the JVM does
 * @param jit how the JVM comes by machine code
 * @param heapMb least and most heap
 * @param seconds how long is measured, after the warm-up
 * @param repeat tells cells apart that are the same on purpose, from 0
 */
public record Experiment(
    Jdk jdk,
    Collector collector,
    WaitKind waiting,
    Scheduling scheduling,
    Workload workload,
    BackgroundLoad neighbour,
    JitMode jit,
    int heapMb,
    int seconds,
    int repeat) {

  public Experiment {
    Objects.requireNonNull(waiting);
    if (seconds < 1) {
      throw new IllegalArgumentException("seconds must be at least 1: seconds=" + seconds);
    }
  }

  /** The usual cell of a JDK, from which tables differ. */
  static Experiment of(Jdk jdk, int heapMb, int seconds) {
    return new Experiment(
        jdk,
        Collector.G1,
        WaitKind.PARK,
        Scheduling.NORMAL,
        Workload.EMPTY,
        BackgroundLoad.NONE,
        JitMode.DEFAULT,
        heapMb,
        seconds,
        0);
  }

  /** A loop in C++. */
  static Experiment control(WaitKind waiting, Scheduling scheduling, int seconds, int repeat) {
    return new Experiment(
        null,
        null,
        waiting,
        scheduling,
        Workload.EMPTY,
        BackgroundLoad.NONE,
        JitMode.DEFAULT,
        0,
        seconds,
        repeat);
  }

  public boolean isControl() {
    return jdk == null;
  }

  Experiment with(Collector other) {
    return new Experiment(
        jdk, other, waiting, scheduling, workload, neighbour, jit, heapMb, seconds, repeat);
  }

  Experiment with(WaitKind other, Scheduling otherScheduling) {
    return new Experiment(
        jdk, collector, other, otherScheduling, workload, neighbour, jit, heapMb, seconds, repeat);
  }

  Experiment with(Workload other, BackgroundLoad otherNeighbour) {
    return new Experiment(
        jdk, collector, waiting, scheduling, other, otherNeighbour, jit, heapMb, seconds, repeat);
  }

  Experiment with(JitMode other) {
    return new Experiment(
        jdk, collector, waiting, scheduling, workload, neighbour, other, heapMb, seconds, repeat);
  }

  Experiment withHeap(int otherHeapMb) {
    return new Experiment(
        jdk,
        collector,
        waiting,
        scheduling,
        workload,
        neighbour,
        jit,
        otherHeapMb,
        seconds,
        repeat);
  }

  Experiment lasting(int otherSeconds) {
    return new Experiment(
        jdk,
        collector,
        waiting,
        scheduling,
        workload,
        neighbour,
        jit,
        heapMb,
        otherSeconds,
        repeat);
  }

  /** A name that says all, fit for a folder. */
  public String key() {
    String how = lower(waiting) + "-" + scheduling.label();
    String again = repeat == 0 ? "" : "-" + repeat;
    if (isControl()) {
      return "cpp-" + how + "-" + seconds + "s" + again;
    }
    return String.join(
            "-",
            jdk.label(),
            collector.label(),
            how,
            workload.label(),
            neighbour.label(),
            jit.label(),
            heapMb + "m",
            seconds + "s")
        + again;
  }

  /** Who runs it, as a table names it. */
  String runtime() {
    return isControl() ? "C++" : jdk.label() + " " + collector.label();
  }

  public static String lower(Enum<?> value) {
    return value.name().toLowerCase(Locale.ROOT);
  }
}
