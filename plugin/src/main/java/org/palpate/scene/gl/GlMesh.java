package org.palpate.scene.gl;

import com.jogamp.common.nio.Buffers;
import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.nio.ByteBuffer;
import org.palpate.geometry.Vec3;
import org.palpate.scene.Deformation;
import org.palpate.scene.Matrix4;
import org.palpate.scene.surface.SurfaceBrick;

/** A surface brick in the memory of the graphics card, with its bounding box. */
final class GlMesh {
  private static final int VERTEX_BYTES = 20;
  private static final int NORMAL_OFFSET = 12;
  private static final int SHORT_INDEX_LIMIT = 1 << 16;

  private final SurfaceBrick brick;
  private final int[] vertexArray = new int[1];
  private final int[] buffers = new int[2];
  private final boolean shortIndices;
  private final Vec3 low = new Vec3(Double.MAX_VALUE, Double.MAX_VALUE, Double.MAX_VALUE);
  private final Vec3 high = new Vec3(-Double.MAX_VALUE, -Double.MAX_VALUE, -Double.MAX_VALUE);

  /** Uploads a brick. */
  GlMesh(GL3 gl, SurfaceBrick brick) {
    this.brick = brick;
    shortIndices = brick.vertexCount() <= SHORT_INDEX_LIMIT;
    gl.glGenVertexArrays(1, vertexArray, 0);
    gl.glGenBuffers(2, buffers, 0);
    gl.glBindVertexArray(vertexArray[0]);
    ByteBuffer vertices = vertices();
    gl.glBindBuffer(GL.GL_ARRAY_BUFFER, buffers[0]);
    gl.glBufferData(GL.GL_ARRAY_BUFFER, vertices.limit(), vertices, GL.GL_STATIC_DRAW);
    ByteBuffer indices = indices();
    gl.glBindBuffer(GL.GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    gl.glBufferData(GL.GL_ELEMENT_ARRAY_BUFFER, indices.limit(), indices, GL.GL_STATIC_DRAW);
    gl.glEnableVertexAttribArray(0);
    gl.glVertexAttribPointer(0, 3, GL.GL_FLOAT, false, VERTEX_BYTES, 0);
    gl.glEnableVertexAttribArray(1);
    gl.glVertexAttribPointer(1, 4, GL.GL_SHORT, true, VERTEX_BYTES, NORMAL_OFFSET);
    gl.glBindVertexArray(0);
  }

  private ByteBuffer vertices() {
    float[] positions = brick.positionsMm();
    short[] normals = brick.normals();
    ByteBuffer bytes = Buffers.newDirectByteBuffer(brick.vertexCount() * VERTEX_BYTES);
    for (int v = 0; v < brick.vertexCount(); v++) {
      for (int axis = 0; axis < 3; axis++) {
        float coordinate = positions[3 * v + axis];
        bytes.putFloat(coordinate);
        low.set(axis, Math.min(low.get(axis), coordinate));
        high.set(axis, Math.max(high.get(axis), coordinate));
      }
      for (int part = 0; part < 4; part++) {
        bytes.putShort(normals[4 * v + part]);
      }
    }
    return bytes.flip();
  }

  private ByteBuffer indices() {
    int[] triangles = brick.triangles();
    ByteBuffer bytes = Buffers.newDirectByteBuffer(triangles.length * (shortIndices ? 2 : 4));
    for (int index : triangles) {
      if (shortIndices) {
        bytes.putShort((short) index);
      } else {
        bytes.putInt(index);
      }
    }
    return bytes.flip();
  }

  /** Whether this mesh was made from the given brick. */
  boolean shows(SurfaceBrick other) {
    return brick == other;
  }

  /** Returns the number of triangles. */
  int triangleCount() {
    return brick.triangleCount();
  }

  /** Whether some of the brick is displaced. */
  boolean isMovedBy(Deformation deformation) {
    return deformation.moves(low, high);
  }

  /**
   * Whether the bounding box, grown by a margin, lies completely outside one plane of the view
   * frustum.
   *
   * @param toClip transform from grid mm to clip coordinates
   * @param marginMm at least the longest displacement of a vertex, mm
   */
  boolean isOutside(Matrix4 toClip, double marginMm) {
    for (int plane = 0; plane < 6; plane++) {
      int row = plane >> 1;
      double sign = (plane & 1) == 0 ? 1 : -1;
      double best = toClip.at(3, 3) + sign * toClip.at(row, 3);
      for (int axis = 0; axis < 3; axis++) {
        double factor = toClip.at(3, axis) + sign * toClip.at(row, axis);
        best += factor * (factor > 0 ? high.get(axis) + marginMm : low.get(axis) - marginMm);
      }
      if (best < 0) {
        return true;
      }
    }
    return false;
  }

  /** Draws the triangles. */
  void draw(GL3 gl) {
    gl.glBindVertexArray(vertexArray[0]);
    int type = shortIndices ? GL.GL_UNSIGNED_SHORT : GL.GL_UNSIGNED_INT;
    gl.glDrawElements(GL.GL_TRIANGLES, brick.triangles().length, type, 0);
  }

  /** Releases the buffers. */
  void dispose(GL3 gl) {
    gl.glDeleteVertexArrays(1, vertexArray, 0);
    gl.glDeleteBuffers(2, buffers, 0);
  }
}
