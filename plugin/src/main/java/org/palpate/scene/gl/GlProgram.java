package org.palpate.scene.gl;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2ES2;
import com.jogamp.opengl.GL3;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import org.palpate.scene.Matrix4;

/** A linked shader program with its uniforms by name. */
final class GlProgram {
  private static final int LOG_BYTES = 4096;

  private final int id;
  private final Map<String, Integer> locations = new HashMap<>();

  /**
   * Compiles and links the program.
   *
   * @throws IllegalStateException with the driver's message if it refuses
   */
  GlProgram(GL3 gl, String vertexSource, String fragmentSource) {
    id = gl.glCreateProgram();
    int vertex = compile(gl, GL2ES2.GL_VERTEX_SHADER, vertexSource);
    int fragment = compile(gl, GL2ES2.GL_FRAGMENT_SHADER, fragmentSource);
    gl.glAttachShader(id, vertex);
    gl.glAttachShader(id, fragment);
    gl.glLinkProgram(id);
    int[] status = new int[1];
    gl.glGetProgramiv(id, GL2ES2.GL_LINK_STATUS, status, 0);
    if (status[0] == GL.GL_FALSE) {
      throw new IllegalStateException("the driver cannot link a shader program");
    }
    gl.glDeleteShader(vertex);
    gl.glDeleteShader(fragment);
  }

  private static int compile(GL3 gl, int type, String source) {
    int shader = gl.glCreateShader(type);
    gl.glShaderSource(shader, 1, new String[] {"#version 330 core\n" + source}, null);
    gl.glCompileShader(shader);
    int[] status = new int[1];
    gl.glGetShaderiv(shader, GL2ES2.GL_COMPILE_STATUS, status, 0);
    if (status[0] == GL.GL_FALSE) {
      byte[] log = new byte[LOG_BYTES];
      int[] length = new int[1];
      gl.glGetShaderInfoLog(shader, LOG_BYTES, length, 0, log, 0);
      throw new IllegalStateException(
          "the driver refuses a shader: " + new String(log, 0, length[0], StandardCharsets.UTF_8));
    }
    return shader;
  }

  /** Makes this the current program. */
  void use(GL3 gl) {
    gl.glUseProgram(id);
  }

  private int location(GL3 gl, String name) {
    return locations.computeIfAbsent(name, key -> gl.glGetUniformLocation(id, key));
  }

  /** Sets a matrix uniform. */
  void set(GL3 gl, String name, Matrix4 matrix) {
    gl.glUniformMatrix4fv(location(gl, name), 1, false, matrix.toFloats(), 0);
  }

  /** Sets an integer uniform. */
  void set(GL3 gl, String name, int value) {
    gl.glUniform1i(location(gl, name), value);
  }

  /** Sets a scalar uniform. */
  void set(GL3 gl, String name, double value) {
    gl.glUniform1f(location(gl, name), (float) value);
  }

  /** Sets a two-component uniform. */
  void set(GL3 gl, String name, double x, double y) {
    gl.glUniform2f(location(gl, name), (float) x, (float) y);
  }

  /** Sets a three-component uniform. */
  void set(GL3 gl, String name, double x, double y, double z) {
    gl.glUniform3f(location(gl, name), (float) x, (float) y, (float) z);
  }

  /** Sets a colour uniform from 0xRRGGBB, as red, green and blue from 0 to 1. */
  void setRgb(GL3 gl, String name, int rgb) {
    set(gl, name, ((rgb >> 16) & 255) / 255.0, ((rgb >> 8) & 255) / 255.0, (rgb & 255) / 255.0);
  }

  /** Releases the program. */
  void dispose(GL3 gl) {
    gl.glDeleteProgram(id);
  }
}
