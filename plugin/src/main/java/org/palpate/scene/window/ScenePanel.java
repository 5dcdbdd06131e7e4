package org.palpate.scene.window;

import com.jogamp.newt.awt.NewtCanvasAWT;
import com.jogamp.newt.opengl.GLWindow;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import javax.swing.JPanel;

/**
 * A component for another program's AWT or Swing window that shows one scene after another, with
 * mouse and keys as in a window of their own.
 *
 * <p>It is a NEWT window inside an AWT canvas. It draws on the scene's own thread, so a busy event
 * thread of the other program delays no picture, as it would with JOGL's GLCanvas and GLJPanel. It
 * is a heavyweight component: menus and tool tips over it must be heavyweight too. Any thread.
 */
public final class ScenePanel {
  private static final long REMOVAL_WAIT_SECONDS = 2;
  private static final Dimension PREFERRED_SIZE = new Dimension(640, 480);
  private static final Dimension MIN_SIZE = new Dimension(1, 1);

  private final JPanel panel = new JPanel(new BorderLayout());

  /** Used by the event thread alone. */
  private NewtCanvasAWT canvas;

  /** Creates an empty component. */
  public ScenePanel() {
    panel.setPreferredSize(PREFERRED_SIZE);
    panel.setMinimumSize(MIN_SIZE);
  }

  /** Returns the component to add to a window. It stays the same. */
  public Component component() {
    return panel;
  }

  /** Adds a window that is not shown yet. Does not wait for the event thread. */
  void put(GLWindow window) {
    EventQueue.invokeLater(
        () -> {
          canvas = new NewtCanvasAWT(window);
          panel.add(canvas, BorderLayout.CENTER);
          panel.revalidate();
          panel.repaint();
        });
  }

  /** Removes the window. Waits for the event thread for a limited time. */
  void clear() {
    if (EventQueue.isDispatchThread()) {
      remove();
      return;
    }
    CountDownLatch removed = new CountDownLatch(1);
    EventQueue.invokeLater(
        () -> {
          remove();
          removed.countDown();
        });
    try {
      // If the event thread is busy or gone, the end of the session must not hang.
      boolean unused = removed.await(REMOVAL_WAIT_SECONDS, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void remove() {
    if (canvas != null) {
      panel.remove(canvas);
      canvas.destroy();
      canvas = null;
      panel.revalidate();
      panel.repaint();
    }
  }
}
