package org.palpate.scene.gl;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.nio.FloatBuffer;
import org.palpate.geometry.Vec3;
import org.palpate.scene.Matrix4;
import org.palpate.scene.Palette;
import org.palpate.scene.SceneState;
import org.palpate.scene.TouchMarks;

/** The device, the interaction point, the spring between them, the force and the trail. */
final class MarkPainter {
  /** Radius of the interaction point's ball over the camera's distance. */
  private static final double POINT_SIZE = 0.0055;

  /** Length of the arrow of one newton over the camera's distance. */
  private static final double ARROW_SIZE = 0.035;

  private static final double LONGEST_ARROW = 0.2;

  /** How much of a mark shows through what hides it. */
  private static final double HIDDEN_OPACITY = 0.42;

  private final GlProgram program;
  private final StreamBuffer buffer;

  /** The device and the spring. */
  private final MarkMesh device = new MarkMesh();

  /** The interaction point, its trail and the force: on the surface, so never behind it. */
  private final MarkMesh point = new MarkMesh();

  MarkPainter(GL3 gl) {
    program = new GlProgram(gl, Shaders.MARK_VERTEX, Shaders.MARK_FRAGMENT);
    buffer = new StreamBuffer(gl, 3, 3, 4);
  }

  /** Draws the marks over a picture whose depth is there; what is hidden shows faintly. */
  void draw(GL3 gl, SceneState state, TouchMarks shown, Matrix4 toEye, Matrix4 projection) {
    double size = POINT_SIZE * state.camera().distanceMm();
    buildDevice(shown, size);
    buildPoint(shown, size, state.camera().distanceMm());
    program.use(gl);
    program.set(gl, "toEye", toEye);
    program.set(gl, "projection", projection);
    gl.glDisable(GL.GL_CULL_FACE);
    gl.glEnable(GL.GL_DEPTH_TEST);
    draw(gl, device, 0);
    draw(gl, point, state.detailMm());
  }

  /**
   * Draws some marks.
   *
   * @param nearerMm how much nearer to the eye they count as
   */
  private void draw(GL3 gl, MarkMesh marks, double nearerMm) {
    FloatBuffer vertices = marks.buffer();
    program.set(gl, "nearer", nearerMm);
    drawHidden(gl, vertices, marks.vertexCount());
    gl.glDepthMask(true);
    gl.glDepthFunc(GL.GL_LESS);
    program.set(gl, "opacity", 1.0);
    buffer.draw(gl, vertices, marks.vertexCount());
  }

  private void drawHidden(GL3 gl, FloatBuffer vertices, int count) {
    gl.glEnable(GL.GL_BLEND);
    gl.glBlendFunc(GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA);
    gl.glDepthFunc(GL.GL_GREATER);
    gl.glDepthMask(false);
    program.set(gl, "opacity", HIDDEN_OPACITY);
    buffer.draw(gl, vertices, count);
    gl.glDisable(GL.GL_BLEND);
  }

  private void buildDevice(TouchMarks shown, double size) {
    device.clear();
    double stretch = shown.device().sub(shown.point(), new Vec3()).length();
    if (stretch > 2 * size) {
      int turns = (int) Math.max(3, Math.min(14, stretch / size));
      device
          .colour(Palette.SPRING, 1)
          .spring(shown.point(), shown.device(), turns, 0.45 * size, 0.13 * size);
    }
    device.colour(Palette.DEVICE, 1).ball(shown.device(), 0.75 * size);
  }

  private void buildPoint(TouchMarks shown, double size, double distance) {
    point.clear();
    point.colour(Palette.TRAIL, 1).tube(shown.trail(), 0.28 * size);
    point.colour(Palette.POINT, 1).ball(shown.point(), size);
    double newton = shown.forceNewton().length();
    if (newton > 0) {
      double length = Math.min(ARROW_SIZE * newton, LONGEST_ARROW) * distance;
      Vec3 along = shown.forceNewton().mul(length / newton, new Vec3());
      Vec3 tip = along.add(shown.point(), along);
      point.colour(Palette.FORCE, 1).arrow(shown.point(), tip, 0.4 * size);
    }
  }

  void dispose(GL3 gl) {
    program.dispose(gl);
    buffer.dispose(gl);
  }
}
