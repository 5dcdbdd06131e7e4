package org.palpate.scene.gl;

import com.jogamp.common.nio.Buffers;
import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2ES2;
import com.jogamp.opengl.GL3;
import java.nio.ByteBuffer;
import java.util.Optional;
import org.palpate.scene.SurfaceTint;

/** The tint of the surface that is drawn next, as a texture of three dimensions. */
final class TintTexture {
  private static final int UNIT = 1;

  private final int[] texture = new int[1];
  private SurfaceTint uploaded;

  TintTexture(GL3 gl) {
    gl.glGenTextures(1, texture, 0);
  }

  /** Sets the tint of what the program draws next. Uploads it only if it changed. */
  void set(GL3 gl, GlProgram program, Optional<SurfaceTint> tint) {
    program.set(gl, "tint", UNIT);
    program.set(gl, "tinted", tint.isPresent() ? 1 : 0);
    if (tint.isPresent()) {
      SurfaceTint shown = tint.get();
      gl.glActiveTexture(GL.GL_TEXTURE0 + UNIT);
      gl.glBindTexture(GL2ES2.GL_TEXTURE_3D, texture[0]);
      upload(gl, shown);
      gl.glActiveTexture(GL.GL_TEXTURE0);
      program.set(gl, "tintLow", shown.lowMm().x, shown.lowMm().y, shown.lowMm().z);
      program.set(
          gl,
          "tintSize",
          shown.size(0) * shown.cellMm().x,
          shown.size(1) * shown.cellMm().y,
          shown.size(2) * shown.cellMm().z);
    }
  }

  private void upload(GL3 gl, SurfaceTint shown) {
    if (shown.equals(uploaded)) {
      return;
    }
    uploaded = shown;
    gl.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 1);
    for (int parameter : new int[] {GL.GL_TEXTURE_MIN_FILTER, GL.GL_TEXTURE_MAG_FILTER}) {
      gl.glTexParameteri(GL2ES2.GL_TEXTURE_3D, parameter, GL.GL_LINEAR);
    }
    for (int side :
        new int[] {GL.GL_TEXTURE_WRAP_S, GL.GL_TEXTURE_WRAP_T, GL2ES2.GL_TEXTURE_WRAP_R}) {
      gl.glTexParameteri(GL2ES2.GL_TEXTURE_3D, side, GL.GL_CLAMP_TO_EDGE);
    }
    ByteBuffer cells = shown.cells();
    ByteBuffer bytes = Buffers.newDirectByteBuffer(cells.remaining());
    gl.glTexImage3D(
        GL2ES2.GL_TEXTURE_3D,
        0,
        GL.GL_RG8,
        shown.size(0),
        shown.size(1),
        shown.size(2),
        0,
        GL2ES2.GL_RG,
        GL.GL_UNSIGNED_BYTE,
        bytes.put(cells).flip());
  }

  /** Releases the texture. */
  void dispose(GL3 gl) {
    gl.glDeleteTextures(1, texture, 0);
  }
}
