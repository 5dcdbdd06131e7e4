package org.palpate.scene.gl;

import com.jogamp.common.nio.Buffers;
import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.util.Arrays;
import java.util.Optional;
import org.palpate.geometry.Vec3;
import org.palpate.scene.Deformation;
import org.palpate.scene.Matrix4;
import org.palpate.scene.SceneState;
import org.palpate.scene.SlicePlanes;

/** Draws up to three planes of grey values. */
final class SlicePainter {
  private static final int[][] CORNERS = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};

  /** The floats of a vertex: its position and its place in the texture. */
  private static final int FLOATS = 5;

  /** The pieces of a plane for each cell of a deformation. */
  private static final int PIECES_PER_CELL = 2;

  private final GlProgram program;
  private final DeformationTexture texture;
  private final StreamBuffer buffer;
  private final int[] textures = new int[3];
  private final int[] shown = {-1, -1, -1};
  private SlicePlanes.Grey source;

  /**
   * Compiles the program.
   *
   * @param texture the deformation of each picture
   */
  SlicePainter(GL3 gl, DeformationTexture texture) {
    this.texture = texture;
    program = new GlProgram(gl, Shaders.SLICE_VERTEX, Shaders.SLICE_FRAGMENT);
    buffer = new StreamBuffer(gl, 3, 2);
    gl.glGenTextures(3, textures, 0);
  }

  /** Draws the planes of a picture, if it has any, as they are deformed. */
  void draw(GL3 gl, SceneState state, Matrix4 toEye, Matrix4 projection) {
    state
        .look()
        .slices()
        .ifPresent(slices -> draw(gl, slices, state.deformation(), toEye, projection));
  }

  /** Draws planes. Uploads a plane only if it changed. */
  private void draw(
      GL3 gl,
      SlicePlanes slices,
      Optional<Deformation> deformation,
      Matrix4 toEye,
      Matrix4 projection) {
    if (source != slices.grey()) {
      source = slices.grey();
      Arrays.fill(shown, -1);
    }
    program.use(gl);
    program.set(gl, "toEye", toEye.times(Matrix4.of(slices.pose())));
    program.set(gl, "projection", projection);
    program.set(gl, "slice", 0);
    Optional<Deformation> drawn = texture.use(gl, program, deformation);
    program.set(gl, "deforms", drawn.isPresent() ? 1 : 0);
    gl.glActiveTexture(GL.GL_TEXTURE0);
    for (int axis = 0; axis < 3; axis++) {
      if (slices.plane(axis) >= 0) {
        gl.glBindTexture(GL.GL_TEXTURE_2D, textures[axis]);
        upload(gl, slices, axis);
        FloatBuffer vertices = vertices(slices, axis, drawn);
        buffer.draw(gl, vertices, vertices.limit() / FLOATS);
      }
    }
  }

  private void upload(GL3 gl, SlicePlanes slices, int axis) {
    if (shown[axis] == slices.plane(axis)) {
      return;
    }
    shown[axis] = slices.plane(axis);
    int width = source.size((axis + 1) % 3);
    int height = source.size((axis + 2) % 3);
    ByteBuffer bytes = Buffers.newDirectByteBuffer(width * height);
    double scale = 255 / (source.white() - source.black());
    for (int v = 0; v < height; v++) {
      for (int u = 0; u < width; u++) {
        double grey = (value(axis, shown[axis], u, v) - source.black()) * scale;
        bytes.put((byte) (int) Math.max(0, Math.min(255, grey)));
      }
    }
    GreyTexture.upload(gl, width, height, bytes.flip());
  }

  private double value(int axis, int plane, int u, int v) {
    int[] voxel = new int[3];
    voxel[axis] = plane;
    voxel[(axis + 1) % 3] = u;
    voxel[(axis + 2) % 3] = v;
    return source.value(voxel[0], voxel[1], voxel[2]);
  }

  /** Returns a plane in grid mm: one piece, or small ones that follow a deformation. */
  private FloatBuffer vertices(SlicePlanes slices, int axis, Optional<Deformation> deformation) {
    int across = (axis + 1) % 3;
    int up = (axis + 2) % 3;
    int columns = pieces(slices, across, deformation);
    int rows = pieces(slices, up, deformation);
    FloatBuffer floats = Buffers.newDirectFloatBuffer(FLOATS * CORNERS.length * columns * rows);
    Vec3 spacing = slices.spacingMm();
    Vec3 at = new Vec3();
    at.set(axis, (slices.plane(axis) + 0.5) * spacing.get(axis));
    for (int piece = 0; piece < columns * rows; piece++) {
      for (int[] corner : CORNERS) {
        double u = (piece % columns + corner[0]) / (double) columns;
        double v = (piece / columns + corner[1]) / (double) rows;
        at.set(across, u * source.size(across) * spacing.get(across));
        at.set(up, v * source.size(up) * spacing.get(up));
        floats.put((float) at.x).put((float) at.y).put((float) at.z);
        floats.put((float) u).put((float) v);
      }
    }
    return floats.flip();
  }

  private int pieces(SlicePlanes slices, int axis, Optional<Deformation> deformation) {
    double lengthMm = source.size(axis) * slices.spacingMm().get(axis);
    return deformation
        .map(moving -> (int) Math.ceil(PIECES_PER_CELL * lengthMm / moving.shortestCellMm(axis)))
        .orElse(1);
  }

  /** Releases the textures and the program. */
  void dispose(GL3 gl) {
    gl.glDeleteTextures(3, textures, 0);
    program.dispose(gl);
    buffer.dispose(gl);
  }
}
