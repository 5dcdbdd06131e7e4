package org.palpate.scene.gl;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.palpate.geometry.Vec3;
import org.palpate.scene.Camera;
import org.palpate.scene.Matrix4;
import org.palpate.scene.NamedPoint;
import org.palpate.scene.SceneState;
import org.palpate.scene.SceneState.LegendEntry;
import org.palpate.scene.Theme;
import org.palpate.scene.WorldAxes;

/**
 * Draws the text in the corner, the legend, the help in the middle, the names of landmarks and the
 * letters of the patient's directions. Small pictures have smaller text.
 */
final class OverlayPainter {
  private static final int TEXT_PIXELS = 14;
  private static final int TRIAD_HALF_PIXELS = 34;

  /** Least length of a projected axis; a letter on a shorter one would cover the others. */
  private static final double MIN_AXIS_LENGTH = 0.28;

  /** Sizes of text that are tried, the largest first, relative to the usual one. */
  private static final double[] SIZES = {1, 0.85, 0.72, 0.6};

  /** Edges of a picture in which the usual size fits, in pixels of the text. */
  private static final int COMFORTABLE_WIDTH = 480;

  private static final int COMFORTABLE_HEIGHT = 320;

  /** Edge of the square that shows a segment's colour, relative to the height of a line. */
  private static final double SWATCH_HEIGHT = 0.7;

  private final GlProgram program;
  private final StreamBuffer buffer;
  private final OverlayBatch batch = new OverlayBatch();
  private final Map<Integer, GlyphAtlas> atlases = new HashMap<>();
  private GlyphAtlas atlas;

  /** The legend as it was last drawn. Written by the drawing thread. */
  private volatile LegendArea legend = LegendArea.NONE;

  /** Compiles the program. */
  OverlayPainter(GL3 gl) {
    program = new GlProgram(gl, Shaders.FLAT_VERTEX, Shaders.FLAT_FRAGMENT);
    buffer = new StreamBuffer(gl, 2, 2, 4);
  }

  /** Returns the legend as it was last drawn. Any thread. */
  LegendArea legend() {
    return legend;
  }

  /**
   * Draws all text.
   *
   * @param toPicture transform from the scene to the picture, -1 to 1 in both directions
   * @param scale pixels of the picture for one pixel of the text
   */
  void draw(GL3 gl, SceneState state, Matrix4 toPicture, int width, int height, double scale) {
    double fit = Math.min(width / scale / COMFORTABLE_WIDTH, height / scale / COMFORTABLE_HEIGHT);
    double small = scale * Math.max(SIZES[SIZES.length - 1], Math.min(1, fit));
    useSize(gl, small);
    batch.clear();
    names(state, toPicture, width, height, small);
    double legendWidth = legend(state, width, height, small);
    lines(state, width - legendWidth, height, small);
    if (state.look().axes().hasLetters()) {
      triad(state.camera(), state.look().theme(), 58 * small, height - 58 * small, small);
    }
    send(gl, width, height);
    if (!state.help().isEmpty()) {
      help(gl, state, width, height, scale);
    }
  }

  private void useSize(GL3 gl, double scale) {
    int pixels = (int) Math.max(6, Math.round(TEXT_PIXELS * scale));
    atlas = atlases.computeIfAbsent(pixels, size -> new GlyphAtlas(gl, size));
  }

  /** Adds the lines in the corner, broken where the picture ends. */
  private void lines(SceneState state, double width, int height, double scale) {
    double y = 12 * scale;
    double step = atlas.lineHeight() + 2 * scale;
    List<String> shown = state.overlay().stream().filter(line -> !line.isEmpty()).toList();
    for (String line : TextColumns.wrap(shown, atlas::width, width - 28 * scale)) {
      if (y + step <= height) {
        text(state.look().theme(), line, 14 * scale, y, scale);
      }
      y += step;
    }
  }

  /** Adds text with a shadow, so that it is legible on a bright surface too. */
  private void text(Theme theme, String line, double x, double y, double scale) {
    double shift = Math.max(1, Math.rint(scale));
    batch.colour(theme.below(), 0.75);
    atlas.add(batch, line, x + shift, y + shift);
    batch.colour(theme.text(), 0.95);
    atlas.add(batch, line, x, y);
  }

  /** Adds the legend at the right edge and returns its width. */
  private double legend(SceneState state, int width, int height, double scale) {
    List<LegendEntry> entries = state.legend();
    double step = atlas.lineHeight() + 4 * scale;
    int rows = (int) Math.min(entries.size(), Math.floor((height - 24 * scale) / step));
    if (rows <= 0) {
      legend = LegendArea.NONE;
      return 0;
    }
    double swatch = swatch();
    double widest = entries.stream().mapToInt(entry -> atlas.width(entry.name())).max().orElse(0);
    double all = Math.min(widest + swatch + 36 * scale, width / 2.0);
    int selected =
        IntStream.range(0, entries.size()).filter(n -> entries.get(n).selected()).max().orElse(0);
    int first = Math.max(0, Math.min(selected - rows / 2, entries.size() - rows));
    double left = width - all;
    double top = 12 * scale;
    for (int row = 0; row < rows; row++) {
      entry(state.look().theme(), entries.get(first + row), left, top + row * step, all, scale);
    }
    legend = new LegendArea(left, top, step, swatch + 12 * scale, first, rows);
    return all;
  }

  private void entry(
      Theme theme, LegendEntry entry, double left, double y, double width, double scale) {
    double swatch = swatch();
    double x = left + 4 * scale;
    double middle = y + atlas.lineHeight() / 2.0;
    if (entry.selected()) {
      batch.colour(theme.quiet(), 0.35);
      batch.panel(left, y - 2 * scale, left + width - 8 * scale, y + atlas.lineHeight());
    }
    batch.colour(entry.rgb(), entry.visible() ? 1 : 0.3);
    batch.panel(x, middle - swatch / 2, x + swatch, middle + swatch / 2);
    String name = shortened(entry.name(), width - swatch - 28 * scale);
    text(theme, name, x + swatch + 8 * scale, y, scale);
    if (!entry.visible()) {
      batch.colour(theme.text(), 0.9);
      double end = x + swatch + 8 * scale + atlas.width(name);
      batch.line(x, middle, end, middle, Math.max(1, scale));
    }
  }

  /** Returns the edge of the square that shows a segment's colour, pixels. */
  private double swatch() {
    return SWATCH_HEIGHT * atlas.lineHeight();
  }

  private String shortened(String name, double width) {
    String shown = name;
    while (shown.length() > 1 && atlas.width(shown) > width) {
      shown = shown.substring(0, shown.length() - 2) + "…";
    }
    return shown;
  }

  /** Adds the name of each landmark beside it. */
  private void names(SceneState state, Matrix4 toPicture, int width, int height, double scale) {
    Vec3 at = new Vec3();
    for (NamedPoint mark : state.landmarks()) {
      if (toPicture.project(mark.position(), at) > 0) {
        double x = (1 + at.x) / 2 * width + 10 * scale;
        double y = (1 - at.y) / 2 * height - atlas.lineHeight() / 2.0;
        batch.colour(state.look().theme().below(), 0.7);
        batch.panel(
            x - 3 * scale, y, x + atlas.width(mark.name()) + 3 * scale, y + atlas.lineHeight());
        batch.colour(state.look().theme().text(), 1);
        atlas.add(batch, mark.name(), x, y);
      }
    }
  }

  /** Draws the help in the largest size and the fewest columns that fit. */
  private void help(GL3 gl, SceneState state, int width, int height, double scale) {
    double gap = 0;
    double edge = 0;
    double step = 0;
    TextColumns columns = null;
    for (int n = 0; n < SIZES.length && (columns == null || !columns.fits()); n++) {
      double size = scale * SIZES[n];
      useSize(gl, size);
      gap = 26 * size;
      edge = 14 * size;
      step = atlas.lineHeight() + 2 * size;
      columns =
          TextColumns.of(
              state.help(), atlas::width, step, gap, width - 2 * edge, height - 2 * edge);
    }
    batch.clear();
    help(state, columns, width, height, step, gap, edge);
    send(gl, width, height);
  }

  private void help(
      SceneState state,
      TextColumns columns,
      int width,
      int height,
      double step,
      double gap,
      double edge) {
    double wide = Math.min(columns.totalWidth(gap), width - 2 * edge);
    double high = Math.min(columns.rows() * step, height - 2 * edge);
    double left = (width - wide) / 2;
    double top = (height - high) / 2;
    batch.colour(state.look().theme().below(), 0.9);
    batch.panel(left - edge, top - edge, left + wide + edge, top + high + edge);
    batch.colour(state.look().theme().text(), 1);
    for (int n = 0; n < state.help().size(); n++) {
      int row = n % columns.rows();
      if (row == 0 && n > 0) {
        left += columns.widths().get(n / columns.rows() - 1) + gap;
      }
      if (top + (row + 1) * step <= height) {
        atlas.add(batch, state.help().get(n), left, top + row * step);
      }
    }
  }

  /**
   * Adds both ends of each axis as the camera sees them, with their letters. Nearer ends are
   * brighter.
   */
  private void triad(Camera camera, Theme theme, double x, double y, double scale) {
    double half = TRIAD_HALF_PIXELS * scale;
    for (int i = 0; i < 6; i++) {
      int axis = i >> 1;
      boolean positive = (i & 1) == 0;
      Vec3 direction = new Vec3();
      direction.set(axis, positive ? 1 : -1);
      double right = direction.dot(camera.right());
      double up = direction.dot(camera.up());
      double near = direction.dot(camera.back());
      double length = Math.hypot(right, up);
      if (length > MIN_AXIS_LENGTH) {
        double strength = 0.75 + 0.25 * near;
        batch.colour(theme.quiet(), 0.8 * strength);
        batch.line(x, y, x + half * right, y - half * up, 1.6 * scale);
        String letter = WorldAxes.letter(axis, positive);
        double reach = half + 11 * scale / length;
        double atX = x + reach * right - atlas.width(letter) / 2.0;
        double atY = y - reach * up - atlas.lineHeight() / 2.0;
        batch.colour(theme.text(), strength);
        atlas.add(batch, letter, atX, atY);
      }
    }
  }

  private void send(GL3 gl, int width, int height) {
    gl.glDisable(GL.GL_DEPTH_TEST);
    gl.glEnable(GL.GL_BLEND);
    gl.glBlendFunc(GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA);
    gl.glActiveTexture(GL.GL_TEXTURE0);
    gl.glBindTexture(GL.GL_TEXTURE_2D, atlas.texture());
    program.use(gl);
    program.set(gl, "size", width, height);
    program.set(gl, "atlas", 0);
    buffer.draw(gl, batch.buffer(), batch.vertexCount());
    gl.glDisable(GL.GL_BLEND);
    gl.glEnable(GL.GL_DEPTH_TEST);
  }

  /** Releases the program and the glyphs. */
  void dispose(GL3 gl) {
    atlases.values().forEach(each -> each.dispose(gl));
    atlases.clear();
    program.dispose(gl);
    buffer.dispose(gl);
  }
}
