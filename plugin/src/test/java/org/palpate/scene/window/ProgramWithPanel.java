package org.palpate.scene.window;

import java.awt.EventQueue;
import java.lang.reflect.InvocationTargetException;
import javax.swing.JFrame;

/** Another program with a window, a panel of ours in it. By the test's thread. */
public final class ProgramWithPanel {
  private ScenePanel panel;
  private JFrame frame;

  /** Opens it, or skips the test where there is no display. */
  public ProgramWithPanel() throws InterruptedException, InvocationTargetException {
    TestDisplay.require();
    EventQueue.invokeAndWait(
        () -> {
          panel = new ScenePanel();
          frame = new JFrame("host");
          frame.add(panel.component());
          frame.setSize(320, 240);
          frame.setVisible(true);
        });
  }

  public ScenePanel panel() {
    return panel;
  }

  /** Its window; by the event thread. */
  JFrame frame() {
    return frame;
  }

  /** Closes its window, and waits until it is. */
  public void close() throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(frame::dispose);
  }
}
