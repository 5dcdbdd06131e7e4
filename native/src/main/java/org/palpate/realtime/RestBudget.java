package org.palpate.realtime;

import org.palpate.realtime.os.Throttling;

/**
 * The sleep that a real-time thread owes the kernel. A thread that never sleeps loses its processor
 * for the whole forced rest, 50 ms in each second by default. One that sleeps a little more than
 * that fraction, in small pieces, never does.
 *
 * <p>Each nanosecond that passes adds a fraction to the debt, and sleep pays it. Sleep in advance
 * counts for nothing, because the kernel may have begun a new period since. One thread.
 */
final class RestBudget {
  /**
   * The sleep over the forced rest: 6.5 % for the kernel's default of 5 %. Falling asleep and
   * waking up count as running, so the kernel sees 6.1 %. The rest above 5 % is for other real-time
   * threads of the same processor, such as the VM thread.
   */
  private static final double MARGIN = 1.3;

  /** A smaller debt is not worth a sleep, whose two switches take some microseconds, ns. */
  static final long LEAST_NANOS = 50_000;

  /** A debt that is paid even if a frame is late then, ns. */
  static final long MOST_NANOS = 2_000_000;

  private static final long NANOS_PER_MICRO = 1000;

  private final double fraction;
  private final double mostOwedNanos;
  private double owedNanos;
  private long lastNanos;
  private boolean begun;

  /** Makes a budget without a debt. */
  RestBudget(Throttling throttling) {
    fraction =
        throttling.limits()
            ? Math.min(1, MARGIN * throttling.restMicros() / throttling.periodMicros())
            : 0;
    mostOwedNanos = fraction * throttling.periodMicros() * NANOS_PER_MICRO;
  }

  /**
   * Returns when a sleep is to end that begins now; the present time if none is due.
   *
   * @param nowNanos never goes back
   * @param deadlineNanos a debt up to {@link #MOST_NANOS} waits if it cannot be paid before it
   */
  long wakeNanos(long nowNanos, long deadlineNanos) {
    if (begun) {
      owedNanos = Math.min(mostOwedNanos, owedNanos + fraction * (nowNanos - lastNanos));
    }
    begun = true;
    lastNanos = nowNanos;
    long wake = nowNanos + (long) Math.ceil(owedNanos);
    boolean isDue = owedNanos >= LEAST_NANOS;
    boolean mayBeLate = owedNanos >= MOST_NANOS;
    return isDue && (wake <= deadlineNanos || mayBeLate) ? wake : nowNanos;
  }

  /** Notes that the thread slept since {@link #wakeNanos} was asked. */
  void slept(long nowNanos) {
    owedNanos = Math.max(0, owedNanos - (nowNanos - lastNanos));
    lastNanos = nowNanos;
  }
}
