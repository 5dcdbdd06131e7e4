package org.palpate.scene;

import java.util.List;
import java.util.Locale;

/**
 * The grey values that slices show from black to white, as radiologists name them.
 *
 * @param name its name; empty if the user dragged it
 * @param level the value in the middle
 * @param width the difference between white and black, positive
 */
record GreyWindow(String name, double level, double width) {
  /** Usual windows of CT scans, in Hounsfield units. */
  private static final List<GreyWindow> CT =
      List.of(
          new GreyWindow("bone", 500, 2000),
          new GreyWindow("soft tissue", 40, 400),
          new GreyWindow("lung", -600, 1500),
          new GreyWindow("brain", 40, 80));

  /** A drag over the height of the picture multiplies the width by this. */
  private static final double WIDTH_PER_HEIGHT = 8;

  /** Returns a window with the contrast of slices. */
  static GreyWindow of(String name, GreySlices grey) {
    return new GreyWindow(name, (grey.black() + grey.white()) / 2, grey.white() - grey.black());
  }

  /**
   * Returns the window that follows {@code shown}: a preset for CT, or {@code own} after the last.
   */
  static GreyWindow next(GreyWindow shown, GreyWindow own) {
    int index = CT.indexOf(shown) + 1;
    boolean isOwn = shown.equals(own);
    return isOwn ? CT.get(0) : index > 0 && index < CT.size() ? CT.get(index) : own;
  }

  /**
   * Returns the window after a drag.
   *
   * @param right distance to the right in picture heights, which widens the window
   * @param up distance upwards in picture heights, which raises the level by that part of the width
   */
  GreyWindow dragged(double right, double up) {
    return new GreyWindow("", level + up * width, width * Math.pow(WIDTH_PER_HEIGHT, right));
  }

  double black() {
    return level - width / 2;
  }

  double white() {
    return level + width / 2;
  }

  /** Returns the text of the overlay. */
  @Override
  public String toString() {
    String values = String.format(Locale.ROOT, "window %.4g level %.4g", width, level);
    return name.isEmpty() ? values : values + " (" + name + ")";
  }
}
