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
 * A place in another program's AWT or Swing window where scenes are shown, one after the other,
 * with mouse and keys as in a window of their own.
 *
 * <p>A NEWT window inside an AWT canvas: it draws on the scene's own thread, so a busy event thread
 * of the other program neither delays a picture nor is delayed by one, as it is with JOGL's
 * GLCanvas and GLJPanel. It is a heavyweight component: menus and tips over it must be heavyweight
 * too. Any thread.
 */
public final class ScenePanel {
  private static final long PATIENCE_S = 2;
  private static final Dimension PREFERRED = new Dimension(640, 480);
  private static final Dimension LEAST = new Dimension(1, 1);

  private final JPanel panel = new JPanel(new BorderLayout());

  /** Touched by the event thread alone. */
  private NewtCanvasAWT canvas;

  /** An empty place. */
  public ScenePanel() {
    panel.setPreferredSize(PREFERRED);
    panel.setMinimumSize(LEAST);
  }

  /** What the other program adds to its window; stays the same. */
  public Component component() {
    return panel;
  }

  /** Puts a window that is not shown yet into the place. Does not wait for the event thread. */
  void put(GLWindow window) {
    EventQueue.invokeLater(
        () -> {
          canvas = new NewtCanvasAWT(window);
          panel.add(canvas, BorderLayout.CENTER);
          panel.revalidate();
          panel.repaint();
        });
  }

  /** Takes the window out again; waits a little for the event thread, but not for ever. */
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
      // Where the event thread is busy or gone, whoever ends the session must not hang with it.
      boolean unused = removed.await(PATIENCE_S, TimeUnit.SECONDS);
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
