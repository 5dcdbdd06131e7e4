package org.palpate.app.output;

import java.util.Locale;

/**
 * A plot as a picture in SVG that stands within a page. The page's style gives the classes their
 * colours. One thread.
 */
final class SvgPlot {
  private static final int LEFT = 62;
  private static final int RIGHT = 14;
  private static final int TOP = 10;
  private static final int BOTTOM = 40;

  private final int width;
  private final int height;
  private final PlotAxis x;
  private final PlotAxis y;
  private final StringBuilder marks = new StringBuilder();

  /**
   * Makes an empty plot.
   *
   * @param width of the whole picture, pixels
   * @param height of the whole picture, pixels
   */
  SvgPlot(int width, int height, PlotAxis x, PlotAxis y) {
    this.width = width;
    this.height = height;
    this.x = x;
    this.y = y;
  }

  private double placeX(double value) {
    return x.place(value, LEFT, width - (double) RIGHT);
  }

  private double placeY(double value) {
    return y.place(value, height - (double) BOTTOM, TOP);
  }

  /** Adds a line through points; those that are not finite interrupt it. */
  void line(String style, double[] xs, double[] ys) {
    StringBuilder path = new StringBuilder();
    boolean draws = false;
    for (int n = 0; n < xs.length; n++) {
      boolean isPoint = Double.isFinite(xs[n]) && Double.isFinite(ys[n]);
      if (isPoint) {
        path.append(draws ? 'L' : 'M').append(number(placeX(xs[n])));
        path.append(' ').append(number(placeY(ys[n])));
      }
      draws = isPoint;
    }
    marks.append(String.format(Locale.ROOT, "<path class=\"%s\" d=\"%s\"/>\n", style, path));
  }

  /** Adds a rectangle between two corners, with a text that appears under the mouse. */
  void rectangle(String style, double x0, double y0, double x1, double y1, String hint) {
    double left = placeX(x0);
    double top = placeY(y1);
    marks.append(
        String.format(
            Locale.ROOT,
            "<rect class=\"%s\" x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\">"
                + "<title>%s</title></rect>\n",
            style,
            left,
            top,
            Math.max(1, placeX(x1) - left),
            Math.max(1, placeY(y0) - top),
            escaped(hint)));
  }

  /** Adds a text beside a point. */
  void text(double atX, double atY, String text) {
    marks.append(
        String.format(
            Locale.ROOT,
            "<text class=\"name\" x=\"%.1f\" y=\"%.1f\">%s</text>\n",
            placeX(atX) + 4,
            placeY(atY) + 4,
            escaped(text)));
  }

  /**
   * Returns the picture.
   *
   * @param title what it shows, for those who do not see it
   */
  String svg(String title) {
    StringBuilder svg = new StringBuilder();
    svg.append(
        String.format(
            Locale.ROOT,
            "<svg role=\"img\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\">"
                + "<title>%s</title>\n",
            width,
            height,
            width,
            height,
            escaped(title)));
    addAxes(svg);
    return svg.append(marks).append("</svg>\n").toString();
  }

  private void addAxes(StringBuilder svg) {
    int bottom = height - BOTTOM;
    int right = width - RIGHT;
    for (double tick : x.ticks()) {
      addLine(svg, placeX(tick), bottom, placeX(tick), TOP);
      addText(svg, "middle", placeX(tick), bottom + 14.0, PlotAxis.text(tick));
    }
    for (double tick : y.ticks()) {
      addLine(svg, LEFT, placeY(tick), right, placeY(tick));
      addText(svg, "end", LEFT - 6.0, placeY(tick) + 4, PlotAxis.text(tick));
    }
    addText(svg, "middle", (LEFT + right) / 2.0, height - 8.0, x.label());
    svg.append(
        String.format(
            Locale.ROOT,
            "<text text-anchor=\"middle\" transform=\"translate(14 %.1f) rotate(-90)\">%s</text>\n",
            (TOP + bottom) / 2.0,
            escaped(y.label())));
  }

  private static void addLine(StringBuilder svg, double x0, double y0, double x1, double y1) {
    svg.append(
        String.format(
            Locale.ROOT,
            "<line class=\"grid\" x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\"/>\n",
            x0,
            y0,
            x1,
            y1));
  }

  private static void addText(StringBuilder svg, String anchor, double x, double y, String text) {
    svg.append(
        String.format(
            Locale.ROOT,
            "<text text-anchor=\"%s\" x=\"%.1f\" y=\"%.1f\">%s</text>\n",
            anchor,
            x,
            y,
            escaped(text)));
  }

  private static String number(double pixels) {
    return String.format(Locale.ROOT, "%.1f", pixels);
  }

  /** Returns a text in which nothing is markup. */
  static String escaped(String text) {
    return text.replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;")
        .replace("'", "&#39;");
  }
}
