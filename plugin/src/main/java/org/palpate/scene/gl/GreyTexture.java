package org.palpate.scene.gl;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2ES2;
import com.jogamp.opengl.GL3;
import java.nio.ByteBuffer;

/** Textures of one byte a pixel, interpolated between pixels and continued at their rim. */
final class GreyTexture {
  private GreyTexture() {}

  /**
   * Sends a picture to the texture that is bound.
   *
   * @param bytes the pixels, row by row without gaps
   */
  static void upload(GL3 gl, int width, int height, ByteBuffer bytes) {
    gl.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 1);
    gl.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MIN_FILTER, GL.GL_LINEAR);
    gl.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MAG_FILTER, GL.GL_LINEAR);
    gl.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_WRAP_S, GL.GL_CLAMP_TO_EDGE);
    gl.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_WRAP_T, GL.GL_CLAMP_TO_EDGE);
    gl.glTexImage2D(
        GL.GL_TEXTURE_2D,
        0,
        GL2ES2.GL_R8,
        width,
        height,
        0,
        GL2ES2.GL_RED,
        GL.GL_UNSIGNED_BYTE,
        bytes);
  }
}
