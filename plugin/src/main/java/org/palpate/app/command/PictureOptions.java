package org.palpate.app.command;

import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.palpate.app.options.NumberRange;
import org.palpate.app.process.PalpateException;
import org.palpate.scene.SceneModel;
import org.palpate.scene.SceneObject;
import org.palpate.scene.SceneState;
import org.palpate.scene.StandardView;
import org.palpate.scene.Stereo;
import org.palpate.scene.Theme;
import org.palpate.scene.window.GraphicsException;
import org.palpate.scene.window.OffscreenRenderer;
import picocli.CommandLine.Option;

/** The options of a picture: its size, the camera and the colours. */
final class PictureOptions {
  private static final int SMOOTHING_SCALE = 2;
  private static final int MAX_EDGE_PIXELS = 8192;
  private static final NumberRange ZOOM =
      new NumberRange("--zoom", "the factor", 0.01, 1000, "", "2");

  @Option(
      names = "--size",
      paramLabel = "WxH",
      defaultValue = "1280x960",
      description = "Size of the picture in pixels. Default: ${DEFAULT-VALUE}.")
  private String size;

  @Option(
      names = "--view",
      paramLabel = "NAME",
      description = {
        "Direction of view: ${COMPLETION-CANDIDATES}.",
        "Default: oblique; with --trajectory, the view that faces the contact best."
      })
  private StandardView view;

  @Option(
      names = "--upside-down",
      description = "Turns the picture by half a turn, for a file whose axes point the wrong way.")
  private boolean upsideDown;

  @Option(
      names = "--zoom",
      paramLabel = "FACTOR",
      defaultValue = "1",
      description = "Moves the camera closer by this factor. Default: ${DEFAULT-VALUE}.")
  private double zoom;

  @Option(
      names = "--theme",
      paramLabel = "NAME",
      defaultValue = "dark",
      description = "Colours: ${COMPLETION-CANDIDATES}. Default: ${DEFAULT-VALUE}.")
  private Theme theme;

  @Option(
      names = "--opacity",
      paramLabel = "NAME=OPACITY",
      description = {
        "Opacity of a segment, 0 (hidden) to 1; may be repeated. Default: 1, but 0.3 for a"
            + " segment that encloses all others."
      })
  private Map<String, Double> opacities = new LinkedHashMap<>();

  @Option(
      names = "--stereo",
      paramLabel = "NAME",
      defaultValue = "off",
      description = "Stereo: off, anaglyph or side-by-side. Default: ${DEFAULT-VALUE}.",
      converter = StereoConverter.class)
  private Stereo stereo;

  private int width;
  private int height;

  /**
   * Refuses values that are out of range. Call it before the other methods.
   *
   * @throws PalpateException exit code 2
   */
  void check() {
    parseSize();
    ZOOM.check(zoom);
    opacities.forEach(PictureOptions::checkOpacity);
    if (stereo == Stereo.QUAD_BUFFER) {
      throw PalpateException.wrongUse(
          "a picture file has only one buffer",
          "--stereo quad-buffer",
          "try --stereo side-by-side");
    }
  }

  private void parseSize() {
    String[] parts = size.toLowerCase(Locale.ROOT).split("x", -1);
    try {
      width = Integer.parseInt(parts[0]);
      height = Integer.parseInt(parts[parts.length - 1]);
    } catch (NumberFormatException e) {
      width = 0;
    }
    boolean fits =
        width >= 16 && height >= 16 && width <= MAX_EDGE_PIXELS && height <= MAX_EDGE_PIXELS;
    if (parts.length != 2 || !fits) {
      throw PalpateException.wrongUse(
          "the size must be WxH with 16 to " + MAX_EDGE_PIXELS + " pixels each",
          "--size " + size,
          "try --size 1280x960");
    }
  }

  private static void checkOpacity(String name, double opacity) {
    if (!(opacity >= 0 && opacity <= 1)) {
      throw PalpateException.wrongUse(
          "the opacity must be a number from 0 to 1",
          "--opacity " + name + "=" + opacity,
          "try --opacity " + name + "=0.5");
    }
  }

  Theme theme() {
    return theme;
  }

  /** Returns the size as a text for the user. */
  String size() {
    return width + " x " + height + " pixels";
  }

  OffscreenRenderer newRenderer() throws GraphicsException {
    return new OffscreenRenderer(width, height, SMOOTHING_SCALE);
  }

  /**
   * Sets the camera, the opacities and the stereo mode of a scene, whose marks stand.
   *
   * @throws PalpateException exit code 2, if a segment is not there
   */
  void applyTo(SceneModel model) {
    model.look(chosenView(model.state()), (double) width / height);
    model.moveCamera(camera -> (upsideDown ? camera.upsideDown() : camera).zoom(1 / zoom), false);
    model.changeLook(look -> look.with(stereo));
    opacities.forEach((name, opacity) -> setOpacity(model, name, opacity));
  }

  private StandardView chosenView(SceneState state) {
    return Optional.ofNullable(view)
        .or(
            () ->
                state.marks().map(marks -> LastContactMarks.viewOf(marks.point(), state.middle())))
        .orElse(StandardView.OBLIQUE);
  }

  private static void setOpacity(SceneModel model, String name, double opacity) {
    SceneObject object =
        model.objects().stream()
            .filter(each -> each.name().equals(name))
            .findFirst()
            .orElseThrow(
                () ->
                    PalpateException.wrongUse(
                        "there is no such segment",
                        "--opacity " + name,
                        "list them with palpate info"));
    model.setOpacity(object, opacity);
  }
}
