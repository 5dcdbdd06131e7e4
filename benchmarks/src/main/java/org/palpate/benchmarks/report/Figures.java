package org.palpate.benchmarks.report;

import java.awt.Color;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.BitmapEncoder.BitmapFormat;
import org.knowm.xchart.internal.chartpart.Chart;
import org.knowm.xchart.style.AxesChartStyler;
import org.palpate.io.file.AtomicFile;

/** Defines the style of the studies' charts and saves them. */
public final class Figures {
  /** Colours that most eyes and prints distinguish. Source: Okabe and Ito 2008. */
  private static final Color[] COLOURS = {
    new Color(0, 114, 178),
    new Color(230, 159, 0),
    new Color(0, 158, 115),
    new Color(213, 94, 0),
    new Color(204, 121, 167),
    new Color(86, 180, 233),
    new Color(0, 0, 0),
    new Color(240, 228, 66)
  };

  /** Whole numbers with commas, and fractions without powers of ten. */
  private static final String NUMBERS = "#,##0.######";

  private Figures() {}

  /**
   * Gives a chart a white background, no frames, colours for any colour vision, and decimal numbers
   * without exponents on its axes.
   */
  public static void plain(Chart<?, ?> chart) {
    if (chart.getStyler() instanceof AxesChartStyler axes) {
      axes.setXAxisDecimalPattern(NUMBERS).setYAxisDecimalPattern(NUMBERS).setLocale(Locale.ROOT);
    }
    chart.getStyler().setChartBackgroundColor(Color.WHITE);
    chart.getStyler().setPlotBackgroundColor(Color.WHITE);
    chart.getStyler().setLegendBorderColor(Color.WHITE);
    chart.getStyler().setSeriesColors(COLOURS);
  }

  /** Returns the name of a solver or method in the words of the documents. */
  public static String words(String name) {
    return name.equals("twin") ? "plain baseline" : name;
  }

  /** Saves a PNG file atomically. */
  public static void save(Chart<?, ?> chart, Path file) throws IOException {
    try (AtomicFile out = new AtomicFile(file)) {
      BitmapEncoder.saveBitmap(chart, out.stream(), BitmapFormat.PNG);
      out.commit();
    }
  }

  /** Returns the colour of a series by its number, for series that belong together. */
  public static Color colour(int number) {
    return COLOURS[number % COLOURS.length];
  }
}
