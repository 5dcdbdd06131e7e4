package org.palpate.realtime.os;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class OperatingSystemTest {
  @Test
  void everyDeniedRequestHasAReason() throws InterruptedException {
    List<RequestOutcome> outcomes = new ArrayList<>();
    Thread thread =
        new Thread(
            () ->
                outcomes.addAll(
                    OperatingSystem.apply(
                        new RealtimeRequest(SchedulingClass.FIFO, true, false, true, true))));
    thread.start();
    thread.join();
    assertFalse(outcomes.isEmpty());
    for (RequestOutcome outcome : outcomes) {
      assertTrue(
          outcome.granted() || !outcome.detail().isEmpty(), "denied without a reason: " + outcome);
    }
  }

  @Test
  void sleepsWithoutAllocating() {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    try (PreciseSleep sleep = OperatingSystem.sleep()) {
      long past = System.nanoTime();
      sleepOften(sleep, past, 20_000);
      long before = threads.getCurrentThreadAllocatedBytes();
      sleepOften(sleep, past, 20_000);
      long allocated = threads.getCurrentThreadAllocatedBytes() - before;
      // The counter itself allocates a few hundred bytes; an allocating sleep takes 320,000.
      assertTrue(allocated < 20_000, "bytes=" + allocated);
    }
  }

  @Test
  void printsGrantedOrRefused() {
    assertEquals("granted", RequestOutcome.granted("class", "fifo 40").word());
    assertEquals("refused", RequestOutcome.denied("class", "EPERM").word());
    assertEquals("class: refused (EPERM)", RequestOutcome.denied("class", "EPERM").toString());
  }

  private static void sleepOften(PreciseSleep sleep, long past, int times) {
    for (int i = 0; i < times; i++) {
      sleep.until(past);
    }
  }
}
