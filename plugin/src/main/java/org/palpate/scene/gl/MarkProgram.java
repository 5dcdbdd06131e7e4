package org.palpate.scene.gl;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.nio.FloatBuffer;
import org.palpate.scene.Matrix4;

/** Draws marks over a picture with its depth; hidden parts are faint. */
final class MarkProgram {
  private final GlProgram program;
  private final StreamBuffer buffer;

  /** Compiles the program. */
  MarkProgram(GL3 gl) {
    program = new GlProgram(gl, Shaders.MARK_VERTEX, Shaders.MARK_FRAGMENT);
    buffer = new StreamBuffer(gl, 3, 3, 4);
  }

  /** Sets the camera of the following marks. */
  void use(GL3 gl, Matrix4 toEye, Matrix4 projection) {
    program.use(gl);
    program.set(gl, "toEye", toEye);
    program.set(gl, "projection", projection);
    gl.glDisable(GL.GL_CULL_FACE);
    gl.glEnable(GL.GL_DEPTH_TEST);
  }

  /**
   * Draws marks.
   *
   * @param nearerMm distance by which they move towards the eye in the depth test
   * @param hiddenOpacity opacity of their hidden parts
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

  /** Releases the program. */
  void dispose(GL3 gl) {
    program.dispose(gl);
    buffer.dispose(gl);
  }
}
