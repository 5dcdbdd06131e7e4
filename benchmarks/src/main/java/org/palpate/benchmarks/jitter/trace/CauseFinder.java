package org.palpate.benchmarks.jitter.trace;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;
import org.palpate.benchmarks.jitter.trace.JvmEvent.Kind;

/**
 * Says why frames were late: by what the JVM recorded and the kernel counted in the stretch from
 * the moment at which a frame was due to the moment at which its work was done.
 *
 * <p>What stopped the thread for sure (pauses, stalls, being ready and not running) counts first;
 * where it makes up half of the delay, its largest part is the cause. Else the frame's own work is
 * looked at, then pages and steal. What is left lies outside the JVM and outside of what this
 * kernel counts.
 */
public final class CauseFinder {
  private static final int INTERPRETER_FACTOR = 50;

  private final List<JvmEvent> events;
  private final MachineActivity machine;
  private final boolean realtime;
  private final long usualWorkNanos;

  /**
   * @param events on the samples' clock
   * @param usualWorkNanos how long a frame's work usually takes
   * @param realtime whether the loop ran before all ordinary threads, so that a compiler or
   *     collector beside it cannot have had its processor
   */
  public CauseFinder(
      List<JvmEvent> events, MachineActivity machine, long usualWorkNanos, boolean realtime) {
    this.events = List.copyOf(events);
    this.machine = machine;
    this.usualWorkNanos = usualWorkNanos;
    this.realtime = realtime;
  }

  /** The causes of the {@code count} frames whose force was out latest, the worst first. */
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

  /** The cause of one frame's delay. */
  Cause causeOf(Samples samples, int frame) {
    Shares shares = new Shares(events, samples, frame, machine);
    return new Cause(
        kindOf(shares),
        frame,
        samples.due(frame),
        samples.lateness(frame),
        samples.work(frame),
        shares.inWords());
  }

  private Cause.Kind kindOf(Shares shares) {
    if (shares.isHalf(shares.stopped())) {
      return stopCause(shares);
    }
    if (shares.isHalf(shares.work) && shares.deoptimizations > 0) {
      return Cause.Kind.DEOPTIMIZATION;
    }
    if (shares.isHalf(shares.work) && possiblyInterpreted(shares)) {
      return Cause.Kind.JIT;
    }
    if (shares.faults > 0) {
      return Cause.Kind.PAGING;
    }
    return shares.isHalf(shares.stolen) ? Cause.Kind.STEAL : Cause.Kind.OUTSIDE;
  }

  /** Interpreted code is some tens of times slower than compiled code, not hundreds of times. */
  private boolean possiblyInterpreted(Shares shares) {
    return 2 * shares.compilation >= shares.work
        && shares.work <= INTERPRETER_FACTOR * usualWorkNanos;
  }

  private Cause.Kind stopCause(Shares shares) {
    long collector = shares.pause + shares.stall;
    if (collector >= shares.safepoint && collector >= shares.delayed) {
      return Cause.Kind.GC;
    }
    if (shares.safepoint >= shares.delayed) {
      return Cause.Kind.SAFEPOINT;
    }
    if (!realtime && 2 * shares.compilation >= shares.delayed) {
      return Cause.Kind.JIT;
    }
    return !realtime && 2 * shares.concurrentCollection >= shares.delayed
        ? Cause.Kind.GC
        : Cause.Kind.SCHEDULER;
  }

  /** What is known about one delay, ns of it. */
  private static final class Shares {
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

    Shares(List<JvmEvent> all, Samples samples, int frame, MachineActivity machine) {
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
     * How much of the delay events of a kind cover together. A stall counts in our thread alone.
     */
    private long covered(Kind kind) {
      long sum = 0;
      long reached = from;
      for (JvmEvent event : events) { // by their begin
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

    String inWords() {
      List<String> parts = new ArrayList<>();
      addNamed(parts, pause, "paused for the collector", Kind.GC_PAUSE);
      addNamed(parts, safepoint, "in a safepoint", Kind.SAFEPOINT);
      addMicros(parts, stall, "waiting for memory");
      addMicros(parts, delayed, "ready but not running");
      addNamed(parts, compilation, "while compiled beside", Kind.COMPILATION);
      addNamed(
          parts, concurrentCollection, "while the collector worked beside", Kind.GC_CONCURRENT);
      addCount(parts, deoptimizations, "deoptimizations of the frame");
      addCount(parts, preempted, "times put off the processor");
      addCount(parts, faults, "pages from a disk");
      addMicros(parts, stolen, "stolen by the hypervisor about then, all processors");
      return parts.isEmpty() ? "nothing recorded" : String.join(", ", parts);
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
