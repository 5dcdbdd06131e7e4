package org.palpate.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.palpate.device.HapticDevice;
import org.palpate.device.SimulatedDevice;
import org.palpate.loop.LoopEnd;
import org.palpate.scene.WorldAxes;
import org.palpate.scene.window.Picture;
import org.palpate.scene.window.ProgramWithPanel;
import org.palpate.scene.window.SceneWindow;
import org.palpate.volume.phantom.Phantom;

/** A session in a panel inside the window of another program. */
class EmbeddedViewWindowTest {
  private static final long PATIENCE_S = 60;
  private static final long PERIOD_NANOS = 1_000_000;

  private final CompletableFuture<SceneWindow> opening = new CompletableFuture<>();
  private ProgramWithPanel program;

  @BeforeEach
  void openProgram() throws Exception {
    program = new ProgramWithPanel();
  }

  @AfterEach
  void closeProgram() throws Exception {
    if (program != null) {
      program.close();
    }
  }

  @Test
  void showsASessionInThePanelAndLeavesNoThread() throws Exception {
    ContactScene scene =
        new ContactScene(
            Phantom.parse("sphere:32").segments(), ContactSettings.standard(SolverKind.GUARDED));
    HapticDevice hand = new SimulatedDevice(7, scene.handTarget(), PERIOD_NANOS);
    LoopEnd end;
    try (TouchSession session = session(scene, hand);
        SessionView view =
            new SessionView(
                session,
                scene.volume(),
                WorldAxes.LPS,
                hand,
                listener(),
                ViewOptions.PLAIN.in(program.panel()))) {
      session.start();
      view.start();
      Picture picture = picture(opening.get(PATIENCE_S, TimeUnit.SECONDS));
      assertEquals(program.panel().component().getWidth(), picture.width());
      end = session.stop();
    }
    assertEquals(LoopEnd.Cause.STOPPED, end.cause());
    EventQueue.invokeAndWait(() -> {});
    assertTrue(palpateThreads().isEmpty(), palpateThreads().toString());
  }

  private static TouchSession session(ContactScene scene, HapticDevice hand) {
    return new TouchSession(scene, hand, SessionSettings.standard());
  }

  private static Picture picture(SceneWindow window) throws Exception {
    CompletableFuture<Picture> picture = new CompletableFuture<>();
    window.takeSnapshot(picture::complete);
    return picture.get(PATIENCE_S, TimeUnit.SECONDS);
  }

  private SessionView.Listener listener() {
    return new SessionView.Listener() {
      @Override
      public void print(String line) {
        opening.completeExceptionally(new IllegalStateException(line));
      }

      @Override
      public void stop() {}

      @Override
      public void opening(SceneWindow window) {
        opening.complete(window);
      }
    };
  }

  /** Returns the names of Palpate's running threads, except JOGL's, which inherit their names. */
  private static List<String> palpateThreads() {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_S);
    List<String> names;
    do {
      names =
          Thread.getAllStackTraces().keySet().stream()
              .map(Thread::getName)
              .filter(name -> name.startsWith("palpate") && !name.contains("SharedResource"))
              .toList();
    } while (!names.isEmpty() && System.nanoTime() < end);
    return names;
  }
}
