package org.palpate.benchmarks.jitter.experiment;

import java.util.Locale;
import java.util.Objects;
import java.util.function.Consumer;
import org.palpate.realtime.WaitKind;

/**
 * One measurement: the JVM, the wait and the scheduling of its loop, and the work. An experiment
 * without a JDK is a control experiment, which runs the same loop in C++.
 *
 * @param jdk the Java installation; null for a control experiment
 * @param collector the garbage collector of the JVM
 * @param waiting the loop's wait for its next frame
 * @param scheduling the scheduling of its thread
 * @param workload the work of a frame
 * @param load the background load in the JVM
 * @param jit the source of the JVM's machine code
 * @param heapMb the initial and maximal heap
 * @param rateHz the number of deadlines in a second; a divisor of 10^9
 * @param seconds the measured time, after the warm-up
 * @param repeat a number from 0 that distinguishes intended repetitions
 */
public record Experiment(
    Jdk jdk,
    Collector collector,
    WaitKind waiting,
    Scheduling scheduling,
    Workload workload,
    BackgroundLoad load,
    JitMode jit,
    int heapMb,
    int rateHz,
    int seconds,
    int repeat) {

  /** The rate of every table that does not compare rates. */
  static final int DEFAULT_RATE_HZ = 1_000;

  private static final long NANOS_PER_SECOND = 1_000_000_000;

  /** The name of the measured thread. */
  public static final String THREAD_NAME = "palpate-haptic";

  /** Checks rate and duration. */
  public Experiment {
    Objects.requireNonNull(waiting);
    if (rateHz < 1 || NANOS_PER_SECOND % rateHz != 0) {
      throw new IllegalArgumentException("rateHz must divide 10^9: rateHz=" + rateHz);
    }
    if (seconds < 1) {
      throw new IllegalArgumentException("seconds must be at least 1: seconds=" + seconds);
    }
  }

  /** Returns the default experiment of a JDK, from which the tables deviate. */
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
        DEFAULT_RATE_HZ,
        seconds,
        0);
  }

  /**
   * Returns a control experiment in C++.
   *
   * @param repeat a number from 0 that distinguishes intended repetitions
   */
  public static Experiment control(
      WaitKind waiting, Scheduling scheduling, int seconds, int repeat) {
    return new Experiment(
        null,
        null,
        waiting,
        scheduling,
        Workload.EMPTY,
        BackgroundLoad.NONE,
        JitMode.DEFAULT,
        0,
        DEFAULT_RATE_HZ,
        seconds,
        repeat);
  }

  /** Whether the loop runs in C++. */
  public boolean isControl() {
    return jdk == null;
  }

  Experiment with(Collector other) {
    return copy(draft -> draft.collector = other);
  }

  Experiment with(WaitKind other, Scheduling otherScheduling) {
    return copy(
        draft -> {
          draft.waiting = other;
          draft.scheduling = otherScheduling;
        });
  }

  Experiment with(Workload other, BackgroundLoad otherLoad) {
    return copy(
        draft -> {
          draft.workload = other;
          draft.load = otherLoad;
        });
  }

  Experiment with(JitMode other) {
    return copy(draft -> draft.jit = other);
  }

  Experiment withHeap(int otherHeapMb) {
    return copy(draft -> draft.heapMb = otherHeapMb);
  }

  Experiment withSeconds(int otherSeconds) {
    return copy(draft -> draft.seconds = otherSeconds);
  }

  Experiment withRate(int otherRateHz) {
    return copy(draft -> draft.rateHz = otherRateHz);
  }

  /** Returns the time between two deadlines, ns. */
  public long periodNanos() {
    return NANOS_PER_SECOND / rateHz;
  }

  /**
   * Returns a name that contains every setting and is valid as a folder name. The rate is left out
   * if it is 1 kHz.
   */
  public String key() {
    String how = lower(waiting) + "-" + scheduling.label();
    String rate = rateHz == DEFAULT_RATE_HZ ? "" : "-" + rateHz + "hz";
    String again = repeat == 0 ? "" : "-" + repeat;
    if (isControl()) {
      return "cpp-" + how + rate + "-" + seconds + "s" + again;
    }
    return String.join(
            "-",
            jdk.label(),
            collector.label(),
            how,
            workload.label(),
            load.label(),
            jit.label(),
            heapMb + "m" + rate,
            seconds + "s")
        + again;
  }

  /** Returns the name of the runtime for a table. */
  String runtime() {
    return isControl() ? "C++" : jdk.label() + " " + collector.label();
  }

  /** Returns the name of a constant in lower case. */
  public static String lower(Enum<?> value) {
    return value.name().toLowerCase(Locale.ROOT);
  }

  private Experiment copy(Consumer<Draft> change) {
    Draft draft = new Draft(this);
    change.accept(draft);
    return draft.experiment();
  }

  /** An experiment while one of its settings changes. */
  private static final class Draft {
    private final Jdk jdk;
    private Collector collector;
    private WaitKind waiting;
    private Scheduling scheduling;
    private Workload workload;
    private BackgroundLoad load;
    private JitMode jit;
    private int heapMb;
    private int rateHz;
    private int seconds;
    private final int repeat;

    Draft(Experiment from) {
      jdk = from.jdk;
      collector = from.collector;
      waiting = from.waiting;
      scheduling = from.scheduling;
      workload = from.workload;
      load = from.load;
      jit = from.jit;
      heapMb = from.heapMb;
      rateHz = from.rateHz;
      seconds = from.seconds;
      repeat = from.repeat;
    }

    Experiment experiment() {
      return new Experiment(
          jdk,
          collector,
          waiting,
          scheduling,
          workload,
          load,
          jit,
          heapMb,
          rateHz,
          seconds,
          repeat);
    }
  }
}
