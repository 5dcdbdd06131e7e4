package org.palpate.host;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.palpate.device.HapticDevice;
import org.palpate.device.WorkspaceDevice;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;
import org.palpate.loop.LoopStatus;
import org.palpate.scene.MovableSlices;
import org.palpate.scene.NamedPoint;
import org.palpate.scene.SceneLoader;
import org.palpate.scene.SceneModel;
import org.palpate.scene.SceneSynchronizer;
import org.palpate.scene.StandardView;
import org.palpate.scene.SynchronizationThread;
import org.palpate.scene.Theme;
import org.palpate.scene.WorldAxes;
import org.palpate.scene.window.GraphicsException;
import org.palpate.scene.window.SceneWindow;
import org.palpate.scene.window.WindowInput;
import org.palpate.volume.SegmentedVolume;

/**
 * The window of a live session and the thread that keeps it up to date. It opens on a thread of its
 * own, so that force does not wait for it; whatever befalls it, the session goes on.
 */
public final class SessionView implements AutoCloseable {
  /** Whom a view tells. */
  public interface Listener {
    /** A line for the person. Any thread. */
    void tell(String line);

    /** The session is to end: Escape, or the window was closed. Any thread. */
    void stop();

    /** A window is about to be shown: the time to give keys something to do. */
    default void opening(SceneWindow window) {}
  }

  private static final int WIDTH = 1024;
  private static final int HEIGHT = 768;
  private static final long OVERLAY_NANOS = 500_000_000;

  /** The longest that an ending session waits for a window that is being opened. */
  private static final long OPENING_MILLIS = 10_000;

  private static final char ESCAPE = 27;

  private final TouchSession session;
  private final SegmentedVolume volume;
  private final HapticDevice device;
  private final Listener listener;
  private final ViewOptions options;
  private final Optional<MovableSlices> slices;
  private final SceneModel model;
  private final SceneSynchronizer sync;
  private final SynchronizationThread ticking;
  private final Thread opening;
  private final Vec3 taken = new Vec3();
  private volatile Vec3 proxyGrid = new Vec3(Double.NaN, Double.NaN, Double.NaN);
  private volatile SceneLoader loader;
  private volatile SceneWindow window;
  private volatile boolean retuned;
  private boolean closed;
  private List<String> lines = List.of();
  private long linesNanos;
  private long linesFrames;
  private long linesApplications;
  private double linesMade;

  /**
   * A view of surfaces that is not open yet; from now on the reader of the session's properties.
   *
   * @param volume what is drawn; its bits may be a copy of those that are touched
   * @param device what is held; the mouse moves it where it is a {@link MouseDevice}
   */
  public SessionView(
      TouchSession session,
      SegmentedVolume volume,
      WorldAxes axes,
      HapticDevice device,
      Listener listener) {
    this(session, volume, axes, device, listener, ViewOptions.PLAIN);
  }

  /** The same with more to see. */
  public SessionView(
      TouchSession session,
      SegmentedVolume volume,
      WorldAxes axes,
      HapticDevice device,
      Listener listener,
      ViewOptions options) {
    this.session = session;
    this.options = options;
    this.volume = volume;
    this.device = device;
    this.listener = listener;
    model = new SceneModel(axes, Theme.DARK);
    sync = new SceneSynchronizer(session.properties(), volume.grid(), model, this::overlay);
    ticking = new SynchronizationThread(this::tick, this::synchronizationFailed);
    opening = new Thread(this::open, "palpate-open-view");
    opening.setDaemon(true);
    slices = options.slices().map(start -> new MovableSlices(model, start));
  }

  /** Starts the synchronization, and the window in the background. */
  public void start() {
    ticking.start();
    opening.start();
  }

  private void tick() {
    sync.run();
    if (sync.applications() > 0) {
      session.properties().touch().interactionPoint(taken);
      proxyGrid = new Vec3().set(taken);
      slices.ifPresent(planes -> planes.follow(taken));
    }
  }

  private void open() {
    SceneLoader started = begin();
    try {
      SceneWindow opened = newWindow();
      opened.onPicture(started::pictureDrawn);
      addKeys(opened.input());
      listener.opening(opened);
      if (!isClosed()) {
        opened.show();
      }
      keep(opened);
    } catch (GraphicsException e) {
      loader = null;
      started.close();
      tell("no window (" + e.what() + "): " + e.remedy() + "; goes on without one");
    }
  }

  private SceneWindow newWindow() throws GraphicsException {
    return options.panel().isPresent()
        ? new SceneWindow(model, options.panel().get(), this::ended)
        : new SceneWindow(model, "Palpate", WIDTH, HEIGHT, this::ended);
  }

  private void addKeys(WindowInput input) {
    input.onKey(ESCAPE, "end", listener::stop);
    ContactTuning feel = session.feel();
    input.onKey('+', "stiffer", () -> retune(feel::stiffer));
    input.onKey('-', "softer", () -> retune(feel::softer));
    input.onKey('.', "more friction", () -> retune(feel::rougher));
    input.onKey(',', "less friction", () -> retune(feel::decreaseFriction));
    input.onKey('n', "next solver: smooth, guarded, paper, dot", () -> retune(feel::nextSolver));
    if (device instanceof MouseDevice pointer) {
      input.setPointer(pointer::moveTo);
    }
    if (device instanceof WorkspaceDevice mapped) {
      input.onKey(
          ' ', "clutch: hold the point, or let it go", () -> retune(() -> toggleClutch(mapped)));
    }
    slices.ifPresent(planes -> addSliceKeys(input, planes));
  }

  private void addSliceKeys(WindowInput input, MovableSlices planes) {
    input.onKey(
        'g', "slices of grey values: off, fixed, at the point", () -> retune(planes::nextMode));
    input.onKey('p', "which slice [ and ] move: x, y, z", () -> retune(planes::nextAxis));
    input.onHeldKey('[', "move the slice back", () -> retune(() -> planes.move(-1)));
    input.onHeldKey(']', "move the slice on", () -> retune(() -> planes.move(1)));
  }

  private static void toggleClutch(WorkspaceDevice mapped) {
    mapped.holdClutch(!mapped.isClutchRequested());
  }

  private void retune(Runnable change) {
    change.run();
    retuned = true;
  }

  private synchronized boolean isClosed() {
    return closed;
  }

  private SceneLoader begin() {
    SceneLoader started = SceneLoader.forWindow(model, volume, options.greys(), 1);
    model.look(StandardView.OBLIQUE, (double) WIDTH / HEIGHT);
    loader = started;
    return started;
  }

  private synchronized void keep(SceneWindow opened) {
    window = opened;
    if (closed) {
      closeBoth();
    }
  }

  /**
   * Draws anew what an edit changed. By the thread that closes the view, after the bits of the
   * drawn volume have changed.
   *
   * @param segment its number
   * @param voxels a box about what changed
   */
  public void edited(int segment, IntBox voxels) {
    SceneLoader meshes = loader;
    if (meshes != null) {
      meshes.edited(segment, voxels);
    }
  }

  /** Shows landmarks, all that there are; places in the world. Any thread. */
  public void showLandmarks(List<NamedPoint> world) {
    model.setLandmarks(world);
  }

  /** Where the interaction point was at the last tick, grid coordinates; NaN before. Any thread. */
  public Vec3 proxyGrid() {
    return new Vec3().set(proxyGrid);
  }

  /** The window, once it is shown; null before and where there is none. */
  public SceneWindow window() {
    return window;
  }

  private void ended(SceneWindow.End why) {
    if (why == SceneWindow.End.CLOSED_BY_USER) {
      listener.stop();
    } else {
      tell("the window failed (" + reason() + "); the session goes on without it");
    }
  }

  private String reason() {
    SceneWindow failed = window;
    return failed == null ? "" : failed.failure().map(SessionView::words).orElse("");
  }

  private static String words(Throwable failure) {
    return failure.getMessage() == null ? failure.toString() : failure.getMessage();
  }

  private void synchronizationFailed(RuntimeException failure) {
    tell("the scene is not brought up to date (" + words(failure) + "); the session goes on");
  }

  private void tell(String line) {
    listener.tell(line);
  }

  /** New numbers twice a second while something moves; the same lines else, so no redraw. */
  private List<String> overlay() {
    long now = System.nanoTime();
    double made = surfaceProgress();
    boolean moved = sync.applications() != linesApplications || made != linesMade;
    if (retuned || (moved && now - linesNanos >= OVERLAY_NANOS)) {
      retuned = false;
      LoopStatus status = session.status();
      double rate = (status.frames() - linesFrames) * 1e9 / (now - linesNanos);
      lines = lines(status, linesNanos == 0 ? "" : String.format(Locale.ROOT, "%.0f Hz   ", rate));
      linesNanos = now;
      linesFrames = status.frames();
      linesApplications = sync.applications();
      linesMade = made;
    }
    return lines;
  }

  private List<String> lines(LoopStatus status, String rate) {
    SceneWindow shown = window;
    return List.of(
        String.format(Locale.ROOT, "%slate %.0f µs", rate, status.latestLatenessNanos() / 1e3),
        String.format(
            Locale.ROOT,
            "%.2f N   %s",
            status.forceNewton(),
            status.contact() ? "contact" : "free"),
        tuningLine(),
        slices.map(MovableSlices::line).orElse(""),
        shown == null ? "" : shown.drawnTriangleText() + pendingSurfaceText(),
        "h: help");
  }

  /** The share of the surfaces that is made; all where none are. */
  private double surfaceProgress() {
    SceneLoader meshes = loader;
    return meshes == null ? 1 : meshes.progress();
  }

  private String pendingSurfaceText() {
    double made = surfaceProgress();
    return made == 1
        ? ""
        : String.format(Locale.ROOT, "   surfaces %.0f %%", Math.floor(100 * made));
  }

  private String tuningLine() {
    ContactTuning feel = session.feel();
    boolean clutched = device instanceof WorkspaceDevice mapped && mapped.isClutchRequested();
    return String.format(
        Locale.ROOT,
        "%s   %.2f N/mm   friction %.2f%s",
        feel.solver(),
        feel.force().stiffnessNewtonPerMm(),
        feel.force().friction(),
        clutched ? "   clutch held" : "");
  }

  /** Ticks of the synchronization a second. */
  public double rateHz() {
    return ticking.rateHz();
  }

  /** When a surface was first seen, as the system counts milliseconds; 0 where it was not. */
  public long firstSurfaceMillis() {
    SceneWindow shown = window;
    return shown == null ? 0 : shown.firstSurfaceMillis();
  }

  /** Pictures drawn. */
  public long redraws() {
    SceneWindow shown = window;
    return shown == null ? 0 : shown.redraws();
  }

  /** How often the picture of what stands still was kept; once the session has ended. */
  public long stillKept() {
    SceneWindow shown = window;
    return shown == null ? 0 : shown.stillKept();
  }

  /** Bricks of surfaces that were not drawn, outside the view; once the session has ended. */
  public long skippedBricks() {
    SceneWindow shown = window;
    return shown == null ? 0 : shown.skippedBricks();
  }

  /**
   * Ends the synchronization and closes the window, also one that is just being opened. Any number
   * of times.
   */
  @Override
  public void close() {
    ticking.close();
    synchronized (this) {
      closed = true;
    }
    awaitOpening();
    synchronized (this) {
      closeBoth();
    }
  }

  private void awaitOpening() {
    if (opening != Thread.currentThread()) {
      try {
        opening.join(OPENING_MILLIS);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }
  }

  private void closeBoth() {
    if (window != null && loader != null) {
      SceneLoader meshes = loader;
      loader = null;
      window.close();
      meshes.close();
    }
  }
}
