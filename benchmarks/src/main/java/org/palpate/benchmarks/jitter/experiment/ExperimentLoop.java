package org.palpate.benchmarks.jitter.experiment;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.Properties;
import org.palpate.benchmarks.jitter.trace.Samples;
import org.palpate.loop.SteadyWarmUp;
import org.palpate.realtime.DeadlineWait;
import org.palpate.realtime.HybridWait;
import org.palpate.realtime.os.OperatingSystem;
import org.palpate.realtime.os.RealtimeRequest;
import org.palpate.realtime.os.RequestOutcome;
import org.palpate.realtime.os.SchedulingClass;

/**
 * The measured loop. It sets its thread up, warms its frame up, and then runs one frame for each
 * absolute deadline of a fixed grid. It uses the waits of a session and the deadline rule of the
 * haptic loop: the next deadline is the first one that is at least half a period away.
 *
 * <p>Runs in the measured thread; allocates nothing between its first and its last frame.
 */
public final class ExperimentLoop implements Runnable {

  private static final long WARM_UP_NANOS = 2_500_000_000L;
  private static final int WARM_UP_MIN_FRAMES = 10_000;
  private static final long WARM_UP_WAIT_NANOS = 1_000;
  private static final int PACED_WARM_UP_FRAMES = 300;

  private final ExperimentTask task;
  private final Runnable frame;
  private final Samples samples;
  private final Properties outcome = new Properties();
  private Throwable failure;

  ExperimentLoop(ExperimentTask task, Runnable frame) {
    this.task = task;
    this.frame = frame;
    samples = new Samples(task.frames());
  }

  @Override
  public void run() {
    try {
      measure();
    } catch (Throwable thrown) {
      failure = thrown;
    }
  }

  /** Returns the throwable that ended the loop early; null if there was none. */
  Throwable failure() {
    return failure;
  }

  /** Returns the samples of all frames. */
  Samples samples() {
    return samples;
  }

  /** Returns the system's answers, the course of the warm-up and the bytes allocated. */
  Properties outcome() {
    return outcome;
  }

  private void measure() {
    recordRequests(OperatingSystem.apply(request()));
    try (DeadlineWait wait = task.waiting().create(task.periodNanos());
        ThreadCounters counters = new ThreadCounters()) {
      recordWarmUp(warmUp(wait, counters));
      pace(wait, counters, new Samples(PACED_WARM_UP_FRAMES));
      long before = allocatedBytes();
      pace(wait, counters, samples);
      long after = allocatedBytes();
      outcome.setProperty("allocated_bytes", Long.toString(Math.max(0, after - before)));
      recordWait(wait);
    }
  }

  private SteadyWarmUp.Result warmUp(DeadlineWait wait, ThreadCounters counters) {
    Runnable rehearsal = () -> rehearse(wait, counters);
    return new SteadyWarmUp().run(rehearsal, WARM_UP_MIN_FRAMES, WARM_UP_NANOS);
  }

  /** Runs a paced frame without its sleep. */
  private void rehearse(DeadlineWait wait, ThreadCounters counters) {
    wait.awaitUntil(System.nanoTime() + WARM_UP_WAIT_NANOS);
    frame.run();
    counters.read();
  }

  private RealtimeRequest request() {
    if (!task.scheduling().isRealtime()) {
      return RealtimeRequest.none();
    }
    boolean raiseVmThreads = task.scheduling() == Scheduling.FIFO_WITH_VM;
    return new RealtimeRequest(
        SchedulingClass.FIFO, true, true, raiseVmThreads, task.waiting().sleeps());
  }

  private void pace(DeadlineWait wait, ThreadCounters counters, Samples dest) {
    long due = System.nanoTime() + task.periodNanos();
    while (!dest.isFull()) {
      wait.awaitUntil(due);
      long start = System.nanoTime();
      frame.run();
      long end = System.nanoTime();
      counters.read();
      dest.add(
          due, start, end, counters.delayedNanos(), counters.preempted(), counters.majorFaults());
      due = nextDue(due, start, task.periodNanos());
    }
  }

  /** Returns the first deadline of the grid that is at least half a period after {@code began}. */
  static long nextDue(long due, long began, long periodNanos) {
    long late = began - due;
    long missed = late > periodNanos / 2 ? (late + periodNanos / 2) / periodNanos : 0;
    return due + (missed + 1) * periodNanos;
  }

  private void recordRequests(List<RequestOutcome> outcomes) {
    for (RequestOutcome answer : outcomes) {
      outcome.setProperty("grant." + answer.request(), answer.word() + " " + answer.detail());
    }
  }

  private void recordWarmUp(SteadyWarmUp.Result result) {
    long started = ManagementFactory.getRuntimeMXBean().getStartTime();
    outcome.setProperty("warm_up.steady", Boolean.toString(result.steady()));
    outcome.setProperty("warm_up.frames", Long.toString(result.frames()));
    outcome.setProperty("warm_up.nanos", Long.toString(result.nanos()));
    outcome.setProperty("warm_up.median_nanos", Long.toString(result.medianNanos()));
    outcome.setProperty(
        "start_to_steady_millis", Long.toString(System.currentTimeMillis() - started));
  }

  private void recordWait(DeadlineWait wait) {
    if (wait instanceof HybridWait hybrid) {
      outcome.setProperty("spin_window_nanos", Long.toString(hybrid.windowNanos()));
      outcome.setProperty("longest_spin_gap_nanos", Long.toString(hybrid.longestGapNanos()));
      outcome.setProperty("throttled", Long.toString(hybrid.throttled()));
    }
  }

  private static long allocatedBytes() {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    return threads.getCurrentThreadAllocatedBytes();
  }
}
