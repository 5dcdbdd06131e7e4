package org.palpate.app.command;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.palpate.display.DisplayLoss;
import org.palpate.host.SessionView;
import org.palpate.io.file.AtomicFile;
import org.palpate.scene.window.Picture;
import org.palpate.scene.window.SceneWindow;

/** What the command line does for the window of a session: tells its lines, saves snapshots. */
final class ConsoleViewListener implements SessionView.Listener {
  private final PrintWriter out;
  private final Runnable stop;

  /**
   * A listener.
   *
   * @param out gets a line where there can be no window
   * @param stop ends the session
   */
  ConsoleViewListener(PrintWriter out, Runnable stop) {
    this.out = out;
    this.stop = stop;
  }

  @Override
  public void opening(SceneWindow window) {
    DisplayLoss.install(window::displayLost);
    window.input().onKey('s', "snapshot to a file", () -> window.takeSnapshot(this::save));
  }

  private void save(Picture picture) {
    Path file = Path.of("palpate-" + System.currentTimeMillis() + ".png");
    try (AtomicFile target = new AtomicFile(file)) {
      ImageIO.write(picture.toImage(), "png", target.stream());
      target.commit();
      tell("snapshot: " + file + " (" + Files.size(file) / 1024 + " KB)");
    } catch (IOException e) {
      tell("snapshot " + file + " could not be written: " + e.getMessage());
    }
  }

  @Override
  public void tell(String line) {
    out.println(line);
    out.flush();
  }

  @Override
  public void stop() {
    stop.run();
  }
}
