package org.palpate.realtime;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class RealtimeTest {
  @Test
  void answersEveryWishInAThreadOfItsOwn() throws InterruptedException {
    List<Grant> grants = new ArrayList<>();
    Thread thread =
        new Thread(
            () ->
                grants.addAll(
                    Realtime.apply(
                        new RealtimeWish(SchedulingClass.FIFO, true, false, true, true))));
    thread.start();
    thread.join();
    assertFalse(grants.isEmpty());
    for (Grant grant : grants) {
      assertTrue(grant.granted() || !grant.detail().isEmpty(), "refused without a why: " + grant);
    }
  }

  @Test
  void sleepsWithoutAllocating() {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    try (PreciseSleep sleep = Realtime.sleep()) {
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
    assertEquals("granted", Grant.granted("class", "fifo 40").word());
    assertEquals("refused", Grant.refused("class", "EPERM").word());
    assertEquals("class: refused (EPERM)", Grant.refused("class", "EPERM").toString());
  }

  private static void sleepOften(PreciseSleep sleep, long past, int times) {
    for (int i = 0; i < times; i++) {
      sleep.until(past);
    }
  }
}
