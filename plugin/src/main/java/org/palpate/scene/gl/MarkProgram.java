package org.palpate.scene.gl;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.nio.FloatBuffer;
import org.palpate.scene.Matrix4;

/**
 * Draws marks over a picture with its depth. Parts behind a surface are faint; parts behind a slice
 * are not, because a slice must not hide the interaction point.
 */
final class MarkProgram {
  private static final double BEHIND_SLICE_OPACITY = 0.9;

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
    gl.glEnable(GL.GL_STENCIL_TEST);
    gl.glStencilOp(GL.GL_KEEP, GL.GL_KEEP, GL.GL_KEEP);
    gl.glStencilFunc(GL.GL_EQUAL, GlFramebuffer.NO_SLICE, GlFramebuffer.STENCIL_MASK);
    program.set(gl, "opacity", hiddenOpacity);
    buffer.draw(gl, vertices, marks.vertexCount());
    gl.glStencilFunc(GL.GL_EQUAL, GlFramebuffer.SLICE, GlFramebuffer.STENCIL_MASK);
    program.set(gl, "opacity", BEHIND_SLICE_OPACITY);
    buffer.draw(gl, vertices, marks.vertexCount());
    gl.glDisable(GL.GL_STENCIL_TEST);
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
