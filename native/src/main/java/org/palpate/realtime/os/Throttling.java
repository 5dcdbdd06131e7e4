package org.palpate.realtime.os;

import java.nio.file.Path;
import java.util.OptionalLong;

/**
 * How much of a processor the kernel lets real-time threads have.
 *
 * @param runtimeMicros of every period; as long as the period where there is no limit
 * @param periodMicros length of a period
 */
public record Throttling(long runtimeMicros, long periodMicros) {
  /** A gap counts as the kernel's own where it is at least this share of the forced rest. */
  private static final double GAP_SHARE = 0.8;

  static final Throttling NONE = new Throttling(1, 1);

  /** Reads the limit under {@code root}; {@link #NONE} where there is no such limit. */
  public static Throttling read(Path root) {
    OptionalLong runtime = KernelFiles.number(root.resolve("proc/sys/kernel/sched_rt_runtime_us"));
    OptionalLong period = KernelFiles.number(root.resolve("proc/sys/kernel/sched_rt_period_us"));
    if (runtime.isEmpty() || period.isEmpty() || runtime.getAsLong() < 0) {
      return NONE;
    }
    return new Throttling(runtime.getAsLong(), period.getAsLong());
  }

  public boolean limits() {
    return runtimeMicros < periodMicros;
  }

  /** As {@code 950 of 1000 ms}, or {@code none}. */
  String inWords() {
    return limits() ? runtimeMicros / 1000 + " of " + periodMicros / 1000 + " ms" : "none";
  }

  /** How long a thread that never sleeps is held back in every period. */
  public long restMicros() {
    return periodMicros - runtimeMicros;
  }

  /** The shortest gap in a spin that tells of throttling, ns; never reached where none limits. */
  public long gapNanos() {
    return limits() ? (long) (restMicros() * 1000 * GAP_SHARE) : Long.MAX_VALUE;
  }
}
