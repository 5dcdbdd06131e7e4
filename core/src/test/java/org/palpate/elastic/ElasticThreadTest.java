package org.palpate.elastic;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class ElasticThreadTest {
  private final AtomicLong now = new AtomicLong();

  @Test
  void updatesUntilItIsClosed() throws InterruptedException {
    CountDownLatch three = new CountDownLatch(3);
    ElasticThread thread = new ElasticThread(three::countDown, now::get);
    thread.start();
    three.await();
    assertEquals(Optional.empty(), thread.trouble());
    thread.close();
    thread.close();
    assertEquals(Optional.empty(), thread.trouble());
  }

  @Test
  void saysWhyAnUpdateFailed() throws InterruptedException {
    CountDownLatch begun = new CountDownLatch(1);
    ElasticThread thread =
        new ElasticThread(
            () -> {
              begun.countDown();
              throw new IllegalStateException("no memory");
            },
            now::get);
    thread.start();
    begun.await();
    thread.close();
    assertTrue(thread.trouble().orElseThrow().contains("no memory"));
  }

  @Test
  void saysThatAnUpdateDoesNotReturn() throws InterruptedException {
    CountDownLatch begun = new CountDownLatch(1);
    CountDownLatch end = new CountDownLatch(1);
    ElasticThread thread =
        new ElasticThread(
            () -> {
              begun.countDown();
              try {
                end.await();
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
              }
            },
            now::get);
    thread.start();
    begun.await();
    assertEquals(Optional.empty(), thread.trouble());
    now.addAndGet(ElasticThread.STALL_NANOS + 1);
    assertTrue(thread.trouble().orElseThrow().contains("has not returned"));
    end.countDown();
    thread.close();
    assertEquals(Optional.empty(), thread.trouble(), "it came back");
  }

  /** The haptic thread keeps the last proved field if no other comes. */
  @Test
  void framesGoOnWithoutUpdates() {
    ElasticTouch touch =
        new ElasticTouch(
            ElasticTouch.Scene.block(new org.palpate.geometry.GridMetric(1, 1, 1)),
            20e3,
            0.5,
            8,
            true);
    touch.hand.set(48.3, 48.4, 52);
    touch.moveTo(48.3, 48.4, 45, 300);
    for (int n = 0; n < 500; n++) {
      touch.hand.x += 0.01;
      touch.runWithoutUpdate();
    }
    assertEquals(0, TetrahedraJudge.folded(touch.lattice, touch.body.contact().map()));
    assertTrue(touch.frame.forceNewton().z > 0.3, "force " + touch.frame.forceNewton());
  }
}
