package org.palpate.imagej.session;

import ij.IJ;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;
import org.palpate.host.ContactScene;
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
 * A stack being touched, from "Touch Volume..." until Escape, "Stop Touching", the end of its time,
 * the device's end, or the image or the 3-D window closes.
 *
 * <p>{@link #run} is the session's own thread's; other commands ask {@link #touchedPointGrid}, add
 * landmarks and brush strokes meanwhile, from their own threads.
 */
public final class StackSession implements AutoCloseable {
  private static final double RATE_HZ = 1000;
  private static final long TICK_NANOS = 33_333_333;
  private static final long STATUS_NANOS = 500_000_000;
  private static final long FORCE_PATIENCE_SECONDS = 60;
  private static final double NANOS_PER_SECOND = 1e9;

  private final StackGeometry geometry;
  private final List<SegmentRange> rules;
  private final List<Segment> segments;
  private final double seconds;
  private final RealtimeThread realtime = StackRealtime.thread();
  private final LandmarkButton button;
  private final TouchSession session;
  private final StackSynchronizer watcher;
  private final Optional<SessionView> view;
  private final LandmarkTable landmarks;
  private final StrokeHistory strokes;
  private final Queue<ViewKeys.Action> asked = new ConcurrentLinkedQueue<>();
  private final CountDownLatch forceOn = new CountDownLatch(1);
  private final CountDownLatch forceOff = new CountDownLatch(1);
  private final Vec3 taken = new Vec3();
  private volatile Vec3 tip = new Vec3(Double.NaN, Double.NaN, Double.NaN);
  private volatile boolean stopAsked;
  private volatile Thread runner;

  /**
   * Makes segments, opens the device and gets ready.
   *
   * @throws TouchRefusedException where the stack, the device or the choice does not allow it
   */
  StackSession(StackVolume volume, TouchOptions options, Optional<SampleRecorder> recorder)
      throws TouchRefusedException {
    geometry = StackGeometry.of(volume.image());
    rules = options.rules(volume);
    seconds = options.seconds();
    IJ.showStatus("Palpate: making segments...");
    PixelSnapshot pixels = new PixelSnapshot(volume);
    segments =
        StackSegments.of(
            volume, pixels::slice, rules, k -> IJ.showProgress(k + 1, volume.slices()));
    refuseEmpty(options);
    options.materials().checkNamed(segments);
    ContactScene scene =
        new ContactScene(
            new SegmentedVolume(geometry.grid(), segments),
            options.contactSettings(),
            StackGreyValues.surface(pixels, volume.slices(), geometry.grid(), rules));
    LoopSettings loop = LoopSettings.ofRate(RATE_HZ).with(realtime, realtime);
    StackDevice device =
        StackDevice.open(
            options.device(), scene.handTarget(), options.workspace(), loop.periodNanos());
    button = new LandmarkButton(device.device());
    session =
        new TouchSession(scene, button, device.defaultNewtonPerMm(), loop, recorder, end -> {});
    watcher =
        new StackSynchronizer(volume, pixels, rules, options.followsThreshold(), scene, changes());
    strokes = new StrokeHistory(volume, geometry.grid().spacingMm());
    view =
        options.view() && GraphicsDriver.hasDisplay()
            ? Optional.of(newView(device))
            : Optional.empty();
    landmarks =
        new LandmarkTable(
            volume.image(), geometry, all -> view.ifPresent(shown -> shown.showLandmarks(all)));
  }

  private SessionView newView(StackDevice device) {
    List<Segment> drawn = new ArrayList<>();
    List<BitCube> bits = watcher.mirrors();
    for (int n = 0; n < bits.size(); n++) {
      drawn.add(new Segment(segments.get(n).name(), bits.get(n), segments.get(n).rgb()));
    }
    return new SessionView(
        session,
        new SegmentedVolume(geometry.grid(), drawn),
        WorldAxes.UNKNOWN,
        device.device(),
        new ViewKeys(this, asked::add));
  }

  private void refuseEmpty(TouchOptions options) throws TouchRefusedException {
    long solids = segments.stream().mapToLong(segment -> segment.bits().solidCount()).sum();
    if (solids == 0) {
      throw new TouchRefusedException(
          "No voxel has a value from "
              + options.lower()
              + " to "
              + options.upper()
              + ": choose other thresholds.");
    }
  }

  /**
   * Runs to the end, zero force sent last. The session's own thread.
   *
   * @throws TouchRefusedException where the stack got another size or type meanwhile; stopped then
   */
  LoopEnd run() throws TouchRefusedException {
    IJ.resetEscape();
    session.start();
    view.ifPresent(SessionView::start);
    try {
      watch();
    } finally {
      forceOn.countDown();
      session.stop();
      forceOff.countDown();
    }
    return session.stop();
  }

  private void watch() throws TouchRefusedException {
    runner = Thread.currentThread();
    long beganNanos = 0;
    long statusNanos = System.nanoTime();
    while (!session.supervise() && !isOver(beganNanos)) {
      if (beganNanos == 0 && session.status().frames() > 0) {
        beganNanos = System.nanoTime();
      }
      if (beganNanos != 0) {
        takeTip();
      }
      for (int n = button.pollPresses(); n > 0; n--) {
        asked.add(this::addLandmarkHere);
      }
      runQueuedActions();
      watcher.applyChanges();
      if (System.nanoTime() - statusNanos >= STATUS_NANOS) {
        statusNanos = System.nanoTime();
        showStatus();
      }
      LockSupport.parkNanos(this, TICK_NANOS);
    }
  }

  /** The stack was updated: no need to wait for the tick. Any thread. */
  private void wake() {
    LockSupport.unpark(runner);
  }

  private boolean isOver(long beganNanos) {
    boolean late =
        seconds > 0
            && beganNanos != 0
            && System.nanoTime() - beganNanos >= seconds * NANOS_PER_SECOND;
    return late || stopAsked || watcher.isClosed() || IJ.escapePressed();
  }

  private void takeTip() {
    Vec3 now = view.map(SessionView::proxyGrid).orElseGet(this::takeUnseen);
    if (now.isFinite()) {
      tip = now;
      forceOn.countDown();
    }
  }

  private Vec3 takeUnseen() {
    session.takeUnseen();
    return new Vec3().set(session.properties().touch().interactionPoint(taken));
  }

  private void runQueuedActions() {
    for (ViewKeys.Action action = asked.poll(); action != null; action = asked.poll()) {
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
      public void changed(IntBox voxels, int segment) {
        view.ifPresent(shown -> shown.edited(segment, voxels));
      }
    };
  }

  private void showStatus() {
    LoopStatus status = session.status();
    Vec3 at = geometry.gridToCalibrated(tip, new Vec3());
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

  /** Waits until force is on or the session has ended. */
  void awaitForce() {
    try {
      if (!forceOn.await(FORCE_PATIENCE_SECONDS, TimeUnit.SECONDS)) {
        askToStop();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      askToStop();
    }
  }

  /** Puts the next landmark where the point is. */
  void addLandmarkHere() throws TouchRefusedException {
    landmarks.add(landmarks.nextName(), touchedPointGrid());
  }

  /** Waits until zero force was sent for good; whether it was. Any thread. */
  boolean awaitZeroForce(long millis) {
    try {
      return forceOff.await(millis, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }

  /** Asks the session to end. Any thread. */
  void askToStop() {
    stopAsked = true;
    wake();
  }

  /**
   * Where the interaction point is, grid coordinates. Any thread.
   *
   * @throws TouchRefusedException before the first frame
   */
  public Vec3 touchedPointGrid() throws TouchRefusedException {
    Vec3 now = tip;
    if (!now.isFinite()) {
      throw new TouchRefusedException("The first frame has not run yet: touch the volume first.");
    }
    return new Vec3().set(now);
  }

  /** The landmarks so far. */
  public LandmarkTable landmarks() {
    return landmarks;
  }

  /** Paints at the interaction point, into the first segment; the voxels that changed. */
  public int paint(double radiusMm, boolean add) throws TouchRefusedException {
    int changed = strokes.paint(touchedPointGrid(), radiusMm, rules.get(0), add);
    watcher.markUpdated();
    return changed;
  }

  /** Undoes the last stroke; the voxels that changed. */
  public int undo() throws TouchRefusedException {
    int changed = strokes.undo();
    watcher.markUpdated();
    return changed;
  }

  /** Does the last undone stroke again; the voxels that changed. */
  public int redo() throws TouchRefusedException {
    int changed = strokes.redo();
    watcher.markUpdated();
    return changed;
  }

  /** The segments as they were made: names and, at the beginning, voxels. */
  public List<Segment> segments() {
    return segments;
  }

  /** The voxels of a segment by now. Any thread; of the last tick. */
  public long voxels(int segment) {
    return watcher.solids(segment);
  }

  public LoopStatus status() {
    return session.status();
  }

  public Optional<SessionView> view() {
    return view;
  }

  @Override
  public void close() {
    watcher.close();
    view.ifPresent(SessionView::close);
    session.close();
    forceOff.countDown();
    realtime.close();
  }
}
