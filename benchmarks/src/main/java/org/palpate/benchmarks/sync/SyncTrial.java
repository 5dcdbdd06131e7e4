package org.palpate.benchmarks.sync;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;
import org.HdrHistogram.Histogram;
import org.palpate.device.SimulatedDevice;
import org.palpate.force.ForceSettings;
import org.palpate.frame.FramePublisher;
import org.palpate.frame.GridDevice;
import org.palpate.frame.PointFrame;
import org.palpate.geometry.Vec3;
import org.palpate.host.ContactScene;
import org.palpate.scene.SceneLoader;
import org.palpate.scene.SceneModel;
import org.palpate.scene.SceneSynchronizer;
import org.palpate.scene.StandardView;
import org.palpate.scene.SynchronizationThread;
import org.palpate.scene.Theme;
import org.palpate.scene.TouchMarks;
import org.palpate.scene.WorldAxes;
import org.palpate.scene.window.GraphicsException;
import org.palpate.scene.window.OffscreenRenderer;
import org.palpate.sync.Accumulator;
import org.palpate.sync.TouchProperties;
import org.palpate.volume.SegmentedVolume;

/** Runs a haptic loop at 1 kHz that changes a drawn scene by one method. */
final class SyncTrial implements AutoCloseable {
  private static final int WIDTH = 640;
  private static final int HEIGHT = 480;
  private static final long PERIOD_NANOS = 1_000_000;
  private static final long LONGEST_NANOS = 60_000_000_000L;
  private static final long PATIENCE_MS = 600_000;
  private static final long SEED = 1;

  private final ContactScene contact;
  private final SceneModel model = new SceneModel(WorldAxes.UNKNOWN, Theme.DARK);
  private final OffscreenRenderer picture;
  private long redraws;

  /** Opens a picture of the touched scene. */
  SyncTrial(ContactScene contact) throws GraphicsException, InterruptedException {
    this.contact = contact;
    SegmentedVolume volume = contact.volume();
    try (SceneLoader loader = new SceneLoader(model, volume, 1)) {
      loader.await(PATIENCE_MS);
    } catch (TimeoutException e) {
      throw new IllegalStateException("the surface was not extracted in time", e);
    }
    model.look(StandardView.OBLIQUE, (double) WIDTH / HEIGHT);
    picture = new OffscreenRenderer(WIDTH, HEIGHT, 1);
    picture.draw(model.state());
  }

  /** Runs one method for some seconds. */
  SyncRow run(SyncMethod method, int round, double seconds) {
    redraws = 0;
    TouchProperties properties = new TouchProperties(new Accumulator());
    PaperSync paper = new PaperSync();
    FramePublisher publisher =
        switch (method) {
          case NONE -> FramePublisher.NONE;
          case DIRECT -> this::changeAndDraw;
          case PAPER -> paper::publish;
          case WAIT_FREE -> properties::publish;
        };
    SceneSynchronizer sync = new SceneSynchronizer(properties, contact.grid(), model, List::of);
    Runnable tick =
        switch (method) {
          case NONE, DIRECT -> () -> {};
          case PAPER -> () -> paper.synchronize(this::change);
          case WAIT_FREE -> sync;
        };
    AtomicReference<RuntimeException> failure = new AtomicReference<>();
    try (DrawingThread drawing =
            new DrawingThread(method == SyncMethod.DIRECT ? () -> {} : this::draw);
        SynchronizationThread ticking = new SynchronizationThread(tick, failure::set)) {
      model.onChange(drawing::request);
      drawing.start();
      ticking.start();
      SyncRow row = loop(method, round, seconds, publisher);
      if (failure.get() != null) {
        throw new IllegalStateException("the scene was not updated", failure.get());
      }
      return row;
    }
  }

  private SyncRow loop(SyncMethod method, int round, double seconds, FramePublisher publisher) {
    SimulatedDevice hand = new SimulatedDevice(SEED, contact.handTarget(), PERIOD_NANOS);
    PointFrame frame =
        contact.newFrame(
            GridDevice.fromWorld(hand, contact.grid()),
            contact.liveFrame(hand.specification(), ForceSettings.DEFAULT_STIFFNESS_NEWTON_PER_MM),
            publisher);
    Histogram work = new Histogram(LONGEST_NANOS, 3);
    Histogram period = new Histogram(LONGEST_NANOS, 3);
    long began = System.nanoTime();
    long end = began + (long) (seconds * 1e9);
    long due = began;
    long last = began;
    while (last < end) {
      due = Math.max(due + PERIOD_NANOS, System.nanoTime() - PERIOD_NANOS);
      awaitUntil(due);
      long start = System.nanoTime();
      frame.run(start);
      work.recordValue(Math.min(System.nanoTime() - start, LONGEST_NANOS));
      period.recordValue(Math.min(start - last, LONGEST_NANOS));
      last = start;
    }
    return new SyncRow(method, round, work, period, redraws(), (last - began) / 1e9);
  }

  private static void awaitUntil(long due) {
    for (long left = due - System.nanoTime(); left > 0; left = due - System.nanoTime()) {
      LockSupport.parkNanos(left);
    }
  }

  private void changeAndDraw(
      Vec3 device, Vec3 point, Vec3 force, boolean touching, long frameNumber) {
    change(device, point, force, touching);
    draw();
  }

  private void change(Vec3 device, Vec3 point, Vec3 force, boolean touching) {
    Vec3 deviceMm = contact.grid().gridToWorld(device, new Vec3());
    Vec3 pointMm = contact.grid().gridToWorld(point, new Vec3());
    Vec3 forceNewton = contact.grid().gridMmToWorld().rotate(force, new Vec3());
    model.setMarks(
        Optional.of(new TouchMarks(deviceMm, pointMm, forceNewton, touching, List.of())));
  }

  private synchronized void draw() {
    picture.draw(model.state());
    redraws++;
  }

  private synchronized long redraws() {
    return redraws;
  }

  @Override
  public synchronized void close() {
    picture.close();
  }
}
