package org.palpate.scene.window;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class DrawThreadTest {
  private static final long PATIENCE_S = 60;

  @Test
  void requestsDuringAPictureCauseOneMorePicture() throws Exception {
    CountDownLatch drawing = new CountDownLatch(1);
    CountDownLatch goOn = new CountDownLatch(1);
    CountDownLatch twice = new CountDownLatch(2);
    Runnable draw =
        () -> {
          drawing.countDown();
          await(goOn);
          twice.countDown();
        };
    try (DrawThread thread = new DrawThread(draw, e -> {})) {
      thread.start();
      thread.request();
      await(drawing);
      for (int i = 0; i < 100; i++) {
        thread.request();
      }
      goOn.countDown();
      await(twice);
    }
  }

  @Test
  void closingDoesNotWaitForAHangingPicture() {
    CountDownLatch never = new CountDownLatch(1);
    CountDownLatch drawing = new CountDownLatch(1);
    DrawThread thread =
        new DrawThread(
            () -> {
              drawing.countDown();
              await(never);
            },
            e -> {});
    thread.start();
    thread.request();
    await(drawing);
    thread.close();
    never.countDown();
  }

  private static void await(CountDownLatch latch) {
    try {
      assertTrue(latch.await(PATIENCE_S, TimeUnit.SECONDS));
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }
}
