package org.palpate.benchmarks.jitter.trace;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;

/** Counts causes by kind. */
public final class CauseCounts {
  private CauseCounts() {}

  /** Returns text such as {@code 7 GC, 3 outside the JVM}, the most frequent first. */
  public static String text(List<Cause> causes) {
    Map<Cause.Kind, Long> counts =
        causes.stream()
            .collect(Collectors.groupingBy(Cause::kind, TreeMap::new, Collectors.counting()));
    return counts.entrySet().stream()
        .sorted(Map.Entry.<Cause.Kind, Long>comparingByValue().reversed())
        .map(entry -> entry.getValue() + " " + entry.getKey().label())
        .collect(Collectors.joining(", "));
  }
}
