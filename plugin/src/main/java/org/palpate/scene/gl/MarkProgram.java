package org.palpate.scene.gl;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.nio.FloatBuffer;
import org.palpate.scene.Matrix4;

/** Draws marks over a picture whose depth is there; what is hidden shows faintly. */
final class MarkProgram {
  private final GlProgram program;
  private final StreamBuffer buffer;

  MarkProgram(GL3 gl) {
    program = new GlProgram(gl, Shaders.MARK_VERTEX, Shaders.MARK_FRAGMENT);
    buffer = new StreamBuffer(gl, 3, 3, 4);
  }

  /** Says from where the next marks are seen. */
  void use(GL3 gl, Matrix4 toEye, Matrix4 projection) {
    program.use(gl);
    program.set(gl, "toEye", toEye);
    program.set(gl, "projection", projection);
    gl.glDisable(GL.GL_CULL_FACE);
    gl.glEnable(GL.GL_DEPTH_TEST);
  }

  /**
   * Draws some marks.
   *
   * @param nearerMm how much nearer to the eye they count as
   * @param hiddenOpacity how much of them shows through what hides them
   */
  void draw(GL3 gl, MarkMesh marks, double nearerMm, double hiddenOpacity) {
    FloatBuffer vertices = marks.buffer();
    program.set(gl, "nearer", nearerMm);
    gl.glEnable(GL.GL_BLEND);
    gl.glBlendFunc(GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA);
    gl.glDepthFunc(GL.GL_GREATER);
    gl.glDepthMask(false);
    program.set(gl, "opacity", hiddenOpacity);
    buffer.draw(gl, vertices, marks.vertexCount());
    gl.glDisable(GL.GL_BLEND);
    gl.glDepthMask(true);
    gl.glDepthFunc(GL.GL_LESS);
    program.set(gl, "opacity", 1.0);
    buffer.draw(gl, vertices, marks.vertexCount());
  }

  void dispose(GL3 gl) {
    program.dispose(gl);
    buffer.dispose(gl);
  }
}
