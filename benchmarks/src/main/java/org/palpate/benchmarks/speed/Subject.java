package org.palpate.benchmarks.speed;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * A benchmark with the values of its parameters.
 *
 * @param group the table that it belongs to
 * @param type its class
 * @param method its method
 * @param params values by parameter; every combination runs, other parameters have their defaults
 * @param heapMegabytes the heap of its process
 * @param isFrame whether it is frame code, which must allocate nothing
 */
record Subject(
    String group,
    Class<?> type,
    String method,
    Map<String, String[]> params,
    int heapMegabytes,
    boolean isFrame) {
  private static final int HEAP_MEGABYTES = 1024;

  /** Returns frame code with a heap for phantoms. */
  static Subject frame(String group, Class<?> type, String method) {
    return new Subject(group, type, method, Map.of(), HEAP_MEGABYTES, true);
  }

  /** Returns code that may allocate. */
  static Subject other(String group, Class<?> type, String method) {
    return new Subject(group, type, method, Map.of(), HEAP_MEGABYTES, false);
  }

  /** Returns this subject with one more parameter. */
  Subject with(String name, String... values) {
    Map<String, String[]> more = new LinkedHashMap<>(params);
    more.put(name, values);
    return new Subject(group, type, method, more, heapMegabytes, isFrame);
  }

  /** Returns this subject with another heap. */
  Subject withHeap(int megabytes) {
    return new Subject(group, type, method, params, megabytes, isFrame);
  }

  /** Returns the number of combinations. */
  int conditions() {
    return params.values().stream().mapToInt(values -> values.length).reduce(1, (a, b) -> a * b);
  }
}
