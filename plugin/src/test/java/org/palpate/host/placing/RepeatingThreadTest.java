package org.palpate.host.placing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class RepeatingThreadTest {
  private static final long HOUR_NANOS = TimeUnit.HOURS.toNanos(1);

  private final CountDownLatch ended = new CountDownLatch(1);

  private RepeatingThread thread(long pauseNanos, CountDownLatch work) {
    return new RepeatingThread("repeating-test", pauseNanos, work::countDown, ended::countDown);
  }

  @Test
  void repeatsItsWorkUntilItIsClosed() throws InterruptedException {
    CountDownLatch work = new CountDownLatch(3);
    try (RepeatingThread thread = thread(1000, work)) {
      thread.start();
      assertTrue(work.await(30, TimeUnit.SECONDS));
      assertEquals(1, ended.getCount());
    }
    assertTrue(ended.await(30, TimeUnit.SECONDS));
  }

  @Test
  void closingWakesItFromItsPause() throws InterruptedException {
    CountDownLatch work = new CountDownLatch(1);
    try (RepeatingThread thread = thread(HOUR_NANOS, work)) {
      thread.start();
      assertTrue(work.await(30, TimeUnit.SECONDS));
    }
    assertTrue(ended.await(30, TimeUnit.SECONDS));
  }

  @Test
  void oneThatNeverRanIsClosedWithoutWork() {
    CountDownLatch work = new CountDownLatch(1);
    thread(HOUR_NANOS, work).close();
    assertEquals(1, work.getCount());
    assertEquals(1, ended.getCount());
  }
}
