package org.palpate.benchmarks.jitter.experiment;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.locks.LockSupport;
import org.palpate.scene.SceneLoader;
import org.palpate.scene.SceneModel;
import org.palpate.scene.StandardView;
import org.palpate.scene.Theme;
import org.palpate.scene.WorldAxes;
import org.palpate.scene.window.GraphicsException;
import org.palpate.scene.window.OffscreenRenderer;
import org.palpate.volume.SegmentedVolume;

/**
 * The haptic frame with a view that another thread draws 30 times a second. The view is drawn off
 * screen and completely each time, which is more work than an idle window does.
 */
final class ViewedExperimentFrame implements ExperimentFrame {
  private static final int WIDTH = 640;
  private static final int HEIGHT = 480;
  private static final long PATIENCE_MILLIS = 60_000;
  private static final long TICK_NANOS = 33_333_333;

  private final HapticExperimentFrame frame;
  private final SceneModel model = new SceneModel(WorldAxes.UNKNOWN, Theme.LIGHT);
  private final CountDownLatch drawn = new CountDownLatch(1);
  private final Thread viewThread = new Thread(this::draw, "view");
  private volatile boolean closed;
  private volatile Exception failure;

  /**
   * Makes the surfaces and starts to draw.
   *
   * @param periodNanos the time between two samples of the hand
   * @throws IllegalStateException if this machine cannot draw
   */
  ViewedExperimentFrame(SegmentedVolume volume, long periodNanos) {
    frame = new HapticExperimentFrame(volume, periodNanos);
    try (SceneLoader loader = new SceneLoader(model, volume, 1)) {
      loader.await(PATIENCE_MILLIS);
      model.look(StandardView.FRONT, (double) WIDTH / HEIGHT);
      viewThread.setDaemon(true);
      viewThread.start();
      drawn.await(PATIENCE_MILLIS, TimeUnit.MILLISECONDS);
    } catch (InterruptedException | TimeoutException e) {
      throw new IllegalStateException("the surfaces were not made", e);
    }
    if (failure != null) {
      throw new IllegalStateException("this machine cannot draw the view", failure);
    }
  }

  private void draw() {
    try (OffscreenRenderer scene = new OffscreenRenderer(WIDTH, HEIGHT, 1)) {
      long due = System.nanoTime();
      while (!closed) {
        scene.draw(model.state());
        drawn.countDown();
        due += TICK_NANOS;
        LockSupport.parkNanos(due - System.nanoTime());
      }
    } catch (GraphicsException e) {
      failure = e;
      drawn.countDown();
    }
  }

  @Override
  public void run() {
    frame.run();
  }

  /** Stops drawing before the JVM closes the display. */
  @Override
  public void close() {
    closed = true;
    try {
      viewThread.join(PATIENCE_MILLIS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
