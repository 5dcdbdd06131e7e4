package org.palpate.scene.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.jogamp.opengl.GLContext;
import java.util.Locale;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.scene.SceneLoader;
import org.palpate.scene.SceneModel;
import org.palpate.scene.SceneObject;
import org.palpate.scene.StandardView;
import org.palpate.scene.Stereo;
import org.palpate.scene.Theme;
import org.palpate.scene.WorldAxes;
import org.palpate.volume.phantom.Phantom;

class SceneWindowWindowTest {
  private static final long PATIENCE_S = 60;

  private final SceneModel model = new SceneModel(WorldAxes.LPS, Theme.LIGHT);

  @BeforeEach
  void display() {
    TestDisplay.require();
    model.add("none", 0xe9dcc0, RigidTransform.identity(), new Vec3(), new Vec3(9, 9, 9));
  }

  @Test
  void drawsOnRequestAndTakesASnapshot() throws Exception {
    try (SceneWindow window = new SceneWindow(model, "test", 200, 150, end -> {})) {
      window.show();
      CompletableFuture<Picture> picture = new CompletableFuture<>();
      window.takeSnapshot(picture::complete);
      Picture taken = picture.get(PATIENCE_S, TimeUnit.SECONDS);
      assertTrue(taken.width() > 0 && taken.height() > 0);
      assertTrue((taken.rgb(5, 5) & 255) > 180, "the light theme's background is light");
    }
  }

  @Test
  void transparentTrianglesAreCountedOnce() throws Exception {
    try (SceneLoader loader = new SceneLoader(model, Phantom.parse("sphere:32").segments(), 1);
        SceneWindow window = new SceneWindow(model, "test", 200, 150, end -> {})) {
      loader.await(TimeUnit.SECONDS.toMillis(PATIENCE_S));
      SceneObject sphere = model.objects().get(1);
      model.setOpacity(sphere, 0.5);
      model.look(StandardView.FRONT, 4.0 / 3);
      window.show();
      picture(window);
      String count = String.format(Locale.ROOT, "%,d", sphere.triangleCount(0));
      assertEquals(count + " of " + count + " triangles drawn", window.drawnTriangleText());
    }
  }

  @Test
  void aFailingDrawingIsReportedOnceAndTheModelContinues() throws Exception {
    CompletableFuture<SceneWindow.End> told = new CompletableFuture<>();
    try (SceneWindow window = new SceneWindow(model, "test", 200, 150, told::complete)) {
      window.show();
      window.takeSnapshot(
          taken -> {
            throw new IllegalStateException("the driver fails");
          });
      assertEquals(SceneWindow.End.FAILED, told.get(PATIENCE_S, TimeUnit.SECONDS));
      assertTrue(window.failure().isPresent());
      CountDownLatch changed = new CountDownLatch(1);
      model.onChange(changed::countDown);
      model.look(StandardView.BACK, 1);
      assertEquals(0, changed.getCount());
    }
  }

  @Test
  void closingTwiceIsHarmlessAndReportsNothing() throws Exception {
    CompletableFuture<SceneWindow.End> told = new CompletableFuture<>();
    SceneWindow window = new SceneWindow(model, "test", 200, 150, told::complete);
    window.show();
    window.close();
    window.close();
    assertTrue(!told.isDone());
  }

  @Test
  void aSecondWindowAfterTheFirstStillDraws() throws Exception {
    SceneWindow first = new SceneWindow(model, "first", 100, 100, end -> {});
    first.show();
    first.close();
    drawsOnRequestAndTakesASnapshot();
  }

  @Test
  void aWindowClosedByItsUserTellsItsOwnerOnce() throws Exception {
    AtomicInteger told = new AtomicInteger();
    CompletableFuture<SceneWindow.End> end = new CompletableFuture<>();
    SceneWindow window =
        new SceneWindow(
            model,
            "test",
            200,
            150,
            why -> {
              told.incrementAndGet();
              end.complete(why);
            });
    window.show();
    picture(window);
    window.glWindow().destroy();
    assertEquals(SceneWindow.End.CLOSED_BY_USER, end.get(PATIENCE_S, TimeUnit.SECONDS));
    window.close();
    assertEquals(1, told.get());
  }

  @ParameterizedTest
  @EnumSource(
      value = Stereo.class,
      names = {"OFF", "ANAGLYPH", "SIDE_BY_SIDE"})
  void aWindowOfOnePixelDrawsAndGrowsAgain(Stereo stereo) throws Exception {
    model.changeLook(look -> look.with(stereo));
    try (SceneWindow window = new SceneWindow(model, "test", 200, 150, end -> {})) {
      window.show();
      picture(window);
      window.glWindow().setSize(1, 1);
      picture(window);
      window.glWindow().setSize(180, 120);
      picture(window);
      assertTrue(window.failure().isEmpty(), window.failure().toString());
    }
  }

  @Test
  void aLostContextIsReplacedAndTheSceneUploadedAgain() throws Exception {
    try (SceneWindow window = new SceneWindow(model, "test", 200, 150, end -> {})) {
      window.show();
      Picture before = picture(window);
      GLContext next = window.glWindow().getDelegatedDrawable().createContext(null);
      window.glWindow().setContext(next, true);
      Picture after = picture(window);
      assertEquals(before.rgb(100, 75), after.rgb(100, 75));
      assertTrue(window.failure().isEmpty(), window.failure().toString());
    }
  }

  @Test
  void anErrorOfTheJvmDuringDrawingIsReported() throws Exception {
    CompletableFuture<SceneWindow.End> told = new CompletableFuture<>();
    try (SceneWindow window = new SceneWindow(model, "test", 200, 150, told::complete)) {
      window.show();
      window.takeSnapshot(
          taken -> {
            throw new OutOfMemoryError("Direct buffer memory");
          });
      assertEquals(SceneWindow.End.FAILED, told.get(PATIENCE_S, TimeUnit.SECONDS));
    }
  }

  private static Picture picture(SceneWindow window) throws Exception {
    CompletableFuture<Picture> picture = new CompletableFuture<>();
    window.takeSnapshot(picture::complete);
    return picture.get(PATIENCE_S, TimeUnit.SECONDS);
  }
}
