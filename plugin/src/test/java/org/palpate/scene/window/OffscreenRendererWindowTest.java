package org.palpate.scene.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.scene.ClipPlane;
import org.palpate.scene.GreySlices;
import org.palpate.scene.NamedPoint;
import org.palpate.scene.SceneLoader;
import org.palpate.scene.SceneModel;
import org.palpate.scene.SceneObject;
import org.palpate.scene.SlicePlanes;
import org.palpate.scene.StandardView;
import org.palpate.scene.Stereo;
import org.palpate.scene.SurfaceTint;
import org.palpate.scene.Theme;
import org.palpate.scene.TouchMarks;
import org.palpate.scene.WorldAxes;
import org.palpate.scene.surface.SurfaceJob;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/** Checks pictures by characteristic pixels. */
class OffscreenRendererWindowTest {
  private static final int WIDTH = 320;
  private static final int HEIGHT = 240;
  private static final int EDGE = TwoBoxes.EDGE;

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
  void drawsASegmentInItsColourInFrontOfTheBackground() throws Exception {
    SceneModel model = TwoBoxes.model(WorldAxes.UNKNOWN, RigidTransform.identity());
    model.look(StandardView.FRONT, 4.0 / 3);
    Picture picture = scene.draw(model.state());
    assertTrue(isReddish(picture.rgb(WIDTH / 2 - 60, HEIGHT / 2)), "the box at low x is red");
    assertTrue(isBluish(picture.rgb(WIDTH / 2 + 60, HEIGHT / 2)), "the box at high x is blue");
    assertTrue(isDark(picture.rgb(2, 2)), "the corner is background");
  }

  @Test
  void aMirroringTransformMirrorsTheSegmentButNotTheLight() throws Exception {
    RigidTransform mirror =
        new RigidTransform(
            new Vec3(-1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1), new Vec3(EDGE, 0, 0));
    SceneModel model = TwoBoxes.model(WorldAxes.UNKNOWN, mirror);
    model.look(StandardView.FRONT, 4.0 / 3);
    Picture picture = scene.draw(model.state());
    int blue = picture.rgb(WIDTH / 2 - 60, HEIGHT / 2);
    assertTrue(isReddish(picture.rgb(WIDTH / 2 + 60, HEIGHT / 2)), "red is on the right now");
    assertTrue(isBluish(blue), "blue is on the left now");
    assertTrue(
        (blue & 255) > 90, "its outside is lit, not its inside: " + Integer.toHexString(blue));
  }

  @Test
  void theFrontViewHasThePatientsRightOnTheLeftForEveryWorld() throws Exception {
    for (WorldAxes axes : WorldAxes.values()) {
      SceneModel model = TwoBoxes.model(axes, RigidTransform.identity());
      model.look(StandardView.FRONT, 4.0 / 3);
      Picture picture = scene.draw(model.state());
      boolean lowXIsPatientsRight = axes != WorldAxes.RAS;
      int left = picture.rgb(WIDTH / 2 - 60, HEIGHT / 2);
      assertTrue(lowXIsPatientsRight ? isReddish(left) : isBluish(left), axes.toString());
    }
  }

  @Test
  void aHiddenSegmentIsNotDrawn() throws Exception {
    SceneModel model = TwoBoxes.model(WorldAxes.UNKNOWN, RigidTransform.identity());
    model.look(StandardView.FRONT, 4.0 / 3);
    model.setVisible(model.objects().get(0), false);
    Picture picture = scene.draw(model.state());
    assertTrue(isDark(picture.rgb(WIDTH / 2 - 60, HEIGHT / 2)));
    assertTrue(isBluish(picture.rgb(WIDTH / 2 + 60, HEIGHT / 2)));
  }

  @Test
  void aTintColoursASurfaceWhereItsValueIsKnown() throws Exception {
    SceneModel model = TwoBoxes.model(WorldAxes.UNKNOWN, RigidTransform.identity());
    model.look(StandardView.FRONT, 4.0 / 3);
    List<SurfaceTint.Sample> samples = new ArrayList<>();
    for (int n = 0; n < EDGE * EDGE * EDGE / 2; n++) { // the lower half of each box
      int row = n / EDGE;
      int layer = row / EDGE;
      Vec3 at = new Vec3(n % EDGE, row % EDGE, layer);
      samples.add(new SurfaceTint.Sample(at, 1));
    }
    SurfaceTint tint = SurfaceTint.of(samples, new Vec3(1, 1, 1));
    model.setTint(model.objects().get(0), Optional.of(tint));
    Picture picture = scene.draw(model.state());
    assertTrue(isYellow(picture.rgb(WIDTH / 2 - 60, HEIGHT / 2 + 20)), "the highest value below");
    assertTrue(isReddish(picture.rgb(WIDTH / 2 - 60, HEIGHT / 2 - 20)), "its own colour above");
    assertTrue(isBluish(picture.rgb(WIDTH / 2 + 60, HEIGHT / 2 + 20)), "the other one as before");
    model.setTint(model.objects().get(0), Optional.empty());
    assertTrue(isReddish(scene.draw(model.state()).rgb(WIDTH / 2 - 60, HEIGHT / 2 + 20)), "gone");
  }

  private static boolean isYellow(int rgb) {
    int red = rgb >> 16 & 255;
    int green = rgb >> 8 & 255;
    return red > 100 && green > 80 && (rgb & 255) < green / 2;
  }

  @Test
  void aClippingPlaneShowsTheInsideOfWhatItCuts() throws Exception {
    SceneModel model = TwoBoxes.model(WorldAxes.UNKNOWN, RigidTransform.identity());
    model.look(StandardView.FRONT, 4.0 / 3);
    Picture whole = scene.draw(model.state());
    Picture uncut = drawClippedAt(-1, model);
    assertEquals(0, differing(uncut, whole, 0, 0, WIDTH, HEIGHT), "all lies behind the plane");
    int outside = whole.rgb(WIDTH / 2 - 60, HEIGHT / 2);
    int inside = drawClippedAt(EDGE / 2.0, model).rgb(WIDTH / 2 - 60, HEIGHT / 2);
    assertTrue(isReddish(inside), Integer.toHexString(inside));
    assertTrue((inside >> 16) < (outside >> 16), "the inside is darker");
    int none = drawClippedAt(EDGE + 1, model).rgb(WIDTH / 2 - 60, HEIGHT / 2);
    assertTrue(isDark(none), "all lies before the plane");
  }

  private Picture drawClippedAt(double y, SceneModel model) throws GraphicsException {
    model.clip(new ClipPlane.Start(ClipPlane.Direction.Y, OptionalDouble.of(y)));
    return scene.draw(model.state());
  }

  @Test
  void slicesShowTheGreyValuesOfTheirVoxels() throws Exception {
    SceneModel model = TwoBoxes.model(WorldAxes.UNKNOWN, RigidTransform.identity());
    model.look(StandardView.FRONT, 4.0 / 3);
    model.objects().forEach(object -> model.setVisible(object, false));
    ScalarVolume values =
        ScalarVolume.of(VoxelGrid.ofUnitVoxels(EDGE, EDGE, EDGE), ScalarVolume.Storage.UINT8);
    for (int k = 0; k < EDGE; k++) {
      for (int n = 0; n < EDGE * EDGE; n++) {
        values.set(n % EDGE, n / EDGE, k, n % EDGE < EDGE / 2 ? 200 : 20); // bright at low x
      }
    }
    SlicePlanes planes = new GreySlices(values).through(-1, EDGE / 2, -1, model);
    model.changeLook(look -> look.with(Optional.of(planes)));
    Picture picture = scene.draw(model.state());
    assertTrue((picture.rgb(WIDTH / 2 - 40, HEIGHT / 2) & 255) > 200, "bright at low x");
    assertTrue(isDark(picture.rgb(WIDTH / 2 + 40, HEIGHT / 2)), "black is not drawn at high x");
    model.changeLook(look -> look.with(Optional.<SlicePlanes>empty()));
    assertTrue(isDark(scene.draw(model.state()).rgb(WIDTH / 2 - 40, HEIGHT / 2)), "gone");
  }

  @Test
  void staticPartsAreDrawnOnceWhileTheDeviceMoves() throws Exception {
    SceneModel model = TwoBoxes.model(WorldAxes.UNKNOWN, RigidTransform.identity());
    model.look(StandardView.FRONT, 4.0 / 3);
    scene.draw(model.state());
    for (int i = 0; i < 5; i++) {
      model.setMarks(Optional.of(marksAt(new Vec3(i, -4, 12))));
      scene.draw(model.state());
    }
    assertEquals(5, scene.staticReused());
    model.moveCamera(camera -> camera.orbit(0.1, 0), false);
    scene.draw(model.state());
    assertEquals(5, scene.staticReused());
  }

  @Test
  void drawsTheInteractionPointAtItsPosition() throws Exception {
    SceneModel model = TwoBoxes.model(WorldAxes.UNKNOWN, RigidTransform.identity());
    model.look(StandardView.FRONT, 4.0 / 3);
    model.setMarks(Optional.of(marksAt(new Vec3(12, -2, 12))));
    int rgb = scene.draw(model.state()).rgb(WIDTH / 2, HEIGHT / 2);
    assertTrue(((rgb >> 16) & 255) > 2 * (rgb & 255), "orange: " + Integer.toHexString(rgb));
  }

  @Test
  void drawsALandmarkAtItsPositionWithItsNameBesideIt() throws Exception {
    SceneModel model = TwoBoxes.model(WorldAxes.UNKNOWN, RigidTransform.identity());
    model.look(StandardView.FRONT, 4.0 / 3);
    Picture without = scene.draw(model.state());
    model.setLandmarks(List.of(new NamedPoint("tip", new Vec3(12, -2, 12))));
    Picture with = scene.draw(model.state());
    int rgb = with.rgb(WIDTH / 2, HEIGHT / 2);
    int green = (rgb >> 8) & 255;
    assertTrue((rgb & 255) > green && ((rgb >> 16) & 255) > green, Integer.toHexString(rgb));
    int right = WIDTH / 2 + 8;
    int low = HEIGHT / 2 + 12;
    assertTrue(differing(with, without, right, HEIGHT / 2 - 12, right + 40, low) > 30, "a name");
    assertEquals(0, differing(with, without, 0, 0, WIDTH / 2 - 12, HEIGHT));
    model.setLandmarks(List.of());
    assertEquals(0, differing(scene.draw(model.state()), without, 0, 0, WIDTH, HEIGHT));
  }

  @Test
  void aPointLessThanAVoxelBehindTheSurfaceIsVisibleAndOneFartherBehindIsFaint() throws Exception {
    SceneModel model = TwoBoxes.model(WorldAxes.UNKNOWN, RigidTransform.identity());
    model.look(StandardView.FRONT, 4.0 / 3);
    scene.draw(model.state());
    Vec3 surface =
        scene.pick(model.state(), WIDTH / 2.0 - 60, HEIGHT / 2.0).orElseThrow().surfaceMm();
    int justBehind = orange(model, surface.add(new Vec3(0, 0.9, 0), new Vec3()));
    int farBehind = orange(model, surface.add(new Vec3(0, 3, 0), new Vec3()));
    assertTrue(justBehind > farBehind + 30, justBehind + " " + farBehind);
  }

  /** Returns how orange the middle of the interaction point's ball is. */
  private int orange(SceneModel model, Vec3 point) {
    model.setMarks(Optional.of(marksAt(point)));
    int rgb = scene.draw(model.state()).rgb(WIDTH / 2 - 60, HEIGHT / 2);
    return ((rgb >> 8) & 255) - (rgb & 255);
  }

  @Test
  void lettersAreShownIfTheAxesAreKnown() throws Exception {
    Picture with = lettered(WorldAxes.LPS);
    Picture without = lettered(WorldAxes.UNKNOWN);
    assertTrue(differing(with, without, 0, HEIGHT / 2, WIDTH / 2, HEIGHT) > 30);
    assertEquals(0, differing(with, without, WIDTH / 2, 0, WIDTH, HEIGHT));
  }

  private Picture lettered(WorldAxes axes) throws Exception {
    SceneModel model = TwoBoxes.model(axes, RigidTransform.identity());
    model.look(StandardView.FRONT, 4.0 / 3);
    return scene.draw(model.state());
  }

  @Test
  void theTwoEyesSeeDifferentPictures() throws Exception {
    SceneModel model = TwoBoxes.model(WorldAxes.UNKNOWN, RigidTransform.identity());
    model.look(StandardView.OBLIQUE, 4.0 / 3);
    model.changeLook(look -> look.with(Stereo.SIDE_BY_SIDE));
    Picture pair = scene.draw(model.state());
    int differing = 0;
    for (int y = 0; y < HEIGHT; y++) {
      for (int x = 0; x < WIDTH / 2; x++) {
        differing += pair.rgb(x, y) == pair.rgb(x + WIDTH / 2, y) ? 0 : 1;
      }
    }
    assertTrue(differing > 100, "pixels that differ: " + differing);
    model.changeLook(look -> look.with(Stereo.ANAGLYPH));
    assertNotEquals(pair.rgb(WIDTH / 2, HEIGHT / 2), scene.draw(model.state()).rgb(10, 10));
  }

  @Test
  void aTranslucentSegmentShowsTheOneBehindIt() throws Exception {
    SceneModel model = TwoBoxes.model(WorldAxes.UNKNOWN, RigidTransform.identity());
    model.look(StandardView.LEFT, 4.0 / 3);
    int before = scene.draw(model.state()).rgb(WIDTH / 2, HEIGHT / 2);
    assertTrue(isBluish(before), "blue hides red from the left: " + Integer.toHexString(before));
    model.setOpacity(model.objects().get(1), 0.3);
    int through = scene.draw(model.state()).rgb(WIDTH / 2, HEIGHT / 2);
    assertTrue(isReddish(through), Integer.toHexString(through));
  }

  @Test
  void aGhostIsDrawnFaintlyWhereItStandsAndTheSegmentsBehindItAreSeen() throws Exception {
    RigidTransform lower = RigidTransform.identity();
    lower.origin().set(0, 0, -EDGE);
    SegmentedVolume below = TwoBoxes.volume(lower);
    SceneModel model = new SceneModel(WorldAxes.UNKNOWN, Theme.DARK);
    try (SceneLoader loader =
        new SceneLoader(model, TwoBoxes.volume(RigidTransform.identity()), 1)) {
      loader.addGhosts(
          new SegmentedVolume(
              below.grid(),
              List.of(new Segment("ghost", below.segments().get(0).bits(), TwoBoxes.BLUE))));
      loader.await(60_000);
      assertEquals(2, loader.weldedSurfaces().size(), "a ghost is no segment of the loader");
    }
    model.look(StandardView.FRONT, 4.0 / 3);
    SceneObject ghost = model.objects().get(2);
    Picture shown = scene.draw(model.state());
    model.setVisible(ghost, false);
    Picture without = scene.draw(model.state());
    model.setVisible(ghost, true);
    model.setOpacity(ghost, 1);
    Picture opaque = scene.draw(model.state());
    int upper = differing(shown, without, 0, 0, WIDTH, HEIGHT / 2);
    int lowerHalf = differing(shown, without, 0, HEIGHT / 2, WIDTH, HEIGHT);
    assertTrue(upper < 10 && lowerHalf > 1000, upper + " and " + lowerHalf + " pixels differ");
    assertTrue(differing(shown, opaque, 0, HEIGHT / 2, WIDTH, HEIGHT) > 1000, "it is faint");
  }

  @Test
  void anEditAppearsInTheNextPicture() throws Exception {
    SegmentedVolume volume = TwoBoxes.volume(RigidTransform.identity());
    SceneModel model = new SceneModel(WorldAxes.UNKNOWN, Theme.DARK);
    try (SceneLoader loader = new SceneLoader(model, volume, 1)) {
      loader.await(60_000);
      model.look(StandardView.FRONT, 4.0 / 3);
      scene.draw(model.state());
      BitCube red = volume.segments().get(0).bits();
      IntBox edited = new IntBox();
      edited.set(red.bounds());
      for (int k = 0; k < EDGE; k++) {
        for (int j = 0; j < EDGE; j++) {
          for (int i = 0; i < EDGE; i++) {
            red.clear(i, j, k);
          }
        }
      }
      for (SurfaceJob level : loader.remesh(0, edited)) {
        level.await(60_000);
      }
    }
    assertTrue(isDark(scene.draw(model.state()).rgb(WIDTH / 2 - 60, HEIGHT / 2)));
    for (int level = 0; level < SceneObject.LEVELS; level++) {
      assertEquals(0, model.objects().get(0).triangleCount(level), "level " + level);
    }
  }

  private static int differing(Picture a, Picture b, int left, int top, int right, int bottom) {
    int count = 0;
    for (int y = top; y < bottom; y++) {
      for (int x = left; x < right; x++) {
        count += a.rgb(x, y) == b.rgb(x, y) ? 0 : 1;
      }
    }
    return count;
  }

  private static TouchMarks marksAt(Vec3 point) {
    return new TouchMarks(point, point, new Vec3(), false, List.of());
  }

  private static boolean isReddish(int rgb) {
    return ((rgb >> 16) & 255) > 1.3 * (rgb & 255) + 10;
  }

  private static boolean isBluish(int rgb) {
    return (rgb & 255) > 1.3 * ((rgb >> 16) & 255) + 10;
  }

  private static boolean isDark(int rgb) {
    return ((rgb >> 16) & 255) < 60 && ((rgb >> 8) & 255) < 60 && (rgb & 255) < 70;
  }
}
