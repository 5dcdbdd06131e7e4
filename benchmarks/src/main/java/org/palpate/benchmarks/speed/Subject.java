package org.palpate.benchmarks.speed;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * A benchmark to run, and with which values of its parameters.
 *
 * @param group which table it belongs to
 * @param type its class
 * @param method its method
 * @param params values by parameter; every combination is run, others keep their own
 * @param heapMegabytes what its process may take
 * @param isFrame whether it is code of a frame, which must allocate nothing
 */
record Subject(
    String group,
    Class<?> type,
    String method,
    Map<String, String[]> params,
    int heapMegabytes,
    boolean isFrame) {
  private static final int HEAP_MEGABYTES = 1024;

  /** Code of a frame, with a heap for phantoms. */
  static Subject frame(String group, Class<?> type, String method) {
    return new Subject(group, type, method, Map.of(), HEAP_MEGABYTES, true);
  }

  /** Code that may allocate. */
  static Subject other(String group, Class<?> type, String method) {
    return new Subject(group, type, method, Map.of(), HEAP_MEGABYTES, false);
  }

  /** With one parameter more. */
  Subject with(String name, String... values) {
    Map<String, String[]> more = new LinkedHashMap<>(params);
    more.put(name, values);
    return new Subject(group, type, method, more, heapMegabytes, isFrame);
  }

  /** With another heap. */
  Subject withHeap(int megabytes) {
    return new Subject(group, type, method, params, megabytes, isFrame);
  }

  /** How many conditions there are. */
  int conditions() {
    return params.values().stream().mapToInt(values -> values.length).reduce(1, (a, b) -> a * b);
  }
}
