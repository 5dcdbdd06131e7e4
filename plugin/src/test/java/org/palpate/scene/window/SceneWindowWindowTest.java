package org.palpate.scene.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.scene.Palette;
import org.palpate.scene.SceneModel;
import org.palpate.scene.StandardView;
import org.palpate.scene.Theme;
import org.palpate.scene.WorldAxes;

class SceneWindowWindowTest {
  private static final long PATIENCE_S = 60;

  private final SceneModel model = new SceneModel(WorldAxes.LPS, Theme.LIGHT);

  @BeforeEach
  void display() {
    TestDisplay.require();
    model.add("none", Palette.BONE, RigidTransform.identity(), new Vec3(), new Vec3(9, 9, 9));
  }

  @Test
  void drawsWhenAskedAndGivesASnapshot() throws Exception {
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
  void aDrawingThatFailsIsToldOnceAndTheModelGoesOn() throws Exception {
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
  void closingTwiceDoesNoHarmAndTellsNoOne() throws Exception {
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
    drawsWhenAskedAndGivesASnapshot();
  }
}
