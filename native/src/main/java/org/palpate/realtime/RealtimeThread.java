package org.palpate.realtime;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.palpate.loop.Pacer;
import org.palpate.loop.ThreadSetup;
import org.palpate.realtime.os.OperatingSystem;
import org.palpate.realtime.os.RealtimeRequest;
import org.palpate.realtime.os.RequestOutcome;
import org.palpate.realtime.os.Throttling;

/**
 * Prepares the haptic thread for real time and waits for its deadlines. It implements both ports of
 * the loop, because the wait measures its spin window in the thread after the set-up.
 *
 * <pre>
 *   LoopSettings plain = LoopSettings.ofRate(1000);
 *   RealtimeThread thread = RealtimeThread.recommended(plain.periodNanos());
 *   LoopSettings settings = plain.with(thread, thread);
 * </pre>
 *
 * <p>{@link #setUp} and {@link #awaitUntil} are for the haptic thread; any thread may call the
 * rest.
 */
public final class RealtimeThread implements ThreadSetup, Pacer, AutoCloseable {
  private static final int WARM_UP_WAITS = 30_000;
  private static final long WARM_UP_WAIT_NANOS = 1_000;

  /** Requests that {@link ThreadSetup.Granted} reports in components of their own. */
  private static final Set<String> REPORTED_SEPARATELY = Set.of("class", "affinity", "memory_lock");

  private final RealtimeRequest request;
  private final WaitKind waiting;
  private final long periodNanos;
  private final Throttling throttling;
  private volatile List<RequestOutcome> outcomes = List.of();
  private volatile DeadlineWait wait = new ParkWait();

  /**
   * Creates a thread set-up with the given requests and the given kind of wait.
   *
   * @param periodNanos time between two frames, by which the wait chooses its spin
   */
  public RealtimeThread(RealtimeRequest request, WaitKind waiting, long periodNanos) {
    this.request = request;
    this.waiting = waiting;
    this.periodNanos = periodNanos;
    throttling = Throttling.read(Path.of("/"));
  }

  /**
   * Returns the set-up that the jitter laboratory recommends: a FIFO thread on a processor of its
   * own that sleeps and then spins.
   *
   * @param periodNanos time between two frames
   */
  public static RealtimeThread recommended(long periodNanos) {
    return new RealtimeThread(RealtimeRequest.recommended(), WaitKind.HYBRID, periodNanos);
  }

  /** Sends the requests, measures the wait and runs it until it is compiled: half a second. */
  @Override
  public Granted setUp() {
    outcomes = OperatingSystem.apply(request);
    DeadlineWait made = waiting.create(periodNanos);
    for (int i = 0; i < WARM_UP_WAITS; i++) {
      made.awaitUntil(System.nanoTime() + WARM_UP_WAIT_NANOS);
    }
    wait = made;
    return granted();
  }

  @Override
  public void awaitUntil(long deadlineNanos) {
    wait.awaitUntil(deadlineNanos);
  }

  /** Returns the outcome of every request, in the order of the requests; empty before set-up. */
  public List<RequestOutcome> outcomes() {
    return outcomes;
  }

  /** Returns a description of the wait, such as {@code hybrid, spins 60 us}; park before set-up. */
  public String waiting() {
    return wait.toString();
  }

  /** Returns how often the wait saw the kernel throttle the thread; 0 if it cannot see that. */
  public long throttled() {
    return wait instanceof HybridWait hybrid ? hybrid.throttled() : 0;
  }

  private Granted granted() {
    String schedulingClass = "default";
    String affinity = "any";
    boolean locked = false;
    for (RequestOutcome outcome : outcomes) {
      boolean isClass = outcome.request().equals("class") && outcome.granted();
      boolean isAffinity = outcome.request().equals("affinity") && outcome.granted();
      schedulingClass = isClass ? outcome.detail() : schedulingClass;
      affinity = isAffinity ? outcome.detail() : affinity;
      locked |= outcome.request().equals("memory_lock") && outcome.granted();
    }
    return new Granted(schedulingClass, affinity, locked, others(), denials());
  }

  private Map<String, String> others() {
    Map<String, String> words = new LinkedHashMap<>();
    for (RequestOutcome outcome : outcomes) {
      if (!REPORTED_SEPARATELY.contains(outcome.request())) {
        words.put(outcome.request(), outcome.granted() ? outcome.detail() : outcome.word());
      }
    }
    words.put("wait", waiting());
    words.putAll(OperatingSystem.kernelSettings());
    return words;
  }

  private List<String> denials() {
    List<String> lines = new ArrayList<>();
    outcomes.stream()
        .filter(outcome -> !outcome.granted())
        .map(RequestOutcome::toString)
        .forEach(lines::add);
    boolean realtime =
        outcomes.stream()
            .anyMatch(outcome -> outcome.request().equals("class") && outcome.granted());
    if (realtime && !request.sleepsEachFrame() && throttling.limits()) {
      lines.add(
          "throttling: the kernel stops a thread that never sleeps for "
              + throttling.restMicros() / 1000
              + " of every "
              + throttling.periodMicros() / 1000
              + " ms");
    }
    return lines;
  }

  /** Releases the system's resources; call it after the thread has ended. */
  @Override
  public void close() {
    wait.close();
  }
}
