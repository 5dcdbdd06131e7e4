package org.palpate.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.host.placing.BodyAnchor;

class SessionWorkerTest {
  private static final long PATIENCE_MS = 60_000;

  @Test
  void theCommandReturnsWhileTheSessionRuns() throws InterruptedException {
    CountDownLatch goOn = new CountDownLatch(1);
    AtomicReference<String> name = new AtomicReference<>();
    AtomicInteger stops = new AtomicInteger();
    SessionWorker worker =
        new SessionWorker(
            () -> {
              name.set(Thread.currentThread().getName());
              awaitQuietly(goOn);
            },
            stops::incrementAndGet);
    worker.start();
    assertFalse(worker.await(20));
    goOn.countDown();
    assertTrue(worker.await(PATIENCE_MS));
    assertEquals("palpate-session", name.get());
    assertEquals(0, stops.get(), "only the end of the process asks it to stop");
    assertFalse(SessionWorker.isProcessEnding());
  }

  private static void awaitQuietly(CountDownLatch latch) {
    try {
      latch.await();
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }

  @Test
  void aSessionThatThrowsHasEndedToo() throws InterruptedException {
    AtomicReference<Throwable> uncaught = new AtomicReference<>();
    CountDownLatch reported = new CountDownLatch(1);
    SessionWorker worker =
        new SessionWorker(
            () -> {
              Thread.currentThread()
                  .setUncaughtExceptionHandler(
                      (thread, e) -> {
                        uncaught.set(e);
                        reported.countDown();
                      });
              throw new IllegalStateException("session");
            },
            () -> {});
    worker.start();
    assertTrue(worker.await(PATIENCE_MS));
    reported.await();
    assertEquals("session", uncaught.get().getMessage());
  }

  @Test
  void aWaitThatIsInterruptedSaysSo() {
    SessionWorker worker = new SessionWorker(() -> {}, () -> {});
    Thread.currentThread().interrupt();
    assertFalse(worker.await(PATIENCE_MS));
    assertTrue(Thread.interrupted(), "the flag is kept");
  }

  @Test
  void anAnchorMovesWithItsBody() {
    RigidTransform moved = RigidTransform.identity();
    moved.origin().set(10, 0, 0);
    RigidTransform turned =
        new RigidTransform(
            new Vec3(0, 1, 0), new Vec3(-1, 0, 0), new Vec3(0, 0, 1), new Vec3(0, 0, 5));
    List<RigidTransform> before = List.of(RigidTransform.identity(), moved);
    BodyAnchor anchor = BodyAnchor.at(new Vec3(12, 3, 4), 1, before);
    assertEquals("(2.0, 3.0, 4.0)", anchor.restMm().toString());
    assertEquals("(12.0, 3.0, 4.0)", anchor.present(before).toString());
    assertEquals("(-3.0, 2.0, 9.0)", anchor.present(List.of(moved, turned)).toString());
    for (int none : new int[] {-1, 2}) {
      BodyAnchor still = BodyAnchor.at(new Vec3(1, 2, 3), none, before);
      assertEquals(-1, still.body());
      assertEquals("(1.0, 2.0, 3.0)", still.present(List.of(moved, turned)).toString());
    }
  }
}
