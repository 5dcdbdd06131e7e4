package org.palpate.app;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import javax.imageio.ImageIO;
import org.palpate.device.HapticDevice;
import org.palpate.device.WorkspaceDevice;
import org.palpate.host.Feel;
import org.palpate.host.PointerDevice;
import org.palpate.host.TouchSession;
import org.palpate.interaction.LoopStatus;
import org.palpate.io.NewFile;
import org.palpate.scene.SceneLoader;
import org.palpate.scene.SceneModel;
import org.palpate.scene.StandardView;
import org.palpate.scene.SynchronizationThread;
import org.palpate.scene.Theme;
import org.palpate.scene.TouchSync;
import org.palpate.scene.WorldAxes;
import org.palpate.scene.window.GraphicsException;
import org.palpate.scene.window.Picture;
import org.palpate.scene.window.SceneWindow;
import org.palpate.scene.window.WindowInput;
import org.palpate.volume.SegmentedVolume;

/**
 * The window of a live session and the thread that keeps it up to date. It opens on a thread of its
 * own, so that force does not wait for it; whatever befalls it, the session goes on.
 */
final class LiveView implements AutoCloseable {
  private static final int WIDTH = 1024;
  private static final int HEIGHT = 768;
  private static final long OVERLAY_NANOS = 500_000_000;
  private static final char ESCAPE = 27;

  private final TouchSession session;
  private final SegmentedVolume volume;
  private final HapticDevice device;
  private final PrintWriter out;
  private final Runnable stop;
  private final SceneModel model;
  private final TouchSync sync;
  private final SynchronizationThread ticking;
  private final Thread opening;
  private SceneLoader loader;
  private volatile SceneWindow window;
  private volatile boolean retuned;
  private boolean closed;
  private List<String> lines = List.of();
  private long linesNanos;
  private long linesFrames;
  private long linesApplications;

  /**
   * A view that is not open yet.
   *
   * @param device what is held; the mouse moves it where it is a {@link PointerDevice}
   * @param out gets a line where there can be no window
   * @param stop ends the session: Escape, or the window closed
   */
  LiveView(
      TouchSession session,
      SegmentedVolume volume,
      WorldAxes axes,
      HapticDevice device,
      PrintWriter out,
      Runnable stop) {
    this.session = session;
    this.volume = volume;
    this.device = device;
    this.out = out;
    this.stop = stop;
    model = new SceneModel(axes, Theme.DARK);
    sync = new TouchSync(session.properties(), volume.grid(), model, this::overlay);
    ticking = new SynchronizationThread(sync);
    opening = new Thread(this::open, "palpate-open-view");
    opening.setDaemon(true);
  }

  /** Starts the synchronization, and the window in the background. */
  void start() {
    ticking.start();
    opening.start();
  }

  private void open() {
    SceneLoader started = new SceneLoader(model, volume, 1);
    model.look(StandardView.OBLIQUE, (double) WIDTH / HEIGHT);
    try {
      SceneWindow opened = new SceneWindow(model, "Palpate", WIDTH, HEIGHT, this::ended);
      addKeys(opened);
      opened.show();
      keep(started, opened);
    } catch (GraphicsException e) {
      started.close();
      tell("no window (" + e.what() + "): " + e.remedy() + "; goes on without one");
    }
  }

  private synchronized void keep(SceneLoader started, SceneWindow opened) {
    loader = started;
    window = opened;
    if (closed) {
      closeBoth();
    }
  }

  private void addKeys(SceneWindow opened) {
    opened.input().onKey('s', "snapshot to a file", () -> opened.takeSnapshot(this::save));
    opened.input().onKey(ESCAPE, "end", stop);
    addFeelKeys(opened.input());
    if (device instanceof PointerDevice pointer) {
      opened.input().setPointer(pointer::moveTo);
    }
    if (device instanceof WorkspaceDevice mapped) {
      opened
          .input()
          .onKey(
              ' ',
              "clutch: hold the point, or let it go",
              () -> retune(() -> toggleClutch(mapped)));
    }
  }

  private void addFeelKeys(WindowInput input) {
    Feel feel = session.feel();
    input.onKey('+', "stiffer", () -> retune(feel::stiffer));
    input.onKey('-', "softer", () -> retune(feel::softer));
    input.onKey('.', "more friction", () -> retune(feel::rougher));
    input.onKey(',', "less friction", () -> retune(feel::slipperier));
    input.onKey('n', "next solver: guarded, smooth, paper, dot", () -> retune(feel::nextSolver));
  }

  private static void toggleClutch(WorkspaceDevice mapped) {
    mapped.holdClutch(!mapped.isClutchWanted());
  }

  private void retune(Runnable change) {
    change.run();
    retuned = true;
  }

  private void save(Picture picture) {
    Path file = Path.of("palpate-" + System.currentTimeMillis() + ".png");
    try (NewFile target = new NewFile(file)) {
      ImageIO.write(picture.toImage(), "png", target.stream());
      target.commit();
      tell("snapshot: " + file + " (" + Files.size(file) / 1024 + " KB)");
    } catch (IOException e) {
      tell("snapshot " + file + " could not be written: " + e.getMessage());
    }
  }

  private void ended(SceneWindow.End why) {
    if (why == SceneWindow.End.CLOSED_BY_USER) {
      stop.run();
    } else {
      tell("the window failed (" + reason() + "); the session goes on without it");
    }
  }

  private String reason() {
    SceneWindow failed = window;
    return failed == null ? "" : failed.failure().map(Throwable::toString).orElse("");
  }

  private void tell(String line) {
    out.println(line);
    out.flush();
  }

  /** New numbers twice a second while something moves; the same lines else, so no redraw. */
  private List<String> overlay() {
    long now = System.nanoTime();
    boolean moved = sync.applications() != linesApplications;
    if (retuned || (moved && now - linesNanos >= OVERLAY_NANOS)) {
      retuned = false;
      LoopStatus status = session.status();
      double rate = (status.frames() - linesFrames) * 1e9 / (now - linesNanos);
      lines = lines(status, linesNanos == 0 ? "" : String.format(Locale.ROOT, "%.0f Hz   ", rate));
      linesNanos = now;
      linesFrames = status.frames();
      linesApplications = sync.applications();
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
        feelLine(),
        shown == null ? "" : shown.drawnOfAll(),
        "h: help");
  }

  private String feelLine() {
    Feel feel = session.feel();
    boolean clutched = device instanceof WorkspaceDevice mapped && mapped.isClutchWanted();
    return String.format(
        Locale.ROOT,
        "%s   %.2f N/mm   friction %.2f%s",
        feel.solver(),
        feel.force().stiffnessNewtonPerMm(),
        feel.force().friction(),
        clutched ? "   clutch held" : "");
  }

  /** Ticks of the synchronization a second. */
  double rateHz() {
    return ticking.rateHz();
  }

  /** Pictures drawn. */
  long redraws() {
    SceneWindow shown = window;
    return shown == null ? 0 : shown.redraws();
  }

  /** Ends the synchronization and closes the window. Any number of times. */
  @Override
  public void close() {
    ticking.close();
    synchronized (this) {
      closed = true;
      closeBoth();
    }
  }

  private void closeBoth() {
    if (window != null) {

      window.close();
      loader.close();
    }
  }
}
