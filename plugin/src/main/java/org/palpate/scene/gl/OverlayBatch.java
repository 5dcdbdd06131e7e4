package org.palpate.scene.gl;

import com.jogamp.common.nio.Buffers;
import java.nio.FloatBuffer;
import java.util.Arrays;

/** Rectangles and lines in pixels from the upper left corner, drawn at once. */
final class OverlayBatch {
  private static final int FLOATS_A_VERTEX = 8;

  /** The place in the texture that means a plain area. */
  private static final float PLAIN = -1;

  private float[] floats = new float[1 << 13];
  private int used;
  private float red;
  private float green;
  private float blue;
  private float alpha;

  void clear() {
    used = 0;
  }

  OverlayBatch colour(int rgb, double opacity) {
    red = ((rgb >> 16) & 255) / 255f;
    green = ((rgb >> 8) & 255) / 255f;
    blue = (rgb & 255) / 255f;
    alpha = (float) opacity;
    return this;
  }

  /** A rectangle with a part of the texture. */
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

  /** A plain rectangle. */
  void panel(double left, double top, double right, double bottom) {
    rectangle(left, top, right, bottom, PLAIN, PLAIN, PLAIN, PLAIN);
  }

  /** A line of a width. */
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

  int vertexCount() {
    return used / FLOATS_A_VERTEX;
  }

  FloatBuffer buffer() {
    FloatBuffer buffer = Buffers.newDirectFloatBuffer(used);
    buffer.put(floats, 0, used);
    return buffer.flip();
  }

  private void vertex(double x, double y, double textureX, double textureY) {
    if (used + FLOATS_A_VERTEX > floats.length) {
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
