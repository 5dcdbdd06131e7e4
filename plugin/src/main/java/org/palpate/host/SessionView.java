package org.palpate.host;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.palpate.device.HapticDevice;
import org.palpate.device.WorkspaceDevice;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.recording.EditRecorder;
import org.palpate.scene.Camera;
import org.palpate.scene.ChangedVoxels;
import org.palpate.scene.MovableSlices;
import org.palpate.scene.NamedPoint;
import org.palpate.scene.SceneLoader;
import org.palpate.scene.SceneModel;
import org.palpate.scene.SceneSynchronizer;
import org.palpate.scene.StandardView;
import org.palpate.scene.SynchronizationThread;
import org.palpate.scene.Theme;
import org.palpate.scene.ToolMarks;
import org.palpate.scene.WorldAxes;
import org.palpate.scene.surface.GreyRange;
import org.palpate.scene.window.GraphicsException;
import org.palpate.scene.window.SceneWindow;
import org.palpate.scene.window.SliceKeys;
import org.palpate.scene.window.WindowInput;
import org.palpate.volume.BitCube;
import org.palpate.volume.SegmentedVolume;

/**
 * The window of a live session and the thread that keeps it up to date.
 *
 * <p>The window opens on a thread of its own, so that the force does not wait for it. A failure of
 * the window never ends the session. Any thread may call every method unless it says otherwise.
 */
public final class SessionView implements AutoCloseable {
  /** Receives what a view reports. */
  public interface Listener {
    /**
     * Prints a line. Any thread.
     *
     * @param line one line for the user
     */
    void print(String line);

    /** Ends the session: the user pressed Escape or closed the window. Any thread. */
    void stop();

    /**
     * Prepares a window that is about to be shown, for example by adding keys. On the thread that
     * opens it.
     *
     * @param window the window, which is not shown yet
     */
    default void opening(SceneWindow window) {}
  }

  private static final int WIDTH = 1024;
  private static final int HEIGHT = 768;

  /** The longest time that an ending session waits for a window that is opening. */
  private static final long OPENING_WAIT_MILLIS = 10_000;

  private static final char ESCAPE = 27;

  private final TouchSession session;
  private final SegmentedVolume volume;
  private final DrawnSolids solids;
  private final DrawnSolids.Probe touched;
  private final HapticDevice device;
  private final Listener listener;
  private final ViewOptions options;
  private final Optional<MovableSlices> slices;
  private final Optional<LiveThreshold> threshold;
  private final SceneModel model;
  private final List<Vec3> toolPoints;
  private final SessionOverlay overlay;
  private final SessionOverlay.UndoKeys undoKeys;
  private final Optional<WorkspaceDevice> followsView;
  private final SceneSynchronizer synchronizer;
  private final SynchronizationThread synchronization;
  private final Thread opening;
  private final Vec3 point = new Vec3();
  private final Vec3 deviceGrid = new Vec3();
  private final EditRecorder changes;
  private final ChangedVoxels changed;

  /** The camera whose axes the device has; synchronization thread. */
  private Camera followed;

  private volatile Vec3 proxyGrid = new Vec3(Double.NaN, Double.NaN, Double.NaN);
  private volatile List<NamedPoint> landmarks = List.of();
  private volatile SceneLoader loader;
  private volatile SceneWindow window;
  private boolean closed;

  /**
   * Creates a view of surfaces made of bits, which is not open yet. From now on the view is the one
   * reader of the session's properties.
   *
   * @param session the session to show
   * @param volume the drawn segments; their bits may be a copy of those that are touched
   * @param axes orientation of the volume's world axes
   * @param device the device of the session; the mouse moves it if it is a {@link MouseDevice}, and
   *     takes it over if it is a {@link MouseTakeover}
   * @param listener receives reports
   */
  public SessionView(
      TouchSession session,
      SegmentedVolume volume,
      WorldAxes axes,
      HapticDevice device,
      Listener listener) {
    this(session, volume, axes, device, listener, ViewOptions.PLAIN);
  }

  /**
   * Creates a view with further options; otherwise as the other constructor.
   *
   * @param session the session to show
   * @param volume the drawn segments; their bits may be a copy of those that are touched
   * @param axes orientation of the volume's world axes
   * @param device the device of the session
   * @param listener receives reports
   * @param options grey values, planes, keys and the place of the picture
   */
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
    List<RigidTransform> starts =
        session.held().map(held -> held.scene().startPoses()).orElse(List.of());
    solids = new DrawnSolids(volume, starts);
    touched = new DrawnSolids.Probe(solids);
    this.device = device;
    this.listener = listener;
    model = new SceneModel(axes, Theme.DARK);
    toolPoints = session.held().map(held -> held.scene().drawnPoints()).orElse(List.of());
    model.setUpsideDown(options.upsideDown());
    options.clip().ifPresent(model::clip);
    options.deformed().ifPresent(by -> model.changeLook(look -> look.with(by)));
    slices = options.slices().map(start -> new MovableSlices(model, start));
    threshold =
        options
            .threshold()
            .map(live -> new LiveThreshold(live.scene(), live.start(), this::replaced));
    followsView =
        options.axesFollowView() && device instanceof WorkspaceDevice mapped
            ? Optional.of(mapped)
            : Optional.empty();
    overlay = new SessionOverlay(session, device, slices, threshold);
    undoKeys = new SessionOverlay.UndoKeys(session, overlay::hint);
    synchronizer =
        new SceneSynchronizer(
            session.properties(),
            volume.grid(),
            model,
            this::overlayLines,
            this::toolMarks,
            session.shape());
    synchronization =
        new SynchronizationThread(this::tick, this::remeshChanges, this::synchronizationFailed);
    changes = session.changes();
    changed = new ChangedVoxels(volume.segments().size());
    opening = new Thread(this::open, "palpate-open-view");
    opening.setDaemon(true);
  }

  /** Starts the synchronization, and opens the window in the background. */
  public void start() {
    synchronization.start();
    opening.start();
    threshold.ifPresent(LiveThreshold::start);
  }

  private void tick() {
    followsView.ifPresent(this::followView);
    undoKeys.tick();
    if (synchronizer.applications() > 0 && session.properties().touch().contact()) {
      touched.refresh();
      overlay.touches(touched.firstName(proxyGrid, deviceGrid));
    }
    synchronizer.run();
    if (synchronizer.applications() > 0) {
      synchronizer.pointAtRest(point);
      synchronizer.deviceAtRest(deviceGrid);
      session
          .held()
          .ifPresent(held -> solids.follow(held.publisher(), Optional.ofNullable(loader)));
      proxyGrid = new Vec3().set(point);
      overlay.follow(volume.grid().gridToWorld(point, new Vec3()));
      slices.ifPresent(planes -> planes.follow(point));
    }
  }

  /** Rebuilds the surfaces where frames have changed voxels since the last step. */
  private void remeshChanges() {
    changes.drainTo((sample, segment, i, j, k, solid) -> changed.note(segment, i, j, k, solid));
    if (changed.remesh(this::remesh)) {
      overlay.removed(changed, volume);
    }
  }

  /** Gives a device the axes of the picture if the camera has moved. */
  private void followView(WorkspaceDevice mapped) {
    Camera camera = model.camera();
    if (camera != followed) {
      followed = camera;
      mapped.turnAxes(camera.axes(model.axes()));
    }
  }

  /** Returns how the tool lies in the last publication; empty if a point touches. */
  private Optional<ToolMarks> toolMarks() {
    return session.held().map(held -> held.publisher().marks(toolPoints, model.axes()));
  }

  private void open() {
    SceneLoader started = startLoading();
    try {
      SceneWindow opened = newWindow();
      opened.onPicture(started::pictureDrawn);
      addKeys(opened.input());
      listener.opening(opened);
      if (!isClosed()) {
        opened.show();
      }
      setWindow(opened);
    } catch (GraphicsException e) {
      loader = null;
      started.close();
      windowLost("no window (" + e.what() + "): " + e.remedy());
    }
  }

  private SceneWindow newWindow() throws GraphicsException {
    return options.panel().isPresent()
        ? new SceneWindow(model, options.panel().get(), this::windowEnded)
        : new SceneWindow(model, "Palpate", WIDTH, HEIGHT, this::windowEnded);
  }

  private void addKeys(WindowInput input) {
    input.onKey(ESCAPE, "end", listener::stop);
    ContactTuning tuning = session.tuning();
    input.onKey('+', "stiffer", () -> applyAndShow(tuning::increaseStiffness));
    input.onKey('-', "softer", () -> applyAndShow(tuning::decreaseStiffness));
    input.onKey('.', "more friction", () -> applyAndShow(tuning::increaseFriction));
    input.onKey(',', "less friction", () -> applyAndShow(tuning::decreaseFriction));
    tuning
        .solverHelp()
        .ifPresent(help -> input.onKey('n', help, () -> applyAndShow(tuning::nextSolver)));
    if (session.canHold()) {
      input.onKey('4', "ghosts: where bodies started", () -> solids.toggleGhosts(loader));
      input.onKey('x', "take hold of the touched body, or let go", session::toggleHold);
    }
    undoKeys.addTo(input);
    MouseTakeover.mouseOf(device).ifPresent(mouse -> addMouse(input, mouse));
    if (device instanceof WorkspaceDevice mapped) {
      input.onKey(
          ' ', "clutch: hold or release the point", () -> applyAndShow(mapped::toggleClutch));
    }
    slices.ifPresent(planes -> SliceKeys.add(input, planes, this::applyAndShow));
    threshold.ifPresent(
        live -> live.addKeys(input, options.threshold().orElseThrow().refusal(), overlay));
    if (!volume.segments().isEmpty()) {
      input.addLegend();
    }
  }

  private void addMouse(WindowInput input, MouseDevice mouse) {
    MouseTouch touch = new MouseTouch(solids, mouse, overlay::hint);
    input.setPointer(touch);
    input.onKey('c', "free the point: withdraw it from the surface", touch::free);
    if (session.held().isPresent()) {
      input.onDrag(
          WindowInput.DragKeys.CONTROL_AND_SHIFT,
          "turn the tool, or the body in hand",
          (right, up) -> mouse.turn(model.camera().dragRotation(right, up, model.axes())));
    }
  }

  /** Shows voxels that the haptic thread collides with from now on. */
  private void replaced(int segment, BitCube bits, Optional<GreyRange> grey) {
    solids.replace(segment, bits);
    withSurfaces(meshes -> meshes.replace(segment, bits, grey));
  }

  private void applyAndShow(Runnable change) {
    change.run();
    overlay.invalidate();
  }

  private synchronized boolean isClosed() {
    return closed;
  }

  private SceneLoader startLoading() {
    SceneLoader started = SceneLoader.forWindow(model, volume, options.greys(), solids.poses(), 1);
    options.ghosts().ifPresent(started::addGhosts);
    model.look(StandardView.OBLIQUE, (double) WIDTH / HEIGHT);
    loader = started;
    solids.showPoses(started); // Bodies may have moved meanwhile.
    return started;
  }

  private synchronized void setWindow(SceneWindow opened) {
    window = opened;
    if (closed) {
      closeBoth();
    }
  }

  /**
   * Rebuilds the surface where the caller has changed voxels of the drawn copy. Changes that frames
   * make are shown without this call. Call it on the thread that closes the view, after the bits of
   * the drawn volume have changed.
   *
   * @param segment its number
   * @param voxels a box around the changed voxels
   */
  public void remesh(int segment, IntBox voxels) {
    withSurfaces(meshes -> meshes.remesh(segment, voxels));
  }

  /**
   * Changes the surfaces, if a window shows them.
   *
   * @param change runs on the calling thread, if a window shows surfaces
   */
  public void withSurfaces(Consumer<SceneLoader> change) {
    SceneLoader meshes = loader;
    if (meshes != null) {
      change.accept(meshes);
    }
  }

  /**
   * Shows landmarks and no others.
   *
   * @param worldMm the landmarks, world mm; the list is copied
   */
  public void showLandmarks(List<NamedPoint> worldMm) {
    landmarks = List.copyOf(worldMm);
    model.setLandmarks(worldMm);
  }

  /** {@return the landmarks that are shown, world mm} */
  public List<NamedPoint> landmarks() {
    return landmarks;
  }

  /**
   * Shows a line for a few seconds.
   *
   * @param text one line; empty to remove the last
   */
  public void hint(String text) {
    overlay.hint(text);
  }

  /**
   * Shows further lines of text below the others.
   *
   * @param lines the lines, which replace those of the last call
   */
  public void show(List<String> lines) {
    overlay.show(lines);
  }

  /** {@return the pose of each body as it is drawn, from rest to present; none if all rest} */
  public List<RigidTransform> bodyPoses() {
    return solids.poses();
  }

  /** {@return the interaction point of the last tick in grid coordinates; NaN before the first} */
  public Vec3 proxyGrid() {
    return new Vec3().set(proxyGrid);
  }

  private void windowEnded(SceneWindow.End end) {
    if (end == SceneWindow.End.CLOSED_BY_USER) {
      listener.stop();
    } else {
      windowLost("the window failed (" + reason() + ")");
    }
  }

  /** Ends a session with the mouse, which has no other input; any other session goes on. */
  private void windowLost(String what) {
    if (device instanceof MouseDevice mouse) {
      listener.print(what + "; the mouse is lost with it");
      mouse.close();
    } else {
      listener.print(what + "; the session goes on without it");
    }
  }

  private String reason() {
    SceneWindow failed = window;
    return failed == null ? "" : failed.failure().map(SessionView::message).orElse("");
  }

  private static String message(Throwable failure) {
    return failure.getMessage() == null ? failure.toString() : failure.getMessage();
  }

  private void synchronizationFailed(RuntimeException failure) {
    listener.print(
        "the scene is no longer updated (" + message(failure) + "); the session goes on");
  }

  private List<String> overlayLines() {
    SceneWindow shown = window;
    return overlay.update(
        synchronizer.applications(),
        surfaceProgress(),
        shown == null ? "" : shown.drawnTriangleText());
  }

  /** Returns the fraction of the surfaces that is complete; 1 if there are none. */
  private double surfaceProgress() {
    SceneLoader meshes = loader;
    return meshes == null ? 1 : meshes.progress();
  }

  /** {@return the rate of the synchronization, Hz} */
  public double rateHz() {
    return synchronization.rateHz();
  }

  /**
   * {@return when a surface was first shown, in milliseconds of the system clock; 0 if none was}
   */
  public long firstSurfaceMillis() {
    SceneWindow shown = window;
    return shown == null ? 0 : shown.firstSurfaceMillis();
  }

  /** {@return the number of pictures drawn} */
  public long redraws() {
    SceneWindow shown = window;
    return shown == null ? 0 : shown.redraws();
  }

  /** {@return how often the picture of the static parts was reused; final after the session} */
  public long staticReused() {
    SceneWindow shown = window;
    return shown == null ? 0 : shown.staticReused();
  }

  /** {@return how many surface bricks outside the view were not drawn; final after the session} */
  public long culledBricks() {
    SceneWindow shown = window;
    return shown == null ? 0 : shown.culledBricks();
  }

  /** Ends the synchronization and closes the window, even one that is opening. Repeatable. */
  @Override
  public void close() {
    synchronization.close();
    threshold.ifPresent(LiveThreshold::close);
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
        opening.join(OPENING_WAIT_MILLIS);
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
