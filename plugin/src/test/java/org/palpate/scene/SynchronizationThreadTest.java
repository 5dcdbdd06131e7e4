package org.palpate.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;

class SynchronizationThreadTest {
  private static final long PATIENCE_S = 60;

  private final AtomicInteger ticks = new AtomicInteger();
  private final AtomicInteger steps = new AtomicInteger();
  private final AtomicReference<RuntimeException> failure = new AtomicReference<>();

  @Test
  void eachTickComesWithFourStepsAndNotTooEarly() throws InterruptedException {
    CountDownLatch six = new CountDownLatch(6);
    long start = System.nanoTime();
    long end;
    try (SynchronizationThread thread =
        new SynchronizationThread(
            () -> {
              if (steps.get() != 4 * ticks.incrementAndGet()) {
                throw new IllegalStateException(steps + " steps before tick " + ticks);
              }
              six.countDown();
            },
            steps::incrementAndGet,
            failure::set)) {
      assertEquals(0, thread.rateHz());
      thread.start();
      assertTrue(six.await(PATIENCE_S, TimeUnit.SECONDS));
      end = System.nanoTime();
      assertTrue(thread.rateHz() <= 31, "rate " + thread.rateHz());
    }
    assertTrue(end - start >= 5 * SynchronizationThread.PERIOD_NANOS, "six ticks came too early");
    int ended = ticks.get();
    assertTrue(steps.get() >= 4 * ended && steps.get() <= 4 * ended + 4, steps + " in " + ended);
    assertEquals(null, failure.get());
  }

  @Test
  void aClosedThreadRunsNoMore() throws InterruptedException {
    CountDownLatch first = new CountDownLatch(1);
    SynchronizationThread thread =
        new SynchronizationThread(
            () -> {
              ticks.incrementAndGet();
              first.countDown();
            },
            failure::set);
    thread.start();
    assertTrue(first.await(PATIENCE_S, TimeUnit.SECONDS));
    thread.close();
    int ended = ticks.get();
    thread.close();
    TimeUnit.NANOSECONDS.sleep(2 * SynchronizationThread.PERIOD_NANOS);
    assertEquals(ended, ticks.get());
  }

  @Test
  void aTickMayCloseItsOwnThread() throws InterruptedException {
    CountDownLatch closed = new CountDownLatch(1);
    AtomicReference<SynchronizationThread> own = new AtomicReference<>();
    SynchronizationThread thread =
        new SynchronizationThread(
            () -> {
              own.get().close();
              ticks.incrementAndGet();
              closed.countDown();
            },
            failure::set);
    own.set(thread);
    thread.start();
    assertTrue(closed.await(PATIENCE_S, TimeUnit.SECONDS));
    thread.close();
    assertEquals(1, ticks.get());
  }

  @Test
  void aFailingStepIsReportedOnceAndTicksGoOn() throws InterruptedException {
    CountDownLatch three = new CountDownLatch(3);
    AtomicInteger reports = new AtomicInteger();
    try (SynchronizationThread thread =
        new SynchronizationThread(
            three::countDown,
            () -> {
              throw new IllegalStateException("step");
            },
            e -> reports.incrementAndGet())) {
      thread.start();
      assertTrue(three.await(PATIENCE_S, TimeUnit.SECONDS));
    }
    assertEquals(1, reports.get());
  }
}
