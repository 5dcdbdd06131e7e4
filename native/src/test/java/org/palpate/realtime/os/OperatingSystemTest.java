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
  void answersEveryWishInAThreadOfItsOwn() throws InterruptedException {
    List<RequestOutcome> grants = new ArrayList<>();
    Thread thread =
        new Thread(
            () ->
                grants.addAll(
                    OperatingSystem.apply(
                        new RealtimeRequest(SchedulingClass.FIFO, true, false, true, true))));
    thread.start();
    thread.join();
    assertFalse(grants.isEmpty());
    for (RequestOutcome grant : grants) {
      assertTrue(grant.granted() || !grant.detail().isEmpty(), "refused without a why: " + grant);
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
      // The counter itself takes a few hundred bytes; a sleep that allocates takes 320,000.
      assertTrue(allocated < 20_000, "bytes=" + allocated);
    }
  }

  @Test
  void saysGrantedOrRefusedAndNothingElse() {
    assertEquals("granted", RequestOutcome.granted("class", "fifo 40").word());
    assertEquals("refused", RequestOutcome.refused("class", "EPERM").word());
    assertEquals("class: refused (EPERM)", RequestOutcome.refused("class", "EPERM").toString());
  }

  private static void sleepOften(PreciseSleep sleep, long past, int times) {
    for (int i = 0; i < times; i++) {
      sleep.until(past);
    }
  }
}
