package org.palpate.benchmarks.jitter.experiment;

import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import org.junit.jupiter.api.Test;

class ThreadCountersTest {
  @Test
  void neverDecrease() {
    try (ThreadCounters counters = new ThreadCounters()) {
      long delayed = 0;
      long preempted = 0;
      for (int i = 0; i < 1_000; i++) {
        counters.read();
        assertTrue(counters.delayedNanos() >= delayed, "delayedNanos=" + counters.delayedNanos());
        assertTrue(counters.preempted() >= preempted, "preempted=" + counters.preempted());
        delayed = counters.delayedNanos();
        preempted = counters.preempted();
      }
    }
  }

  @Test
  void readWithoutAllocating() {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    try (ThreadCounters counters = new ThreadCounters()) {
      readOften(counters);
      long before = threads.getCurrentThreadAllocatedBytes();
      readOften(counters);
      long allocated = threads.getCurrentThreadAllocatedBytes() - before;
      assertTrue(allocated < 20_000, "bytes=" + allocated);
    }
  }

  private static void readOften(ThreadCounters counters) {
    for (int i = 0; i < 20_000; i++) {
      counters.read();
    }
  }
}
