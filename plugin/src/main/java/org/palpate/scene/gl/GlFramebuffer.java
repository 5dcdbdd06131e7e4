package org.palpate.scene.gl;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2ES2;
import com.jogamp.opengl.GL2ES3;
import com.jogamp.opengl.GL3;

/**
 * A framebuffer with two textures: one for colour, and one for depth and stencil. The stencil holds
 * {@link #SLICE} where a slice is nearest, and {@link #NO_SLICE} elsewhere.
 */
final class GlFramebuffer {
  static final int NO_SLICE = 0;
  static final int SLICE = 1;
  static final int STENCIL_MASK = 0xff;

  private final int[] framebuffer = new int[1];
  private final int[] textures = new int[2];
  private int width;
  private int height;

  /** Returns the colour texture. */
  int colour() {
    return textures[0];
  }

  /** Returns the framebuffer's name; 0 before the first {@link #resize}. */
  int framebuffer() {
    return framebuffer[0];
  }

  /**
   * Sets the size.
   *
   * @return whether the size changed, so that the contents are lost
   * @throws IllegalStateException if the driver has no memory for it or refuses the formats
   */
  boolean resize(GL3 gl, int newWidth, int newHeight) {
    if (framebuffer[0] != 0 && newWidth == width && newHeight == height) {
      return false;
    }
    dispose(gl);
    width = newWidth;
    height = newHeight;
    gl.glGenFramebuffers(1, framebuffer, 0);
    gl.glGenTextures(2, textures, 0);
    allocate(gl, textures[0], GL.GL_RGBA8, GL.GL_RGBA, GL.GL_UNSIGNED_BYTE);
    allocate(gl, textures[1], GL.GL_DEPTH24_STENCIL8, GL.GL_DEPTH_STENCIL, GL.GL_UNSIGNED_INT_24_8);
    bind(gl);
    attach(gl, GL.GL_COLOR_ATTACHMENT0, textures[0]);
    attach(gl, GL2ES3.GL_DEPTH_STENCIL_ATTACHMENT, textures[1]);
    int status = gl.glCheckFramebufferStatus(GL.GL_FRAMEBUFFER);
    if (status != GL.GL_FRAMEBUFFER_COMPLETE) {
      throw new IllegalStateException(
          "no framebuffer of "
              + width
              + "x"
              + height
              + ": status 0x"
              + Integer.toHexString(status));
    }
    return true;
  }

  private void allocate(GL3 gl, int texture, int internal, int format, int type) {
    gl.glBindTexture(GL.GL_TEXTURE_2D, texture);
    gl.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MIN_FILTER, GL.GL_NEAREST);
    gl.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MAG_FILTER, GL.GL_NEAREST);
    gl.glTexImage2D(GL.GL_TEXTURE_2D, 0, internal, width, height, 0, format, type, null);
  }

  private static void attach(GL3 gl, int attachment, int texture) {
    gl.glFramebufferTexture2D(GL.GL_FRAMEBUFFER, attachment, GL.GL_TEXTURE_2D, texture, 0);
  }

  /** Makes this the target of drawing. */
  void bind(GL3 gl) {
    gl.glBindFramebuffer(GL.GL_FRAMEBUFFER, framebuffer[0]);
    gl.glViewport(0, 0, width, height);
  }

  /** Copies colour, depth and stencil from a framebuffer of the same size. */
  void copyFrom(GL3 gl, GlFramebuffer other) {
    gl.glBindFramebuffer(GL2ES2.GL_READ_FRAMEBUFFER, other.framebuffer());
    gl.glBindFramebuffer(GL2ES2.GL_DRAW_FRAMEBUFFER, framebuffer[0]);
    gl.glBlitFramebuffer(
        0,
        0,
        width,
        height,
        0,
        0,
        width,
        height,
        GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT | GL.GL_STENCIL_BUFFER_BIT,
        GL.GL_NEAREST);
  }

  /** Releases the textures. */
  void dispose(GL3 gl) {
    if (framebuffer[0] != 0) {
      gl.glDeleteFramebuffers(1, framebuffer, 0);
      gl.glDeleteTextures(2, textures, 0);
      framebuffer[0] = 0;
    }
  }
}
