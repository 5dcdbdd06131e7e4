package org.palpate.scene.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.scene.Camera;
import org.palpate.scene.Matrix4;
import org.palpate.scene.SceneLoader;
import org.palpate.scene.SceneModel;
import org.palpate.scene.StandardView;
import org.palpate.scene.Stereo;
import org.palpate.scene.Theme;
import org.palpate.scene.WorldAxes;
import org.palpate.scene.gl.PickedPoint;

/** Checks which point of a scene a pixel shows. */
class PickedPointWindowTest {
  private static final int WIDTH = 320;
  private static final int HEIGHT = 240;

  private OffscreenRenderer scene;

  @BeforeEach
  void open() throws GraphicsException {
    TestDisplay.require();
    scene = new OffscreenRenderer(WIDTH, HEIGHT, 1);
  }

  @AfterEach
  void close() {
    if (scene != null) {
      scene.close();
    }
  }

  @Test
  void aPickedPixelIsAPointOfTheSurface() throws Exception {
    SceneModel model = TwoBoxes.model(WorldAxes.UNKNOWN, RigidTransform.identity());
    model.look(StandardView.FRONT, 4.0 / 3);
    scene.draw(model.state());
    Vec3 place = picked(model, WIDTH / 2.0 - 60, HEIGHT / 2.0).surfaceMm();
    assertEquals(8, place.y, 0.2, "the boxes begin at y = 8");
    assertTrue(place.x > 2 && place.x < 9, place.toString());
    assertTrue(scene.pick(model.state(), 2, 2).isEmpty(), "the background is no place");
  }

  private PickedPoint picked(SceneModel model, double x, double y) throws Exception {
    return scene.pick(model.state(), x, y).orElseThrow();
  }

  @ParameterizedTest
  @EnumSource(
      value = Stereo.class,
      names = {"ANAGLYPH", "SIDE_BY_SIDE"})
  void inStereoAPickedPixelIsWhatItsEyeSees(Stereo stereo) throws Exception {
    SceneModel model = TwoBoxes.model(WorldAxes.UNKNOWN, RigidTransform.identity());
    model.look(StandardView.FRONT, 4.0 / 3);
    model.changeLook(look -> look.with(stereo));
    scene.draw(model.state());
    Camera camera = model.state().camera();
    int found = 0;
    for (int x = 4; x < WIDTH; x += 7) {
      for (int y = 4; y < HEIGHT; y += 7) {
        Optional<PickedPoint> picked = scene.pick(model.state(), x, y);
        if (picked.isPresent()) {
          found++;
          assertShownAt(x, y, picked.get(), model, stereo);
          assertInFaceOfABox(picked.get().surfaceMm());
        }
      }
    }
    assertTrue(found > 100, "found=" + found + " " + camera.eye());
  }

  /** Checks by projection, as the picture was drawn, that the eye sees a point at a pixel. */
  private static void assertShownAt(
      int x, int y, PickedPoint picked, SceneModel model, Stereo stereo) {
    boolean halves = stereo == Stereo.SIDE_BY_SIDE;
    int width = halves ? WIDTH / 2 : WIDTH;
    int eye = halves && x >= width ? 1 : -1;
    Camera camera = model.state().camera();
    Matrix4 toPicture =
        camera
            .perspective(
                eye, (double) width / HEIGHT, model.state().middle(), model.state().radiusMm())
            .times(camera.view(eye));
    Vec3 shown = new Vec3();
    toPicture.project(picked.surfaceMm(), shown);
    assertEquals(x % width + 0.5, (shown.x + 1) / 2 * width, 1e-6);
    assertEquals(y + 0.5, (1 - shown.y) / 2 * HEIGHT, 1e-6);
    double apart = picked.eyeMm().sub(camera.eye(), new Vec3()).dot(camera.right());
    assertEquals(eye, Math.signum(apart));
  }

  /** A wrong line of sight would end beside or behind the boxes. */
  private static void assertInFaceOfABox(Vec3 surface) {
    boolean inX = (surface.x > 1.7 && surface.x < 11.3) || (surface.x > 12.7 && surface.x < 22.3);
    boolean inY = surface.y > 7.7 && surface.y < 16.3;
    boolean inZ = surface.z > 3.7 && surface.z < 20.3;
    assertTrue(inX && inY && inZ, surface.toString());
  }

  @ParameterizedTest
  @EnumSource(
      value = Stereo.class,
      names = {"OFF", "SIDE_BY_SIDE"})
  void aPickedPixelIsThatOfTheSegmentBehindGhosts(Stereo stereo) throws Exception {
    RigidTransform nearer = RigidTransform.identity();
    nearer.origin().set(0, -TwoBoxes.EDGE, 0);
    SceneModel model = new SceneModel(WorldAxes.UNKNOWN, Theme.DARK);
    try (SceneLoader loader =
        new SceneLoader(model, TwoBoxes.volume(RigidTransform.identity()), 1)) {
      loader.addGhosts(TwoBoxes.volume(nearer));
      loader.await(60_000);
    }
    model.look(StandardView.FRONT, 4.0 / 3);
    model.changeLook(look -> look.with(stereo));
    List<Optional<PickedPoint>> withGhosts = picks(model);
    model.setGhost(model.objects().get(0), Optional.of(nearer));
    List<Optional<PickedPoint>> withStartingPose = picks(model);
    model.setGhost(model.objects().get(0), Optional.empty());
    model.setVisible(model.objects().get(2), false);
    model.setVisible(model.objects().get(3), false);
    List<Optional<PickedPoint>> without = picks(model);
    assertSamePoints(without, withGhosts);
    assertSamePoints(without, withStartingPose);
  }

  private List<Optional<PickedPoint>> picks(SceneModel model) throws Exception {
    scene.draw(model.state());
    List<Optional<PickedPoint>> picks = new ArrayList<>();
    for (int x = 3; x < WIDTH; x += 6) {
      for (int y = 3; y < HEIGHT; y += 6) {
        picks.add(scene.pick(model.state(), x, y));
      }
    }
    return picks;
  }

  /** Checks that all points agree but those of pixels at edges, which lie elsewhere in a pixel. */
  private static void assertSamePoints(
      List<Optional<PickedPoint>> expected, List<Optional<PickedPoint>> found) {
    int met = 0;
    int differing = 0;
    for (int n = 0; n < expected.size(); n++) {
      Optional<PickedPoint> one = expected.get(n);
      Optional<PickedPoint> other = found.get(n);
      met += one.isPresent() ? 1 : 0;
      boolean isSame =
          one.isPresent() == other.isPresent()
              && (one.isEmpty()
                  || one.get().surfaceMm().sub(other.get().surfaceMm(), new Vec3()).length() < 0.2);
      differing += isSame ? 0 : 1;
    }
    assertTrue(met > 100, "met " + met);
    assertTrue(differing <= met / 50, differing + " of " + met + " differ");
  }
}
