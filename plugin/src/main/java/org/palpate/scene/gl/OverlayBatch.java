package org.palpate.scene.gl;

import com.jogamp.common.nio.Buffers;
import java.nio.FloatBuffer;
import java.util.Arrays;

/** Collects rectangles and lines that are drawn together. Pixels from the upper left corner. */
final class OverlayBatch {
  private static final int FLOATS_PER_VERTEX = 8;

  /** Texture coordinate that stands for a plain area. */
  private static final float PLAIN = -1;

  private float[] floats = new float[1 << 13];
  private int used;
  private float red;
  private float green;
  private float blue;
  private float alpha;

  /** Removes all shapes. */
  void clear() {
    used = 0;
  }

  /** Sets the colour of the following shapes, 0xRRGGBB, and their opacity. */
  OverlayBatch colour(int rgb, double opacity) {
    red = ((rgb >> 16) & 255) / 255f;
    green = ((rgb >> 8) & 255) / 255f;
    blue = (rgb & 255) / 255f;
    alpha = (float) opacity;
    return this;
  }

  /** Adds a rectangle with a part of the texture. */
  void rectangle(
      double left,
      double top,
      double right,
      double bottom,
      double textureLeft,
      double textureTop,
      double textureRight,
      double textureBottom) {
    vertex(left, top, textureLeft, textureTop);
    vertex(left, bottom, textureLeft, textureBottom);
    vertex(right, bottom, textureRight, textureBottom);
    vertex(left, top, textureLeft, textureTop);
    vertex(right, bottom, textureRight, textureBottom);
    vertex(right, top, textureRight, textureTop);
  }

  /** Adds a plain rectangle. */
  void panel(double left, double top, double right, double bottom) {
    rectangle(left, top, right, bottom, PLAIN, PLAIN, PLAIN, PLAIN);
  }

  /** Adds a line with a width. */
  void line(double x, double y, double toX, double toY, double width) {
    double dx = toX - x;
    double dy = toY - y;
    double length = Math.hypot(dx, dy);
    if (length > 0) {
      double nx = -dy / length * width / 2;
      double ny = dx / length * width / 2;
      vertex(x + nx, y + ny, PLAIN, PLAIN);
      vertex(x - nx, y - ny, PLAIN, PLAIN);
      vertex(toX - nx, toY - ny, PLAIN, PLAIN);
      vertex(x + nx, y + ny, PLAIN, PLAIN);
      vertex(toX - nx, toY - ny, PLAIN, PLAIN);
      vertex(toX + nx, toY + ny, PLAIN, PLAIN);
    }
  }

  /** Returns the number of vertices. */
  int vertexCount() {
    return used / FLOATS_PER_VERTEX;
  }

  /** Returns the vertices: position, texture coordinates and colour. */
  FloatBuffer buffer() {
    FloatBuffer buffer = Buffers.newDirectFloatBuffer(used);
    buffer.put(floats, 0, used);
    return buffer.flip();
  }

  private void vertex(double x, double y, double textureX, double textureY) {
    if (used + FLOATS_PER_VERTEX > floats.length) {
      floats = Arrays.copyOf(floats, 2 * floats.length);
    }
    floats[used++] = (float) x;
    floats[used++] = (float) y;
    floats[used++] = (float) textureX;
    floats[used++] = (float) textureY;
    floats[used++] = red;
    floats[used++] = green;
    floats[used++] = blue;
    floats[used++] = alpha;
  }
}
