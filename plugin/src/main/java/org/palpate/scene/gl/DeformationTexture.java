package org.palpate.scene.gl;

import com.jogamp.common.nio.Buffers;
import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2ES2;
import com.jogamp.opengl.GL2ES3;
import com.jogamp.opengl.GL3;
import java.util.Optional;
import org.palpate.geometry.Vec3;
import org.palpate.scene.Deformation;

/**
 * The displacements of a deformation as 3-D textures, one texel a node, for programs that contain
 * {@link Shaders#DISPLACEMENT}: one of the lattice, and one of its window. Uploaded once for each
 * deformation.
 */
final class DeformationTexture {
  /** The unit of the lattice; 0 is for pictures, and 1 for {@link TintTexture}. */
  private static final int LATTICE = 2;

  /** The unit of the window. */
  private static final int WINDOW = 3;

  private final int[] textures = new int[2];
  private final Deformation[] uploaded = new Deformation[2];
  private final int mostNodes;

  /** Creates textures without displacements. */
  DeformationTexture(GL3 gl) {
    gl.glGenTextures(textures.length, textures, 0);
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
    program.set(gl, "displacements", LATTICE);
    program.set(gl, "windowDisplacements", WINDOW);
    program.set(gl, "deforms", 0);
    Optional<Deformation> drawn = drawable(wanted);
    Optional<Deformation> window = drawn.flatMap(Deformation::window);
    program.set(gl, "windowed", window.isPresent() ? 1 : 0);
    drawn.ifPresent(deformation -> bind(gl, program, LATTICE, "lattice", deformation));
    window.ifPresent(deformation -> bind(gl, program, WINDOW, "window", deformation));
    return drawn;
  }

  private void bind(GL3 gl, GlProgram program, int unit, String name, Deformation shown) {
    Vec3 origin = shown.originMm();
    Vec3 cell = shown.cellMm();
    program.set(gl, name + "Origin", origin.x, origin.y, origin.z);
    program.set(gl, name + "Cell", cell.x, cell.y, cell.z);
    program.set(
        gl, name + "Cells", shown.nodes(0) - 1.0, shown.nodes(1) - 1.0, shown.nodes(2) - 1.0);
    gl.glActiveTexture(GL.GL_TEXTURE0 + unit);
    gl.glBindTexture(GL2ES2.GL_TEXTURE_3D, textures[unit - LATTICE]);
    if (uploaded[unit - LATTICE] != shown) {
      uploaded[unit - LATTICE] = shown;
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

  /** Releases the textures. */
  void dispose(GL3 gl) {
    gl.glDeleteTextures(textures.length, textures, 0);
  }
}
