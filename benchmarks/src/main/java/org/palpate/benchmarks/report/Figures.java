package org.palpate.benchmarks.report;

import java.awt.Color;
import java.io.IOException;
import java.nio.file.Path;
import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.BitmapEncoder.BitmapFormat;
import org.knowm.xchart.internal.chartpart.Chart;
import org.palpate.io.file.AtomicFile;

/** How the pictures of studies look. */
public final class Figures {
  /** Colours that are told apart in print and by most eyes. Source: Okabe and Ito 2008. */
  private static final Color[] COLOURS = {
    new Color(0, 114, 178),
    new Color(230, 159, 0),
    new Color(0, 158, 115),
    new Color(213, 94, 0),
    new Color(204, 121, 167),
    new Color(86, 180, 233)
  };

  private Figures() {}

  /** A white ground, no frames, colours that most eyes tell apart. */
  public static void plain(Chart<?, ?> chart) {
    chart.getStyler().setChartBackgroundColor(Color.WHITE);
    chart.getStyler().setPlotBackgroundColor(Color.WHITE);
    chart.getStyler().setLegendBorderColor(Color.WHITE);
    chart.getStyler().setSeriesColors(COLOURS);
  }

  /** Writes a PNG file, whole or not at all. */
  public static void save(Chart<?, ?> chart, Path file) throws IOException {
    try (AtomicFile out = new AtomicFile(file)) {
      BitmapEncoder.saveBitmap(chart, out.stream(), BitmapFormat.PNG);
      out.commit();
    }
  }

  /** The colour of a series by its number, for series that belong together. */
  public static Color colour(int number) {
    return COLOURS[number % COLOURS.length];
  }
}
