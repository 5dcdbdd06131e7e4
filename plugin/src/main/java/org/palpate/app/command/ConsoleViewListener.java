package org.palpate.app.command;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.imageio.ImageIO;
import org.palpate.app.process.OutputPaths;
import org.palpate.display.DisplayLoss;
import org.palpate.frame.ToolFrame;
import org.palpate.geometry.Vec3;
import org.palpate.host.SessionView;
import org.palpate.host.TouchSession;
import org.palpate.host.placing.PlacingKeys;
import org.palpate.io.file.AtomicFile;
import org.palpate.scene.WorldAxes;
import org.palpate.scene.window.Picture;
import org.palpate.scene.window.SceneWindow;
import org.palpate.scene.window.WindowInput;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;

/** Prints the reports of a session's view and saves snapshots of its window. Any thread. */
final class ConsoleViewListener implements SessionView.Listener {
  private final PrintWriter out;
  private final Runnable stop;
  private volatile Optional<SessionLandmarks> landmarks = Optional.empty();
  private volatile Consumer<WindowInput> keys = input -> {};
  private volatile Optional<PlacingKeys> placing = Optional.empty();

  /**
   * Creates a listener.
   *
   * @param out receives the lines
   * @param stop ends the session
   */
  ConsoleViewListener(PrintWriter out, Runnable stop) {
    this.out = out;
    this.stop = stop;
  }

  /** Adds keys for the landmarks of a view and for its movable bodies. Before it is started. */
  void serve(SessionView view, TouchSession session, SegmentedVolume volume, WorldAxes axes) {
    landmarks =
        Optional.of(
            new SessionLandmarks(
                () -> volume.grid().gridToWorld(view.proxyGrid(), new Vec3()),
                () -> session.toolFrame().map(ToolFrame::chosenBody).orElse(-1),
                view::bodyPoses,
                axes,
                view::showLandmarks,
                this::print));
    List<String> names = volume.segments().stream().map(Segment::name).toList();
    placing =
        session.canHold()
            ? Optional.of(new PlacingKeys(session, names, view::hint))
            : Optional.empty();
  }

  /** Returns the lines about landmarks, after moving them with their bodies. */
  List<String> landmarkLines() {
    return landmarks.map(SessionLandmarks::follow).orElse(List.of());
  }

  /** Adds further keys when the window opens. Before the view is started. */
  void addKeys(Consumer<WindowInput> further) {
    keys = keys.andThen(further);
  }

  @Override
  public void opening(SceneWindow window) {
    DisplayLoss.install(window::displayLost);
    landmarks.ifPresent(marks -> marks.addKeys(window.input()));
    keys.accept(window.input());
    placing.ifPresent(keys -> keys.addTo(window.input()));
    window.input().onKey('s', "save a snapshot", () -> window.takeSnapshot(this::save));
  }

  private void save(Picture picture) {
    Path file = Path.of("palpate-" + System.currentTimeMillis() + ".png");
    try (AtomicFile target = new AtomicFile(file)) {
      ImageIO.write(picture.toImage(), "png", target.stream());
      target.commit();
      print(OutputPaths.written(file, "snapshot, " + Files.size(file) / 1024 + " KB"));
    } catch (IOException e) {
      print("snapshot " + file + " could not be written: " + e.getMessage());
    }
  }

  @Override
  public void print(String line) {
    out.println(line);
    out.flush();
  }

  @Override
  public void stop() {
    stop.run();
  }
}
