package org.palpate.scene.gl;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.util.List;
import org.palpate.geometry.Vec3;
import org.palpate.scene.Camera;
import org.palpate.scene.Matrix4;
import org.palpate.scene.NamedPoint;
import org.palpate.scene.SceneState;
import org.palpate.scene.Theme;
import org.palpate.scene.WorldAxes;

/**
 * Draws the text in the corner, the help in the middle, the names of landmarks and the letters of
 * the patient's directions.
 */
final class OverlayPainter {
  private static final int TEXT_PIXELS = 14;
  private static final int TRIAD_HALF_PIXELS = 34;

  /** Least length of a projected axis; a letter on a shorter one would cover the others. */
  private static final double MIN_AXIS_LENGTH = 0.28;

  private final GlProgram program;
  private final StreamBuffer buffer;
  private final OverlayBatch batch = new OverlayBatch();
  private GlyphAtlas atlas;
  private int atlasPixels;

  /** Compiles the program. */
  OverlayPainter(GL3 gl) {
    program = new GlProgram(gl, Shaders.FLAT_VERTEX, Shaders.FLAT_FRAGMENT);
    buffer = new StreamBuffer(gl, 2, 2, 4);
  }

  /**
   * Draws all text.
   *
   * @param toPicture transform from the scene to the picture, -1 to 1 in both directions
   * @param scale pixels of the picture for one pixel of the text
   */
  void draw(GL3 gl, SceneState state, Matrix4 toPicture, int width, int height, double scale) {
    prepareAtlas(gl, (int) Math.round(TEXT_PIXELS * scale));
    batch.clear();
    names(state, toPicture, width, height, scale);
    lines(state.overlay(), state.look().theme(), 14 * scale, 12 * scale, scale);
    if (state.look().axes().hasLetters()) {
      triad(state.camera(), state.look().theme(), 58 * scale, height - 58 * scale, scale);
    }
    help(state, width, height, scale);
    send(gl, width, height);
  }

  private void prepareAtlas(GL3 gl, int pixels) {
    if (atlas == null || pixels != atlasPixels) {
      if (atlas != null) {
        atlas.dispose(gl);
      }
      atlas = new GlyphAtlas(gl, pixels);
      atlasPixels = pixels;
    }
  }

  private void lines(List<String> lines, Theme theme, double x, double y, double scale) {
    double at = y;
    for (String line : lines) {
      batch.colour(theme.text(), 0.92);
      atlas.add(batch, line, x, at);
      at += atlas.lineHeight() + 2 * scale;
    }
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

  private void help(SceneState state, int width, int height, double scale) {
    List<String> lines = state.help();
    if (lines.isEmpty()) {
      return;
    }
    int widest = lines.stream().mapToInt(atlas::width).max().orElse(0);
    double step = atlas.lineHeight() + 3 * scale;
    double left = (width - widest) / 2.0;
    double top = (height - lines.size() * step) / 2;
    double edge = 22 * scale;
    batch.colour(state.look().theme().below(), 0.86);
    batch.panel(left - edge, top - edge, left + widest + edge, top + lines.size() * step + edge);
    for (String line : lines) {
      batch.colour(state.look().theme().text(), 1);
      atlas.add(batch, line, left, top);
      top += step;
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
    if (atlas != null) {
      atlas.dispose(gl);
    }
    program.dispose(gl);
    buffer.dispose(gl);
  }
}
