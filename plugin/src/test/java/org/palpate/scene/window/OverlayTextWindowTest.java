package org.palpate.scene.window;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.scene.SceneLegend;
import org.palpate.scene.SceneModel;
import org.palpate.scene.Theme;
import org.palpate.scene.WorldAxes;

/** The text over a picture. */
class OverlayTextWindowTest {
  private final SceneModel model = new SceneModel(WorldAxes.UNKNOWN, Theme.DARK);

  @BeforeEach
  void display() {
    TestDisplay.require();
    model.add("none", 0x101010, RigidTransform.identity(), new Vec3(), new Vec3(9, 9, 9));
  }

  @ParameterizedTest
  @ValueSource(ints = {7, 8, 9, 10, 11, 12})
  void blanksLeaveNoBars(int blanks) throws Exception {
    model.setHelp(List.of(" ".repeat(blanks), "0".repeat(3) + " ".repeat(blanks)));
    try (OffscreenRenderer scene = new OffscreenRenderer(321 + blanks, 240, 1)) {
      Picture picture = scene.draw(model.state());
      int y = 120 - 8; // the first line
      for (int x = 0; x < picture.width(); x++) {
        assertTrue(green(picture, x, y) < 90, "a bar at " + x);
      }
    }
  }

  @ParameterizedTest
  @CsvSource({"1024,768", "640,480", "400,300", "240,180", "800,160", "200,600"})
  void theHelpFitsIntoThePicture(int width, int height) throws Exception {
    List<String> lines = new ArrayList<>();
    for (int n = 0; n < 24; n++) {
      lines.add("k   the action of key " + n);
    }
    lines.add("■■■■■");
    model.setHelp(lines);
    try (OffscreenRenderer scene = new OffscreenRenderer(width, height, 1)) {
      Picture picture = scene.draw(model.state());
      assertTrue(hasWhite(picture, 0, width, 0, height), "the last line is in the picture");
      assertTrue(!hasWhite(picture, 0, width, 0, 2) && !hasWhite(picture, 0, 2, 0, height));
    }
  }

  @ParameterizedTest
  @CsvSource({"1024,768", "240,180"})
  void theLegendShowsItsColoursInTheUpperRightCorner(int width, int height) throws Exception {
    model.add("green", 0x00ff00, RigidTransform.identity(), new Vec3(), new Vec3(9, 9, 9));
    SceneLegend legend = new SceneLegend(model);
    try (OffscreenRenderer scene = new OffscreenRenderer(width, height, 1)) {
      assertTrue(hasGreen(scene.draw(model.state()), width / 2, width, 0, height / 2));
      legend.select(1);
      legend.toggle();
      assertTrue(!hasGreen(scene.draw(model.state()), width / 2, width, 0, height / 2));
    }
  }

  private static boolean hasGreen(Picture picture, int left, int right, int top, int bottom) {
    for (int y = top; y < bottom; y++) {
      for (int x = left; x < right; x++) {
        if ((picture.rgb(x, y) & 0xffffff) == 0x00ff00) {
          return true;
        }
      }
    }
    return false;
  }

  /** Whether a block of the picture holds the inside of a letter that is a white square. */
  private static boolean hasWhite(Picture picture, int left, int right, int top, int bottom) {
    for (int y = top; y < bottom - 2; y++) {
      for (int x = left; x < right - 2; x++) {
        if (green(picture, x, y) > 200
            && green(picture, x + 1, y) > 200
            && green(picture, x, y + 1) > 200
            && green(picture, x + 1, y + 1) > 200) {
          return true;
        }
      }
    }
    return false;
  }

  private static int green(Picture picture, int x, int y) {
    return picture.rgb(x, y) >> 8 & 255;
  }
}
