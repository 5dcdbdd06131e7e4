package org.palpate.statistics;

import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;

/**
 * The number of skips of each kind. Solvers, ray casters and collision scenes count for themselves
 * and add their counts when a report asks for them.
 *
 * <p>One thread. Adding to one kind allocates nothing.
 */
public final class SkipCounters {
  private final Map<SkipKind, AtomicLong> counts = new EnumMap<>(SkipKind.class);

  /** Creates counters that are all zero. */
  public SkipCounters() {
    for (SkipKind kind : SkipKind.values()) {
      counts.put(kind, new AtomicLong());
    }
  }

  /**
   * Adds skips of one kind.
   *
   * @param kind the work that was skipped
   * @param count the number of skips to add; negative to subtract
   */
  public void add(SkipKind kind, long count) {
    counts.get(kind).addAndGet(count);
  }

  /**
   * Adds all counts of other counters.
   *
   * @param other the counters to add; not changed
   */
  public void add(SkipCounters other) {
    other.counts.forEach((kind, count) -> add(kind, count.get()));
  }

  /**
   * Subtracts all counts of other counters.
   *
   * @param other the counters to subtract; not changed
   */
  public void subtract(SkipCounters other) {
    other.counts.forEach((kind, count) -> add(kind, -count.get()));
  }

  /**
   * {@return the count of one kind}
   *
   * @param kind the work that was skipped
   */
  public long of(SkipKind kind) {
    return counts.get(kind).get();
  }

  /** {@return the counts of all kinds by {@link SkipKind#key}, in the order of the kinds} */
  public Map<String, Long> byKey() {
    Map<String, Long> all = new LinkedHashMap<>();
    for (SkipKind kind : SkipKind.values()) {
      all.put(kind.key(), of(kind));
    }
    return all;
  }
}
