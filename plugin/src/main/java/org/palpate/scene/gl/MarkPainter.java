package org.palpate.scene.gl;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.nio.FloatBuffer;
import java.util.List;
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
  private final MarkMesh mesh = new MarkMesh();

  MarkPainter(GL3 gl) {
    program = new GlProgram(gl, Shaders.MARK_VERTEX, Shaders.MARK_FRAGMENT);
    buffer = new StreamBuffer(gl, 3, 3, 4);
  }

  /** Draws the marks over a picture whose depth is there; what is hidden shows faintly. */
  void draw(GL3 gl, SceneState state, TouchMarks marks, Matrix4 toEye, Matrix4 projection) {
    build(marks, state.camera().distanceMm());
    FloatBuffer vertices = mesh.buffer();
    program.use(gl);
    program.set(gl, "toEye", toEye);
    program.set(gl, "projection", projection);
    gl.glDisable(GL.GL_CULL_FACE);
    gl.glEnable(GL.GL_DEPTH_TEST);
    drawHidden(gl, vertices);
    gl.glDepthMask(true);
    gl.glDepthFunc(GL.GL_LESS);
    program.set(gl, "opacity", 1.0);
    buffer.draw(gl, vertices, mesh.vertexCount());
  }

  private void drawHidden(GL3 gl, FloatBuffer vertices) {
    gl.glEnable(GL.GL_BLEND);
    gl.glBlendFunc(GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA);
    gl.glDepthFunc(GL.GL_GREATER);
    gl.glDepthMask(false);
    program.set(gl, "opacity", HIDDEN_OPACITY);
    buffer.draw(gl, vertices, mesh.vertexCount());
    gl.glDisable(GL.GL_BLEND);
  }

  private void build(TouchMarks marks, double distance) {
    double size = POINT_SIZE * distance;
    mesh.clear();
    List<Vec3> trail = marks.trail();
    mesh.colour(Palette.TRAIL, 1).tube(trail, 0.28 * size);
    double stretch = marks.device().sub(marks.point(), new Vec3()).length();
    if (stretch > 2 * size) {
      int turns = (int) Math.max(3, Math.min(14, stretch / size));
      mesh.colour(Palette.SPRING, 1)
          .spring(marks.point(), marks.device(), turns, 0.45 * size, 0.13 * size);
    }
    mesh.colour(Palette.DEVICE, 1).ball(marks.device(), 0.75 * size);
    mesh.colour(Palette.POINT, 1).ball(marks.point(), size);
    double newton = marks.forceNewton().length();
    if (newton > 0) {
      double length = Math.min(ARROW_SIZE * newton, LONGEST_ARROW) * distance;
      Vec3 along = marks.forceNewton().mul(length / newton, new Vec3());
      Vec3 tip = along.add(marks.point(), along);
      mesh.colour(Palette.FORCE, 1).arrow(marks.point(), tip, 0.4 * size);
    }
  }

  void dispose(GL3 gl) {
    program.dispose(gl);
    buffer.dispose(gl);
  }
}
