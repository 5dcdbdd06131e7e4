package org.palpate.scene.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.EventQueue;
import java.awt.Point;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.scene.SceneModel;
import org.palpate.scene.Theme;
import org.palpate.scene.WorldAxes;

/** A scene inside another program's window. */
class ScenePanelWindowTest {
  private static final long PATIENCE_S = 60;

  private final SceneModel model = new SceneModel(WorldAxes.LPS, Theme.LIGHT);
  private ProgramWithPanel program;
  private ScenePanel panel;

  @BeforeEach
  void open() throws Exception {
    program = new ProgramWithPanel();
    panel = program.panel();
    model.add("none", 0xe9dcc0, RigidTransform.identity(), new Vec3(), new Vec3(9, 9, 9));
  }

  @AfterEach
  void close() throws Exception {
    if (program != null) {
      program.close();
    }
  }

  private static Picture picture(SceneWindow window) throws Exception {
    CompletableFuture<Picture> picture = new CompletableFuture<>();
    window.takeSnapshot(picture::complete);
    return picture.get(PATIENCE_S, TimeUnit.SECONDS);
  }

  @Test
  void aSceneFillsItsPanel() throws Exception {
    try (SceneWindow window = new SceneWindow(model, panel, end -> {})) {
      window.show();
      Picture taken = picture(window);
      assertEquals(panel.component().getWidth(), taken.width());
      assertEquals(panel.component().getHeight(), taken.height());
      assertTrue((taken.rgb(5, 5) & 255) > 180, "the light theme's background is light");
    }
  }

  @Test
  void aBusyEventThreadDelaysNoPicture() throws Exception {
    CountDownLatch busy = new CountDownLatch(1);
    CountDownLatch goOn = new CountDownLatch(1);
    try (SceneWindow window = new SceneWindow(model, panel, end -> {})) {
      window.show();
      picture(window);
      EventQueue.invokeLater(
          () -> {
            busy.countDown();
            awaitQuietly(goOn);
          });
      awaitQuietly(busy);
      picture(window);
      goOn.countDown();
    }
  }

  private static void awaitQuietly(CountDownLatch latch) {
    try {
      assertTrue(latch.await(PATIENCE_S, TimeUnit.SECONDS));
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }

  @Test
  void mouseAndKeysReachTheScene() throws Exception {
    Assumptions.assumeTrue(
        System.getenv("XDG_CURRENT_DESKTOP") == null,
        "skipped: somebody works here, whose mouse this would move");
    Robot robot = new Robot();
    robot.setAutoWaitForIdle(true);
    CountDownLatch pressed = new CountDownLatch(1);
    try (SceneWindow window = new SceneWindow(model, panel, end -> {})) {
      window.input().onKey('q', "test", pressed::countDown);
      window.show();
      picture(window);
      Vec3 before = model.state().camera().back();
      Point corner = panel.component().getLocationOnScreen();
      robot.mouseMove(corner.x + 100, corner.y + 100);
      robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
      robot.mouseMove(corner.x + 150, corner.y + 110);
      robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
      long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_S);
      while (model.state().camera().back().equals(before) && System.nanoTime() < end) {
        Thread.onSpinWait();
      }
      assertTrue(!model.state().camera().back().equals(before), "a drag turns the scene");
      robot.keyPress(KeyEvent.VK_Q);
      robot.keyRelease(KeyEvent.VK_Q);
      assertTrue(pressed.await(PATIENCE_S, TimeUnit.SECONDS), "a key does what it is there for");
    }
  }

  @Test
  void aPanelThatIsRemovedAndAddedAgainShowsTheScene() throws Exception {
    try (SceneWindow window = new SceneWindow(model, panel, end -> {})) {
      window.show();
      picture(window);
      EventQueue.invokeAndWait(() -> program.frame().remove(panel.component()));
      model.requestRedraw();
      EventQueue.invokeAndWait(
          () -> {
            program.frame().add(panel.component());
            program.frame().validate();
          });
      assertTrue(picture(window).width() > 100);
    }
  }

  @Test
  void tenSuccessiveScenesLeaveNoThreadAndAnEmptyPanel() throws Exception {
    showOnce();
    List<String> before = threads();
    for (int round = 0; round < 10; round++) {
      showOnce();
    }
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_S);
    while (!more(threads(), before).isEmpty() && System.nanoTime() < end) {
      Thread.onSpinWait(); // NEWT's own thread ends slightly later
    }
    assertEquals(List.of(), more(threads(), before));
    EventQueue.invokeAndWait(() -> {});
    Point corner = panel.component().getLocationOnScreen();
    Color left = new Robot().getPixelColor(corner.x + 5, corner.y + 5);
    assertEquals(panel.component().getBackground(), left);
  }

  private void showOnce() throws Exception {
    try (SceneWindow window = new SceneWindow(model, panel, end -> {})) {
      window.show();
      picture(window);
    }
  }

  /**
   * Returns the names that occur more often in {@code now} than in {@code before}. A thread that
   * NEWT was still ending when {@code before} was taken may have gone meanwhile, so fewer is right.
   */
  private static List<String> more(List<String> now, List<String> before) {
    List<String> left = new ArrayList<>(now);
    before.forEach(left::remove);
    return left;
  }

  /** Returns the names of threads without their numbers, once for each thread. */
  private static List<String> threads() {
    return Thread.getAllStackTraces().keySet().stream()
        .map(thread -> thread.getName().replaceAll("[0-9a-fx]{4,}|[0-9]+", "#"))
        .sorted()
        .toList();
  }
}
