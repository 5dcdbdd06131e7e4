package org.palpate.scene.gl;

/** Collects rectangles and lines that are drawn together. Pixels from the upper left corner. */
final class OverlayBatch extends ColouredVertices {
  /** A position and the coordinates of a texture. */
  private static final int FLOATS_BEFORE_COLOUR = 4;

  /** Texture coordinate that stands for a plain area. */
  private static final float PLAIN = -1;

  OverlayBatch() {
    super(FLOATS_BEFORE_COLOUR);
  }

  /** Sets the colour of the following shapes, 0xRRGGBB, and their opacity. */
  OverlayBatch colour(int rgb, double opacity) {
    setColour(rgb, opacity);
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

  private void vertex(double x, double y, double textureX, double textureY) {
    beginVertex();
    put(x);
    put(y);
    put(textureX);
    put(textureY);
    endVertex();
  }
}
