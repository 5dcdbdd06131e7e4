package org.palpate.scene.gl;

import com.jogamp.common.nio.Buffers;
import java.nio.FloatBuffer;
import java.util.Arrays;

/** Vertices that are drawn together, collected anew for each picture. Each ends with its colour. */
abstract class ColouredVertices {
  private static final int COLOUR_FLOATS = 4;
  private static final int FIRST_VERTICES = 1 << 10;

  private final int floatsPerVertex;
  private float[] floats;
  private int used;
  private float red;
  private float green;
  private float blue;
  private float alpha;

  /**
   * Creates an empty collection.
   *
   * @param floatsBeforeColour number of floats of a vertex before those of its colour
   */
  ColouredVertices(int floatsBeforeColour) {
    floatsPerVertex = floatsBeforeColour + COLOUR_FLOATS;
    floats = new float[FIRST_VERTICES * floatsPerVertex];
  }

  /** Removes all vertices. */
  final void clear() {
    used = 0;
  }

  /** Sets the colour of the following vertices, 0xRRGGBB, and their opacity. */
  final void setColour(int rgb, double opacity) {
    red = ((rgb >> 16) & 255) / 255f;
    green = ((rgb >> 8) & 255) / 255f;
    blue = (rgb & 255) / 255f;
    alpha = (float) opacity;
  }

  /** Returns the number of vertices. */
  final int vertexCount() {
    return used / floatsPerVertex;
  }

  /** Returns all floats, those of each vertex in the order in which they were put. */
  final FloatBuffer buffer() {
    FloatBuffer buffer = Buffers.newDirectFloatBuffer(used);
    buffer.put(floats, 0, used);
    return buffer.flip();
  }

  /** Begins a vertex; each of its floats before the colour has to be put. */
  final void beginVertex() {
    if (used + floatsPerVertex > floats.length) {
      floats = Arrays.copyOf(floats, 2 * floats.length);
    }
  }

  /** Puts the next float of a vertex. */
  final void put(double value) {
    floats[used++] = (float) value;
  }

  /** Ends a vertex with the colour that was set. */
  final void endVertex() {
    put(red);
    put(green);
    put(blue);
    put(alpha);
  }
}
