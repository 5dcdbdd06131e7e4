package org.palpate.imagej;

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
import org.palpate.interaction.FrameRecorder;
import org.palpate.interaction.LoopEnd;
import org.palpate.interaction.LoopSettings;
import org.palpate.interaction.LoopStatus;
import org.palpate.realtime.RealtimeThread;
import org.palpate.scene.WorldAxes;
import org.palpate.scene.window.Graphics;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;

/**
 * A stack being touched, from "Touch Volume..." until Escape, "Stop Touching", the end of its time,
 * the device's end, or the image or the 3-D window closes.
 *
 * <p>{@link #run} is the session's own thread's; other commands ask {@link #touchedGrid}, add
 * landmarks and brush strokes meanwhile, from their own threads.
 */
final class StackSession implements AutoCloseable {
  private static final double RATE_HZ = 1000;
  private static final long TICK_NANOS = 33_333_333;
  private static final long STATUS_NANOS = 500_000_000;
  private static final long FORCE_PATIENCE_SECONDS = 60;
  private static final double NANOS_PER_SECOND = 1e9;

  private final StackGeometry geometry;
  private final List<VoxelRule> rules;
  private final List<Segment> segments;
  private final double seconds;
  private final RealtimeThread realtime = StackRealtime.thread();
  private final LandmarkButton button;
  private final TouchSession session;
  private final StackWatcher watcher;
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
   * @throws StackRefused where the stack, the device or the choice does not allow it
   */
  StackSession(StackVolume volume, TouchOptions options, Optional<FrameRecorder> recorder)
      throws StackRefused {
    geometry = StackGeometry.of(volume.image());
    rules = options.rules(volume);
    seconds = options.seconds();
    IJ.showStatus("Palpate: making segments...");
    StackPixels pixels = new StackPixels(volume);
    segments =
        StackSegments.of(
            volume, pixels::slice, rules, k -> IJ.showProgress(k + 1, volume.slices()));
    refuseEmpty(options);
    options.materials().checkNamed(segments);
    ContactScene scene =
        new ContactScene(
            new SegmentedVolume(geometry.grid(), segments),
            options.contactSettings(),
            StackGrey.surface(pixels, volume.slices(), geometry.grid(), rules));
    LoopSettings loop = LoopSettings.ofRate(RATE_HZ).with(realtime, realtime);
    StackDevice device =
        StackDevice.open(
            options.device(), scene.handTarget(), options.workspace(), loop.periodNanos());
    button = new LandmarkButton(device.device());
    session =
        new TouchSession(scene, button, device.defaultNewtonPerMm(), loop, recorder, end -> {});
    watcher = new StackWatcher(volume, pixels, rules, options.followsThreshold(), scene, changes());
    strokes = new StrokeHistory(volume, geometry.grid().spacingMm());
    view =
        options.view() && Graphics.hasDisplay() ? Optional.of(newView(device)) : Optional.empty();
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

  private void refuseEmpty(TouchOptions options) throws StackRefused {
    long solids = segments.stream().mapToLong(segment -> segment.bits().solidCount()).sum();
    if (solids == 0) {
      throw new StackRefused(
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
   * @throws StackRefused where the stack got another size or type meanwhile; stopped then
   */
  LoopEnd run() throws StackRefused {
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

  private void watch() throws StackRefused {
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
      for (int n = button.takePresses(); n > 0; n--) {
        asked.add(this::markHere);
      }
      carryOutWhatWasAsked();
      watcher.carryOverWhenUpdated();
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
    Vec3 now = view.map(SessionView::tipGrid).orElseGet(this::takeUnseen);
    if (now.isFinite()) {
      tip = now;
      forceOn.countDown();
    }
  }

  private Vec3 takeUnseen() {
    session.takeUnseen();
    return new Vec3().set(session.properties().touch().interactionPoint(taken));
  }

  private void carryOutWhatWasAsked() {
    for (ViewKeys.Action action = asked.poll(); action != null; action = asked.poll()) {
      try {
        action.run();
      } catch (StackRefused e) {
        IJ.showStatus("Palpate: " + e.getMessage());
      }
    }
  }

  private StackWatcher.Listener changes() {
    return new StackWatcher.Listener() {
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
  void markHere() throws StackRefused {
    landmarks.add(landmarks.nextName(), touchedGrid());
  }

  /** Waits until zero force was sent for good; whether it was. Any thread. */
  boolean awaitForceOff(long millis) {
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
   * @throws StackRefused before the first frame
   */
  Vec3 touchedGrid() throws StackRefused {
    Vec3 now = tip;
    if (!now.isFinite()) {
      throw new StackRefused("The first frame has not run yet: touch the volume first.");
    }
    return new Vec3().set(now);
  }

  /** The landmarks so far. */
  LandmarkTable landmarks() {
    return landmarks;
  }

  /** Paints at the interaction point, into the first segment; the voxels that changed. */
  int paint(double radiusMm, boolean add) throws StackRefused {
    int changed = strokes.paint(touchedGrid(), radiusMm, rules.get(0), add);
    watcher.noteUpdate();
    return changed;
  }

  /** Undoes the last stroke; the voxels that changed. */
  int undo() throws StackRefused {
    int changed = strokes.undo();
    watcher.noteUpdate();
    return changed;
  }

  /** Does the last undone stroke again; the voxels that changed. */
  int redo() throws StackRefused {
    int changed = strokes.redo();
    watcher.noteUpdate();
    return changed;
  }

  /** The segments as they were made: names and, at the beginning, voxels. */
  List<Segment> segments() {
    return segments;
  }

  /** The voxels of a segment by now. Any thread; of the last tick. */
  long voxels(int segment) {
    return watcher.solids(segment);
  }

  LoopStatus status() {
    return session.status();
  }

  Optional<SessionView> view() {
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
