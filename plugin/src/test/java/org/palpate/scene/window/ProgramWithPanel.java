package org.palpate.scene.window;

import java.awt.EventQueue;
import java.lang.reflect.InvocationTargetException;
import javax.swing.JFrame;

/** Another program with a window that contains a panel of Palpate. Used by the test's thread. */
public final class ProgramWithPanel {
  private ScenePanel panel;
  private JFrame frame;

  /** Opens the window, or skips the test without a display. */
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

  /** Returns the window. On the event thread. */
  JFrame frame() {
    return frame;
  }

  /** Closes the window and waits until it is closed. */
  public void close() throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(frame::dispose);
  }
}
