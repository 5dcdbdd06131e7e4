package org.palpate.scene.window;

import com.jogamp.common.nio.Buffers;
import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.nio.ByteBuffer;

/** Reads the drawn pixels from the graphics card. */
final class PixelReader {
  private static final int BYTES_PER_PIXEL = 4;

  private PixelReader() {}

  /** Returns the picture in the framebuffer that a drawable shows. */
  static Picture read(GL3 gl, int width, int height) {
    gl.glBindFramebuffer(GL.GL_FRAMEBUFFER, gl.getDefaultReadFramebuffer());
    ByteBuffer bytes = Buffers.newDirectByteBuffer(width * height * BYTES_PER_PIXEL);
    gl.glPixelStorei(GL.GL_PACK_ALIGNMENT, 1);
    gl.glReadPixels(0, 0, width, height, GL.GL_RGBA, GL.GL_UNSIGNED_BYTE, bytes);
    int[] rgb = new int[width * height];
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        int at = ((height - 1 - y) * width + x) * BYTES_PER_PIXEL;
        rgb[y * width + x] =
            ((bytes.get(at) & 255) << 16)
                | ((bytes.get(at + 1) & 255) << 8)
                | (bytes.get(at + 2) & 255);
      }
    }
    return new Picture(width, height, rgb);
  }
}
