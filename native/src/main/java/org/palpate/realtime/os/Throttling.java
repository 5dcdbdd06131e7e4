package org.palpate.realtime.os;

import java.nio.file.Path;
import java.util.OptionalLong;

/**
 * The kernel's limit on the processor time of real-time threads.
 *
 * @param runtimeMicros the time that they may run in each period; the whole period if unlimited
 * @param periodMicros the length of a period
 */
public record Throttling(long runtimeMicros, long periodMicros) {
  /** A gap counts as throttling if it is at least this fraction of the forced rest. */
  private static final double GAP_FRACTION = 0.8;

  static final Throttling NONE = new Throttling(1, 1);

  /** Reads the limit under {@code root}; {@link #NONE} if there is no limit. */
  public static Throttling read(Path root) {
    OptionalLong runtime = KernelFiles.number(root.resolve("proc/sys/kernel/sched_rt_runtime_us"));
    OptionalLong period = KernelFiles.number(root.resolve("proc/sys/kernel/sched_rt_period_us"));
    if (runtime.isEmpty() || period.isEmpty() || runtime.getAsLong() < 0) {
      return NONE;
    }
    return new Throttling(runtime.getAsLong(), period.getAsLong());
  }

  /** Whether the kernel limits real-time threads. */
  public boolean limits() {
    return runtimeMicros < periodMicros;
  }

  /** Returns the limit as text, such as {@code 950 of 1000 ms} or {@code none}. */
  String text() {
    return limits() ? runtimeMicros / 1000 + " of " + periodMicros / 1000 + " ms" : "none";
  }

  /** Returns the time in each period in which a thread that never sleeps may not run. */
  public long restMicros() {
    return periodMicros - runtimeMicros;
  }

  /** Returns the shortest gap in a spin that counts as throttling, ns; unreachable if unlimited. */
  public long gapNanos() {
    return limits() ? (long) (restMicros() * 1000 * GAP_FRACTION) : Long.MAX_VALUE;
  }
}
