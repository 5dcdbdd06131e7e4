package org.palpate.examples;

import java.awt.EventQueue;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import javax.swing.JFrame;
import org.palpate.device.HapticDevice;
import org.palpate.host.ContactScene;
import org.palpate.host.ContactSettings;
import org.palpate.host.MouseDevice;
import org.palpate.host.SessionSettings;
import org.palpate.host.SessionView;
import org.palpate.host.TouchSession;
import org.palpate.host.ViewOptions;
import org.palpate.scene.WorldAxes;
import org.palpate.scene.window.ScenePanel;
import org.palpate.volume.phantom.Phantom;

/** Shows a session inside a Swing window: hold the left button and drag to touch the head. */
public final class EmbeddedView {
  private static final CountDownLatch CLOSED = new CountDownLatch(1);

  /** Takes the number of pictures after which it ends; without it, a person closes the window. */
  public static void main(String[] args) throws Exception {
    long pictures = args.length == 0 ? Long.MAX_VALUE : Long.parseLong(args[0]);
    ScenePanel panel = new ScenePanel();
    JFrame window = new JFrame("A program of your own");
    EventQueue.invokeAndWait(() -> show(window, panel));

    ContactScene scene =
        new ContactScene(Phantom.parse("head:128").segments(), ContactSettings.standard());
    HapticDevice mouse = new MouseDevice(scene.handTarget(), 1_000_000);
    try (TouchSession session = new TouchSession(scene, mouse, SessionSettings.standard());
        SessionView view =
            new SessionView(
                session,
                scene.volume(),
                WorldAxes.LPS,
                mouse,
                listener(),
                ViewOptions.PLAIN.in(panel))) {
      session.start();
      view.start();
      boolean closed = false;
      while (!closed && !session.supervise() && view.redraws() < pictures) {
        closed = CLOSED.await(33, TimeUnit.MILLISECONDS);
      }
      System.out.println(view.redraws() + " pictures; ended: " + session.stop().cause());
    }
    EventQueue.invokeAndWait(window::dispose);
  }

  private static void show(JFrame window, ScenePanel panel) {
    window.addWindowListener(
        new WindowAdapter() {
          @Override
          public void windowClosing(WindowEvent event) {
            CLOSED.countDown();
          }
        });
    window.add(panel.component());
    window.pack();
    window.setVisible(true);
  }

  private static SessionView.Listener listener() {
    return new SessionView.Listener() {
      @Override
      public void print(String line) {
        System.err.println(line);
      }

      @Override
      public void stop() {
        CLOSED.countDown();
      }
    };
  }
}
