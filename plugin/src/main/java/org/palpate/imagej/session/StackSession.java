package org.palpate.imagej.session;

import ij.Executer;
import ij.IJ;
import ij.ImagePlus;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.palpate.elastic.PublishedShape;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;
import org.palpate.host.ContactScene;
import org.palpate.host.SessionSettings;
import org.palpate.host.SessionView;
import org.palpate.host.TouchSession;
import org.palpate.imagej.annotation.LandmarkButton;
import org.palpate.imagej.annotation.LandmarkTable;
import org.palpate.imagej.annotation.StrokeHistory;
import org.palpate.imagej.dialog.TouchOptions;
import org.palpate.imagej.stack.PixelSnapshot;
import org.palpate.imagej.stack.SegmentRange;
import org.palpate.imagej.stack.StackGeometry;
import org.palpate.imagej.stack.StackGreyValues;
import org.palpate.imagej.stack.StackSegments;
import org.palpate.imagej.stack.StackSynchronizer;
import org.palpate.imagej.stack.StackVolume;
import org.palpate.imagej.stack.TouchRefusedException;
import org.palpate.loop.LoopEnd;
import org.palpate.loop.LoopSettings;
import org.palpate.loop.LoopStatus;
import org.palpate.realtime.RealtimeThread;
import org.palpate.recording.SampleRecorder;
import org.palpate.scene.WorldAxes;
import org.palpate.scene.window.GraphicsDriver;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;

/**
 * A stack that is being touched, until the user presses Escape or calls "Stop Touching", the time
 * or the device ends, or the image or the 3-D window closes.
 *
 * <p>The session's own thread calls {@link #run}. Other threads may meanwhile call {@link
 * #touchedPointGrid}, and add landmarks and brush strokes.
 */
public final class StackSession implements AutoCloseable {
  private static final double RATE_HZ = 1000;
  private static final long STATUS_NANOS = 500_000_000;
  private static final long FORCE_WAIT_SECONDS = 60;
  private static final long UNDO_WAIT_SECONDS = 1;
  private static final double NANOS_PER_SECOND = 1e9;

  private final ImagePlus image;
  private final StackGeometry geometry;
  private final List<SegmentRange> ranges;
  private final List<Segment> segments;
  private final double seconds;
  private final RealtimeThread realtime = StackRealtime.thread();
  private final LandmarkButton button;
  private final TouchSession session;
  private final StackSynchronizer synchronizer;
  private final Optional<SessionView> view;

  /** The shape of elastic segments, if there are any and no view reads it. */
  private final Optional<PublishedShape> shape;

  private final LandmarkTable landmarks;
  private final StrokeHistory strokes;
  private final Queue<ViewKeys.Action> actions = new ConcurrentLinkedQueue<>();
  private final CountDownLatch forceOn = new CountDownLatch(1);
  private final CountDownLatch forceOff = new CountDownLatch(1);
  private volatile Vec3 pointGrid = new Vec3(Double.NaN, Double.NaN, Double.NaN);
  private volatile boolean stopRequested;
  private volatile Thread runner;

  /**
   * Builds the segments, opens the device and prepares the session.
   *
   * @param recorder records what the device sends, if given
   * @throws TouchRefusedException if the stack, the device or an option does not allow a session
   */
  StackSession(StackVolume volume, TouchOptions options, Optional<SampleRecorder> recorder)
      throws TouchRefusedException {
    image = volume.image();
    geometry = StackGeometry.of(image);
    ranges = options.ranges(volume);
    seconds = options.seconds();
    IJ.showStatus("Palpate: making segments...");
    PixelSnapshot pixels = new PixelSnapshot(volume);
    segments =
        StackSegments.of(
            volume, pixels::slice, ranges, k -> IJ.showProgress(k + 1, volume.slices()));
    requireVoxels(options);
    options.materials().checkNamed(segments);
    ContactScene scene =
        new ContactScene(
            new SegmentedVolume(geometry.grid(), segments),
            options.contactSettings(),
            StackGreyValues.surface(pixels, volume.slices(), geometry.grid(), ranges));
    LoopSettings loop = LoopSettings.ofRate(RATE_HZ).with(realtime, realtime);
    StackDevice device =
        StackDevice.open(options.device(), scene, options.workspace(), loop.periodNanos());
    button = new LandmarkButton(device.device());
    session =
        new TouchSession(
            scene,
            button,
            SessionSettings.standard()
                .withDefaultStiffness(device.defaultNewtonPerMm())
                .withLoop(loop)
                .withElastic(options.materials().bodies(scene.volume()))
                .withRecorder(recorder));
    synchronizer =
        new StackSynchronizer(volume, pixels, ranges, options.followsThreshold(), scene, changes());
    strokes = new StrokeHistory(volume, geometry.grid().spacingMm());
    view =
        options.view() && GraphicsDriver.hasDisplay()
            ? Optional.of(newView(device))
            : Optional.empty();
    shape = view.isPresent() ? Optional.empty() : session.shape();
    landmarks =
        new LandmarkTable(
            image, geometry, all -> view.ifPresent(shown -> shown.showLandmarks(all)));
  }

  private SessionView newView(StackDevice device) {
    List<Segment> drawn = new ArrayList<>();
    List<BitCube> bits = synchronizer.mirrors();
    for (int n = 0; n < bits.size(); n++) {
      drawn.add(new Segment(segments.get(n).name(), bits.get(n), segments.get(n).rgb()));
    }
    return new SessionView(
        session,
        new SegmentedVolume(geometry.grid(), drawn),
        WorldAxes.UNKNOWN,
        device.device(),
        new ViewKeys(this, actions::add));
  }

  private void requireVoxels(TouchOptions options) throws TouchRefusedException {
    long voxels = segments.stream().mapToLong(segment -> segment.bits().solidCount()).sum();
    if (voxels == 0) {
      throw new TouchRefusedException(
          "No voxel has a value from "
              + options.lower()
              + " to "
              + options.upper()
              + ": choose other thresholds.");
    }
  }

  /**
   * Runs the session until it ends and zero force was sent. On the session's own thread.
   *
   * @throws TouchRefusedException if the size or type of the stack changed; the session has ended
   *     then
   */
  LoopEnd run() throws TouchRefusedException {
    IJ.resetEscape();
    session.start();
    view.ifPresent(SessionView::start);
    StrokeUndo undo = new StrokeUndo(image, this::undoIfLast);
    Executer.addCommandListener(undo);
    try {
      superviseUntilEnd();
    } finally {
      Executer.removeCommandListener(undo);
      forceOn.countDown();
      session.stop();
      forceOff.countDown();
    }
    if (session.endedByTrouble()) {
      throw new TouchRefusedException(
          "The session ended with zero force: " + session.elasticTrouble().orElseThrow() + ".");
    }
    return session.stop();
  }

  private void superviseUntilEnd() throws TouchRefusedException {
    runner = Thread.currentThread();
    long startNanos = 0;
    long statusNanos = System.nanoTime();
    while (!session.supervise() && !isOver(startNanos)) {
      if (startNanos == 0 && session.status().frames() > 0) {
        startNanos = System.nanoTime();
      }
      if (startNanos != 0) {
        updatePoint();
      }
      for (int n = button.pollPresses(); n > 0; n--) {
        actions.add(this::addLandmarkHere);
      }
      runQueuedActions();
      synchronizer.applyChanges();
      if (System.nanoTime() - statusNanos >= STATUS_NANOS) {
        statusNanos = System.nanoTime();
        showStatus();
      }
      LockSupport.parkNanos(this, TouchSession.SUPERVISION_PERIOD_NANOS);
    }
  }

  /** Wakes the session's thread before its next tick, because the stack was updated. Any thread. */
  private void wake() {
    LockSupport.unpark(runner);
  }

  private boolean isOver(long startNanos) {
    boolean timeIsOver =
        seconds > 0
            && startNanos != 0
            && System.nanoTime() - startNanos >= seconds * NANOS_PER_SECOND;
    return timeIsOver || stopRequested || synchronizer.isClosed() || IJ.escapePressed();
  }

  private void updatePoint() {
    Vec3 now = view.map(SessionView::proxyGrid).orElseGet(this::takeUpdates);
    if (now.isFinite()) {
      pointGrid = now;
      forceOn.countDown();
    }
  }

  private Vec3 takeUpdates() {
    session.takeUpdates();
    Vec3 atRest = new Vec3();
    return shape.isPresent()
        ? shape.get().materialPoint(atRest)
        : session.properties().touch().interactionPoint(atRest);
  }

  private void runQueuedActions() {
    for (ViewKeys.Action action = actions.poll(); action != null; action = actions.poll()) {
      try {
        action.run();
      } catch (TouchRefusedException e) {
        IJ.showStatus("Palpate: " + e.getMessage());
      }
    }
  }

  private StackSynchronizer.Listener changes() {
    return new StackSynchronizer.Listener() {
      @Override
      public void updated() {
        wake();
      }

      @Override
      public void seen(int i, int j, int k, float value) {
        strokes.seen(i, j, k, value);
      }

      @Override
      public void changed(IntBox voxels, int segment) {
        view.ifPresent(shown -> shown.remesh(segment, voxels));
      }
    };
  }

  private void showStatus() {
    LoopStatus status = session.status();
    Vec3 at = geometry.gridToCalibrated(pointGrid, new Vec3());
    IJ.showStatus(
        String.format(
            Locale.ROOT,
            "Palpate: (%.2f, %.2f, %.2f) %s, %s, %.2f N; Escape ends",
            at.x,
            at.y,
            at.z,
            geometry.unit(),
            status.contact() ? "contact" : "free",
            status.forceNewton()));
  }

  /** Waits until the force is on or the session has ended. */
  void awaitForce() {
    try {
      if (!forceOn.await(FORCE_WAIT_SECONDS, TimeUnit.SECONDS)) {
        requestStop();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      requestStop();
    }
  }

  /** Adds the next landmark at the interaction point. */
  void addLandmarkHere() throws TouchRefusedException {
    landmarks.add(landmarks.nextName(), touchedPointGrid());
  }

  /** Waits until zero force was sent for good; returns whether it was. Any thread. */
  boolean awaitZeroForce(long millis) {
    try {
      return forceOff.await(millis, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }

  /** Requests the end of the session. Any thread. */
  void requestStop() {
    stopRequested = true;
    wake();
  }

  /**
   * Returns the interaction point in grid coordinates. Any thread.
   *
   * @throws TouchRefusedException before the first frame
   */
  public Vec3 touchedPointGrid() throws TouchRefusedException {
    Vec3 now = pointGrid;
    if (!now.isFinite()) {
      throw new TouchRefusedException("The first frame has not run yet: try again in a moment.");
    }
    return new Vec3().set(now);
  }

  /** Returns the landmarks. */
  public LandmarkTable landmarks() {
    return landmarks;
  }

  /**
   * Paints a ball at the interaction point into the first segment.
   *
   * @return the number of changed voxels
   */
  public int paint(double radiusMm, boolean add) throws TouchRefusedException {
    int changed = strokes.paint(touchedPointGrid(), radiusMm, ranges.get(0), add);
    synchronizer.markUpdated();
    return changed;
  }

  /**
   * Undoes the last brush stroke.
   *
   * @return the number of changed voxels
   */
  public int undo() throws TouchRefusedException {
    int changed = strokes.undo();
    synchronizer.markUpdated();
    return changed;
  }

  /**
   * Undoes the last brush stroke, unless something else has changed the stack since. The thread of
   * the session does it. Any other thread; waits at most a second.
   *
   * @return whether a stroke was undone
   */
  boolean undoIfLast() {
    CompletableFuture<Boolean> undone = new CompletableFuture<>();
    actions.add(
        () -> {
          try {
            synchronizer.applyChanges(); // sees what was changed up to now
            boolean isLast = strokes.isStrokeLast();
            if (isLast) {
              undo();
            }
            undone.complete(isLast);
          } finally {
            undone.complete(false); // after a refusal; else it does nothing
          }
        });
    wake();
    return undone.completeOnTimeout(false, UNDO_WAIT_SECONDS, TimeUnit.SECONDS).join();
  }

  /**
   * Redoes the last undone brush stroke.
   *
   * @return the number of changed voxels
   */
  public int redo() throws TouchRefusedException {
    int changed = strokes.redo();
    synchronizer.markUpdated();
    return changed;
  }

  /** Returns the segments as they were built, with their voxels at the start. */
  public List<Segment> segments() {
    return segments;
  }

  /** Returns the number of voxels of a segment at the last tick. Any thread. */
  public long voxels(int segment) {
    return synchronizer.solidCount(segment);
  }

  /** Returns the present state of the haptic loop. Any thread. */
  public LoopStatus status() {
    return session.status();
  }

  /** Returns the 3-D view, if there is one. */
  public Optional<SessionView> view() {
    return view;
  }

  @Override
  public void close() {
    synchronizer.close();
    view.ifPresent(SessionView::close);
    session.close();
    forceOff.countDown();
    realtime.close();
  }
}
