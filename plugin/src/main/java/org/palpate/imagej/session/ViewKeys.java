package org.palpate.imagej.session;

import ij.IJ;
import java.util.function.Consumer;
import org.palpate.host.SessionView;
import org.palpate.imagej.annotation.StrokeHistory;
import org.palpate.imagej.stack.TouchRefusedException;
import org.palpate.scene.window.SceneWindow;

/**
 * What the keys of the 3-D window do to the stack. Called on the window's threads; everything is
 * handed to the session's own.
 */
final class ViewKeys implements SessionView.Listener {
  /** Something to be done by the session's thread. */
  @FunctionalInterface
  interface Action {
    /** Does it; a refusal is shown in the status bar. */
    void run() throws TouchRefusedException;
  }

  private final StackSession session;
  private final Consumer<Action> queue;

  ViewKeys(StackSession session, Consumer<Action> queue) {
    this.session = session;
    this.queue = queue;
  }

  @Override
  public void opening(SceneWindow window) {
    onKey(window, 'm', "landmark here", session::addLandmarkHere);
    onKey(window, 'a', "add voxels here", () -> session.paint(radiusMm(), true));
    onKey(window, 'x', "remove voxels here", () -> session.paint(radiusMm(), false));
    onKey(window, 'z', "undo", session::undo);
    onKey(window, 'y', "redo", session::redo);
  }

  private void onKey(SceneWindow window, char key, String help, Action action) {
    window.input().onKey(key, help, () -> queue.accept(action));
  }

  private static double radiusMm() {
    return StrokeHistory.lastRadiusMm();
  }

  @Override
  public void tell(String line) {
    IJ.log("Palpate: " + line);
  }

  @Override
  public void stop() {
    session.askToStop();
  }
}
