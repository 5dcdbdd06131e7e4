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
 * Makes the haptic thread fit and lets it wait: both ports of the loop, since how long before a
 * deadline the wait must wake is measured by the thread once it is set up.
 *
 * <pre>
 *   RealtimeThread thread = RealtimeThread.recommended();
 *   LoopSettings settings = LoopSettings.ofRate(1000).with(thread, thread);
 * </pre>
 *
 * <p>{@link #setUp} and {@link #awaitUntil} are for the haptic thread, the rest for any.
 */
public final class RealtimeThread implements ThreadSetup, Pacer, AutoCloseable {
  private static final int WARM_UP_WAITS = 30_000;
  private static final long WARM_UP_WAIT_NANOS = 1_000;

  /** Wishes that {@link ThreadSetup.Granted} tells by fields of their own. */
  private static final Set<String> REPORTED_SEPARATELY = Set.of("class", "affinity", "memory_lock");

  private final RealtimeRequest wish;
  private final WaitKind waiting;
  private final Throttling throttling;
  private volatile List<RequestOutcome> grants = List.of();
  private volatile DeadlineWait wait = new ParkWait();

  /** A thread that asks for {@code wish} and waits in one of the known ways. */
  public RealtimeThread(RealtimeRequest wish, WaitKind waiting) {
    this.wish = wish;
    this.waiting = waiting;
    throttling = Throttling.read(Path.of("/"));
  }

  /**
   * What the laboratory found best: sleep then spin, before ordinary threads, on a processor of its
   * own.
   */
  public static RealtimeThread recommended() {
    return new RealtimeThread(RealtimeRequest.usual(), WaitKind.HYBRID);
  }

  /** Asks the system, measures the wait, and runs it until it is compiled. Takes half a second. */
  @Override
  public Granted setUp() {
    grants = OperatingSystem.apply(wish);
    DeadlineWait made = waiting.create();
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

  /** Every wish with its answer, in the order in which they were asked; empty before the set-up. */
  public List<RequestOutcome> grants() {
    return grants;
  }

  /** How it waits, in words, as {@code hybrid, spins 60 us}; park before the set-up. */
  public String waiting() {
    return wait.toString();
  }

  /** How often the kernel was seen to force its rest on the thread, where the wait can tell. */
  public long throttled() {
    return wait instanceof HybridWait hybrid ? hybrid.throttled() : 0;
  }

  private Granted granted() {
    String schedulingClass = "default";
    String affinity = "any";
    boolean locked = false;
    for (RequestOutcome grant : grants) {
      boolean isClass = grant.wish().equals("class") && grant.granted();
      boolean isAffinity = grant.wish().equals("affinity") && grant.granted();
      schedulingClass = isClass ? grant.detail() : schedulingClass;
      affinity = isAffinity ? grant.detail() : affinity;
      locked |= grant.wish().equals("memory_lock") && grant.granted();
    }
    return new Granted(schedulingClass, affinity, locked, others(), refusals());
  }

  private Map<String, String> others() {
    Map<String, String> words = new LinkedHashMap<>();
    for (RequestOutcome grant : grants) {
      if (!REPORTED_SEPARATELY.contains(grant.wish())) {
        words.put(grant.wish(), grant.granted() ? grant.detail() : grant.word());
      }
    }
    words.put("wait", waiting());
    words.putAll(OperatingSystem.noticed());
    return words;
  }

  private List<String> refusals() {
    List<String> lines = new ArrayList<>();
    grants.stream()
        .filter(grant -> !grant.granted())
        .map(RequestOutcome::toString)
        .forEach(lines::add);
    boolean realtime =
        grants.stream().anyMatch(grant -> grant.wish().equals("class") && grant.granted());
    if (realtime && !wish.sleepsEachFrame() && throttling.limits()) {
      lines.add(
          "throttling: the kernel rests a thread that never sleeps "
              + throttling.restMicros() / 1000
              + " ms in every "
              + throttling.periodMicros() / 1000);
    }
    return lines;
  }

  /** Lets go what the system lent, after the thread has ended. */
  @Override
  public void close() {
    wait.close();
  }
}
