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
import org.palpate.realtime.os.ThreadCounters;

/**
 * The loop that is measured: sets its thread up, warms its frame up, then runs it on a fixed grid
 * of deadlines. The waits are those of a session; the rule for deadlines that were missed is that
 * of the haptic loop: the next is the first at least half a period away.
 *
 * <p>Runs in the thread that is measured; allocates nothing between its first and its last frame.
 */
public final class ExperimentLoop implements Runnable {
  public static final String THREAD_NAME = "palpate-haptic";

  private static final long WARM_UP_NANOS = 2_500_000_000L;
  private static final int WARM_UP_LEAST_FRAMES = 10_000;
  private static final long WARM_UP_WAIT_NANOS = 1_000;
  private static final int PACED_WARM_UP_FRAMES = 300;

  private final ExperimentTask task;
  private final Runnable frame;
  private final Samples samples;
  private final Properties answers = new Properties();
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

  /** What ended the loop before its time; null where nothing did. */
  Throwable failure() {
    return failure;
  }

  Samples samples() {
    return samples;
  }

  /** What the system granted, how the warm-up went, what the thread allocated. */
  Properties answers() {
    return answers;
  }

  private void measure() {
    recordOutcomes(OperatingSystem.apply(wish()));
    try (DeadlineWait wait = task.waiting().create();
        ThreadCounters counters = new ThreadCounters()) {
      recordWarmUp(warmUp(wait, counters));
      pace(wait, counters, new Samples(PACED_WARM_UP_FRAMES));
      long before = allocatedBytes();
      pace(wait, counters, samples);
      long after = allocatedBytes();
      answers.setProperty("allocated_bytes", Long.toString(Math.max(0, after - before)));
      recordWait(wait);
    }
  }

  private SteadyWarmUp.Result warmUp(DeadlineWait wait, ThreadCounters counters) {
    Runnable rehearsed = () -> rehearse(wait, counters);
    return new SteadyWarmUp().run(rehearsed, WARM_UP_LEAST_FRAMES, WARM_UP_NANOS);
  }

  /** All of a paced frame but the sleep. */
  private void rehearse(DeadlineWait wait, ThreadCounters counters) {
    wait.awaitUntil(System.nanoTime() + WARM_UP_WAIT_NANOS);
    frame.run();
    counters.read();
  }

  private RealtimeRequest wish() {
    if (!task.scheduling().isRealtime()) {
      return RealtimeRequest.none();
    }
    boolean raiseVm = task.scheduling() == Scheduling.FIFO_WITH_VM;
    return new RealtimeRequest(SchedulingClass.FIFO, true, true, raiseVm, task.waiting().sleeps());
  }

  private void pace(DeadlineWait wait, ThreadCounters counters, Samples noted) {
    long due = System.nanoTime() + task.periodNanos();
    while (!noted.isFull()) {
      wait.awaitUntil(due);
      long start = System.nanoTime();
      frame.run();
      long end = System.nanoTime();
      counters.read();
      noted.note(
          due, start, end, counters.delayedNanos(), counters.preempted(), counters.majorFaults());
      due = nextDue(due, start, task.periodNanos());
    }
  }

  /** The first deadline of the grid that is at least half a period after {@code began}. */
  static long nextDue(long due, long began, long periodNanos) {
    long late = began - due;
    long missed = late > periodNanos / 2 ? (late + periodNanos / 2) / periodNanos : 0;
    return due + (missed + 1) * periodNanos;
  }

  private void recordOutcomes(List<RequestOutcome> grants) {
    for (RequestOutcome grant : grants) {
      answers.setProperty("grant." + grant.wish(), grant.word() + " " + grant.detail());
    }
  }

  private void recordWarmUp(SteadyWarmUp.Result result) {
    long started = ManagementFactory.getRuntimeMXBean().getStartTime();
    answers.setProperty("warm_up.steady", Boolean.toString(result.steady()));
    answers.setProperty("warm_up.frames", Long.toString(result.frames()));
    answers.setProperty("warm_up.nanos", Long.toString(result.nanos()));
    answers.setProperty("warm_up.median_nanos", Long.toString(result.medianNanos()));
    answers.setProperty(
        "start_to_steady_millis", Long.toString(System.currentTimeMillis() - started));
  }

  private void recordWait(DeadlineWait wait) {
    if (wait instanceof HybridWait hybrid) {
      answers.setProperty("spin_window_nanos", Long.toString(hybrid.windowNanos()));
      answers.setProperty("longest_spin_gap_nanos", Long.toString(hybrid.longestGapNanos()));
      answers.setProperty("throttled", Long.toString(hybrid.throttled()));
    }
  }

  private static long allocatedBytes() {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    return threads.getCurrentThreadAllocatedBytes();
  }
}
