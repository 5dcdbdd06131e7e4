package org.palpate.imagej.session;

import ij.IJ;
import org.palpate.host.SessionView;
import org.palpate.imagej.annotation.StrokeHistory;
import org.palpate.imagej.stack.TouchRefusedException;
import org.palpate.scene.window.SceneWindow;

/**
 * The keys of the 3-D window that set landmarks and correct the stack. The window's threads call
 * it; it queues every action for the session's thread.
 */
final class ViewKeys implements SessionView.Listener {
  /** An action for the session's thread. */
  @FunctionalInterface
  interface Action {
    /** Executes the action; the status bar shows a refusal. */
    void run() throws TouchRefusedException;
  }

  private final StackSession session;

  ViewKeys(StackSession session) {
    this.session = session;
  }

  @Override
  public void opening(SceneWindow window) {
    onKey(window, 'm', "add a landmark here", session::addLandmarkHere);
    onKey(window, 'a', "add voxels here", () -> session.paint(radiusMm(), true));
    onKey(window, 'x', "remove voxels here", () -> session.paint(radiusMm(), false));
    onKey(window, 'z', "undo", session::undo);
    onKey(window, 'y', "redo", session::redo);
  }

  private void onKey(SceneWindow window, char key, String help, Action action) {
    window.input().onKey(key, help, () -> session.queue(action));
  }

  private static double radiusMm() {
    return StrokeHistory.lastRadiusMm();
  }

  @Override
  public void print(String line) {
    IJ.log("Palpate: " + line);
  }

  @Override
  public void stop() {
    session.requestStop();
  }
}
