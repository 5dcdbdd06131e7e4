package org.palpate.scene.gl;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.nio.FloatBuffer;
import java.util.List;
import org.palpate.scene.Matrix4;
import org.palpate.scene.NamedPlace;
import org.palpate.scene.Palette;
import org.palpate.scene.SceneState;

/** Draws landmarks as small balls; their names are the business of {@link OverlayPainter}. */
final class LandmarkPainter {
  /** Radius of a ball over the distance of what is looked at. */
  private static final double SIZE = 0.0038;

  /** How much of a ball shows through what hides it. */
  private static final double HIDDEN_OPACITY = 0.3;

  private final GlProgram program;
  private final StreamBuffer buffer;
  private final MarkMesh mesh = new MarkMesh();

  LandmarkPainter(GL3 gl) {
    program = new GlProgram(gl, Shaders.MARK_VERTEX, Shaders.MARK_FRAGMENT);
    buffer = new StreamBuffer(gl, 3, 3, 4);
  }

  /** Draws them over a picture whose depth is there; what is hidden shows faintly. */
  void draw(GL3 gl, SceneState state, Matrix4 toEye, Matrix4 projection) {
    List<NamedPlace> landmarks = state.landmarks();
    if (landmarks.isEmpty()) {
      return;
    }
    mesh.clear();
    mesh.colour(Palette.LANDMARK, 1);
    double radius = SIZE * state.camera().distanceMm();
    landmarks.forEach(mark -> mesh.ball(mark.place(), radius));
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

  void dispose(GL3 gl) {
    program.dispose(gl);
    buffer.dispose(gl);
  }
}
