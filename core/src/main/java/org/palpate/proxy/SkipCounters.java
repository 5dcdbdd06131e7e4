package org.palpate.proxy;

import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;

/**
 * How often what was skipped: a solver counts for itself and adds what it has when it is asked. One
 * thread; adding to a kind allocates nothing.
 */
public final class SkipCounters {
  private final Map<SkipKind, AtomicLong> counts = new EnumMap<>(SkipKind.class);

  /** Nothing was skipped yet. */
  public SkipCounters() {
    for (SkipKind kind : SkipKind.values()) {
      counts.put(kind, new AtomicLong());
    }
  }

  /** Adds to a kind. */
  public void add(SkipKind kind, long count) {
    counts.get(kind).addAndGet(count);
  }

  /** Adds all of another. */
  public void add(SkipCounters other) {
    other.counts.forEach((kind, count) -> add(kind, count.get()));
  }

  /** Takes all of another off. */
  public void subtract(SkipCounters other) {
    other.counts.forEach((kind, count) -> add(kind, -count.get()));
  }

  /** The count of a kind. */
  public long of(SkipKind kind) {
    return counts.get(kind).get();
  }

  /** Counts by {@link SkipKind#key}, every kind. */
  public Map<String, Long> byKey() {
    Map<String, Long> all = new LinkedHashMap<>();
    for (SkipKind kind : SkipKind.values()) {
      all.put(kind.key(), of(kind));
    }
    return all;
  }
}
