package org.palpate.scene.gl;

/**
 * The area of the legend in the picture, pixels from the upper left.
 *
 * @param left its left edge; it reaches to the right edge of the picture
 * @param top its upper edge
 * @param rowHeight height of a row
 * @param colourWidth width of the part of a row that shows the colour
 * @param first number of the segment in the first row
 * @param rows number of rows; 0 without a legend
 */
public record LegendArea(
    double left, double top, double rowHeight, double colourWidth, int first, int rows) {
  /** No legend. */
  public static final LegendArea NONE = new LegendArea(0, 0, 1, 0, 0, 0);

  /** Returns the number of the segment at a pixel; -1 if there is none. */
  public int segmentAt(int x, int y) {
    int row = (int) Math.floor((y - top) / rowHeight);
    return x >= left && row >= 0 && row < rows ? first + row : -1;
  }

  /** Whether a pixel of a row belongs to the colour of its segment. */
  public boolean isColour(int x) {
    return x < left + colourWidth;
  }
}
