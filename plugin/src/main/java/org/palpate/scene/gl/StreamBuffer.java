package org.palpate.scene.gl;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2ES2;
import com.jogamp.opengl.GL3;
import java.nio.FloatBuffer;
import java.util.Arrays;

/** A vertex buffer whose floats are sent anew for each picture. */
final class StreamBuffer {
  private final int[] vertexArray = new int[1];
  private final int[] buffer = new int[1];

  /**
   * Creates a buffer.
   *
   * @param attributes number of floats of each vertex attribute, in their order
   */
  StreamBuffer(GL3 gl, int... attributes) {
    gl.glGenVertexArrays(1, vertexArray, 0);
    gl.glGenBuffers(1, buffer, 0);
    gl.glBindVertexArray(vertexArray[0]);
    gl.glBindBuffer(GL.GL_ARRAY_BUFFER, buffer[0]);
    int floats = Arrays.stream(attributes).sum();
    int offset = 0;
    for (int i = 0; i < attributes.length; i++) {
      gl.glEnableVertexAttribArray(i);
      gl.glVertexAttribPointer(
          i, attributes[i], GL.GL_FLOAT, false, floats * Float.BYTES, (long) offset * Float.BYTES);
      offset += attributes[i];
    }
    gl.glBindVertexArray(0);
  }

  /** Sends vertices and draws them as triangles. */
  void draw(GL3 gl, FloatBuffer vertices, int vertexCount) {
    gl.glBindVertexArray(vertexArray[0]);
    gl.glBindBuffer(GL.GL_ARRAY_BUFFER, buffer[0]);
    gl.glBufferData(
        GL.GL_ARRAY_BUFFER, (long) vertices.limit() * Float.BYTES, vertices, GL2ES2.GL_STREAM_DRAW);
    gl.glDrawArrays(GL.GL_TRIANGLES, 0, vertexCount);
    gl.glBindVertexArray(0);
  }

  /** Releases the buffer. */
  void dispose(GL3 gl) {
    gl.glDeleteVertexArrays(1, vertexArray, 0);
    gl.glDeleteBuffers(1, buffer, 0);
  }
}
