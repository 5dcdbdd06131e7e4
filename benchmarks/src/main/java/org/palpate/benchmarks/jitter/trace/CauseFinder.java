package org.palpate.benchmarks.jitter.trace;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;
import org.palpate.benchmarks.jitter.trace.JvmEvent.Kind;

/**
 * Finds the causes of late frames from the JVM's events and the kernel's counters between a frame's
 * deadline and its end.
 *
 * <p>Times in which the thread certainly could not run (pauses, stalls, ready but not running) come
 * first. If they make up half of the delay, the largest of them is the cause. Otherwise the frame's
 * own work, page faults and stolen time are considered. A delay without any of these lies outside
 * the JVM and outside of what this kernel counts.
 */
public final class CauseFinder {
  private static final int INTERPRETER_FACTOR = 50;

  private final List<JvmEvent> events;
  private final MachineActivity machine;
  private final boolean realtime;
  private final long typicalWorkNanos;

  /**
   * Creates a finder.
   *
   * @param events the JVM's events on the clock of the samples, by start
   * @param typicalWorkNanos the typical duration of a frame's work
   * @param realtime whether the loop ran before all ordinary threads, so that a compiler or a
   *     concurrent collector cannot have used its processor
   */
  public CauseFinder(
      List<JvmEvent> events, MachineActivity machine, long typicalWorkNanos, boolean realtime) {
    this.events = List.copyOf(events);
    this.machine = machine;
    this.typicalWorkNanos = typicalWorkNanos;
    this.realtime = realtime;
  }

  /** Returns the causes of the {@code count} frames with the latest force, the worst first. */
  public List<Cause> worst(Samples samples, int count) {
    Comparator<Integer> byResponse =
        Comparator.comparingLong((Integer frame) -> samples.response(frame))
            .thenComparing(Comparator.reverseOrder());
    PriorityQueue<Integer> worst = new PriorityQueue<>(byResponse);
    for (int i = 0; i < samples.count(); i++) {
      worst.add(i);
      if (worst.size() > count) {
        worst.poll();
      }
    }
    List<Integer> frames = new ArrayList<>(worst);
    frames.sort(byResponse.reversed());
    return frames.stream().map(frame -> causeOf(samples, frame)).toList();
  }

  /** Returns the cause of one frame's delay. */
  Cause causeOf(Samples samples, int frame) {
    DelayParts parts = new DelayParts(events, samples, frame, machine);
    return new Cause(
        kindOf(parts),
        frame,
        samples.due(frame),
        samples.lateness(frame),
        samples.work(frame),
        parts.text());
  }

  private Cause.Kind kindOf(DelayParts parts) {
    if (parts.isHalf(parts.stopped())) {
      return stopCause(parts);
    }
    if (parts.isHalf(parts.work) && parts.deoptimizations > 0) {
      return Cause.Kind.DEOPTIMIZATION;
    }
    if (parts.isHalf(parts.work) && possiblyInterpreted(parts)) {
      return Cause.Kind.JIT;
    }
    if (parts.faults > 0) {
      return Cause.Kind.PAGING;
    }
    return parts.isHalf(parts.stolen) ? Cause.Kind.STEAL : Cause.Kind.OUTSIDE;
  }

  /** Whether interpretation explains the work; it is tens of times slower, not hundreds. */
  private boolean possiblyInterpreted(DelayParts parts) {
    return 2 * parts.compilation >= parts.work
        && parts.work <= INTERPRETER_FACTOR * typicalWorkNanos;
  }

  private Cause.Kind stopCause(DelayParts parts) {
    long collector = parts.pause + parts.stall;
    if (collector >= parts.safepoint && collector >= parts.delayed) {
      return Cause.Kind.GC;
    }
    if (parts.safepoint >= parts.delayed) {
      return Cause.Kind.SAFEPOINT;
    }
    if (!realtime && 2 * parts.compilation >= parts.delayed) {
      return Cause.Kind.JIT;
    }
    return !realtime && 2 * parts.concurrentCollection >= parts.delayed
        ? Cause.Kind.GC
        : Cause.Kind.SCHEDULER;
  }

  /** The known parts of one delay, ns. */
  private static final class DelayParts {
    private final long from;
    private final long to;
    private final List<JvmEvent> events;
    private final long pause;
    private final long safepoint;
    private final long stall;
    private final long delayed;
    private final long compilation;
    private final long concurrentCollection;
    private final long deoptimizations;
    private final long work;
    private final long faults;
    private final long preempted;
    private final long stolen;

    DelayParts(List<JvmEvent> all, Samples samples, int frame, MachineActivity machine) {
      from = samples.due(frame);
      to = samples.end(frame);
      events = all.stream().filter(this::touches).toList();
      pause = covered(Kind.GC_PAUSE);
      safepoint = covered(Kind.SAFEPOINT);
      stall = covered(Kind.ALLOCATION_STALL);
      compilation = covered(Kind.COMPILATION);
      concurrentCollection = covered(Kind.GC_CONCURRENT);
      deoptimizations = events.stream().filter(this::isOwnDeoptimization).count();
      delayed = Math.min(samples.delayed(frame), to - from);
      work = samples.work(frame);
      faults = samples.faults(frame);
      preempted = samples.preempted(frame);
      stolen = machine.stolenBetween(from, to);
    }

    private boolean touches(JvmEvent event) {
      return event.startNanos() <= to && event.endNanos() >= from;
    }

    private boolean isOwnDeoptimization(JvmEvent event) {
      return event.kind() == Kind.DEOPTIMIZATION && event.inMeasuredThread();
    }

    /**
     * Returns how much of the delay the events of a kind cover together. A stall counts only in the
     * measured thread.
     */
    private long covered(Kind kind) {
      long sum = 0;
      long reached = from;
      for (JvmEvent event : events) { // by start
        boolean counts = kind != Kind.ALLOCATION_STALL || event.inMeasuredThread();
        if (event.kind() == kind && counts) {
          sum += event.overlapNanos(reached, to);
          reached = Math.max(reached, Math.min(event.endNanos(), to));
        }
      }
      return sum;
    }

    long stopped() {
      return pause + safepoint + stall + delayed;
    }

    boolean isHalf(long nanos) {
      return 2 * nanos >= to - from;
    }

    String text() {
      List<String> texts = new ArrayList<>();
      addNamed(texts, pause, "paused for the collector", Kind.GC_PAUSE);
      addNamed(texts, safepoint, "in a safepoint", Kind.SAFEPOINT);
      addMicros(texts, stall, "waiting for memory");
      addMicros(texts, delayed, "ready but not running");
      addNamed(texts, compilation, "during a compilation", Kind.COMPILATION);
      addNamed(texts, concurrentCollection, "during a concurrent collection", Kind.GC_CONCURRENT);
      addCount(texts, deoptimizations, "deoptimizations of the frame");
      addCount(texts, preempted, "preemptions");
      addCount(texts, faults, "pages from a disk");
      addMicros(texts, stolen, "stolen by the hypervisor about then, all processors");
      return texts.isEmpty() ? "nothing recorded" : String.join(", ", texts);
    }

    private void addNamed(List<String> parts, long nanos, String what, Kind kind) {
      if (nanos > 0) {
        String longest =
            events.stream()
                .filter(event -> event.kind() == kind)
                .max(Comparator.comparingLong(event -> event.overlapNanos(from, to)))
                .map(JvmEvent::what)
                .orElse("");
        parts.add(nanos / 1000 + " us " + what + " (" + longest + ")");
      }
    }

    private static void addMicros(List<String> parts, long nanos, String what) {
      if (nanos >= 1000) {
        parts.add(nanos / 1000 + " us " + what);
      }
    }

    private static void addCount(List<String> parts, long count, String what) {
      if (count > 0) {
        parts.add(count + " " + what);
      }
    }
  }
}
