package org.palpate.scene.gl;

import com.jogamp.common.nio.Buffers;
import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2ES2;
import com.jogamp.opengl.GL2ES3;
import com.jogamp.opengl.GL3;
import java.util.Optional;
import org.palpate.scene.Deformation;

/**
 * The displacements of a deformation as a 3-D texture, one texel a node, for programs that contain
 * {@link Shaders#DISPLACEMENT}. Uploaded once for each deformation.
 */
final class DeformationTexture {
  /** The unit of the texture; 0 is for pictures, and 1 for {@link TintTexture}. */
  private static final int UNIT = 2;

  private final int[] texture = new int[1];
  private final int mostNodes;
  private Deformation uploaded;

  /** Creates a texture without displacements. */
  DeformationTexture(GL3 gl) {
    gl.glGenTextures(1, texture, 0);
    int[] most = new int[1];
    gl.glGetIntegerv(GL2ES3.GL_MAX_3D_TEXTURE_SIZE, most, 0);
    mostNodes = most[0];
  }

  /**
   * Returns the deformation if it displaces anything and fits into a texture. OpenGL promises 256
   * texels along an edge, and a long lattice may have more nodes.
   */
  private Optional<Deformation> drawable(Optional<Deformation> deformation) {
    return deformation.filter(
        shown -> {
          int most = Math.max(shown.nodes(0), Math.max(shown.nodes(1), shown.nodes(2)));
          return shown.longestMm() > 0 && most <= mostNodes;
        });
  }

  /**
   * Gives a program in use the deformation of a picture.
   *
   * @return the deformation that is drawn; empty if everything stands still
   */
  Optional<Deformation> use(GL3 gl, GlProgram program, Optional<Deformation> wanted) {
    program.set(gl, "displacements", UNIT);
    program.set(gl, "deforms", 0);
    Optional<Deformation> drawn = drawable(wanted);
    drawn.ifPresent(deformation -> bind(gl, program, deformation));
    return drawn;
  }

  private void bind(GL3 gl, GlProgram program, Deformation shown) {
    program.set(gl, "latticeOrigin", shown.originMm().x, shown.originMm().y, shown.originMm().z);
    program.set(gl, "latticeCell", shown.cellMm().x, shown.cellMm().y, shown.cellMm().z);
    program.set(
        gl, "latticeCells", shown.nodes(0) - 1.0, shown.nodes(1) - 1.0, shown.nodes(2) - 1.0);
    gl.glActiveTexture(GL.GL_TEXTURE0 + UNIT);
    gl.glBindTexture(GL2ES2.GL_TEXTURE_3D, texture[0]);
    if (uploaded != shown) {
      uploaded = shown;
      upload(gl, shown);
    }
    gl.glActiveTexture(GL.GL_TEXTURE0);
  }

  private static void upload(GL3 gl, Deformation shown) {
    gl.glTexParameteri(GL2ES2.GL_TEXTURE_3D, GL.GL_TEXTURE_MIN_FILTER, GL.GL_NEAREST);
    gl.glTexParameteri(GL2ES2.GL_TEXTURE_3D, GL.GL_TEXTURE_MAG_FILTER, GL.GL_NEAREST);
    gl.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 4);
    gl.glTexImage3D(
        GL2ES2.GL_TEXTURE_3D,
        0,
        GL.GL_RGB32F,
        shown.nodes(0),
        shown.nodes(1),
        shown.nodes(2),
        0,
        GL.GL_RGB,
        GL.GL_FLOAT,
        Buffers.newDirectFloatBuffer(shown.displacementsMm()));
  }

  /** Releases the texture. */
  void dispose(GL3 gl) {
    gl.glDeleteTextures(1, texture, 0);
  }
}
