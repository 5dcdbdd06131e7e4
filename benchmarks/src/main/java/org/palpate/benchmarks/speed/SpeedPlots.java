package org.palpate.benchmarks.speed;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.knowm.xchart.CategoryChart;
import org.knowm.xchart.CategoryChartBuilder;
import org.palpate.benchmarks.report.Figures;

/**
 * Plots each table: a group of bars for each condition, and a colour for each value of the last
 * varied parameter.
 */
final class SpeedPlots {
  private static final int WIDTH = 1200;
  private static final int HEIGHT = 640;

  private SpeedPlots() {}

  /** Writes the plots of a study's tables to a folder. */
  static void plot(Path folder, SpeedStudy study, List<SpeedRow> rows) throws IOException {
    Map<String, List<SpeedRow>> tables = new LinkedHashMap<>();
    for (SpeedRow row : rows) {
      if (row.params().size() > 1) {
        String table = row.group() + (row.unit().equals("ns/op") ? "" : " " + row.name());
        tables.computeIfAbsent(table, any -> new ArrayList<>()).add(row);
      }
    }
    for (Map.Entry<String, List<SpeedRow>> table : tables.entrySet()) {
      String name = study.fileName() + "-" + table.getKey().replace(' ', '-') + ".png";
      Figures.save(chart(table.getKey(), table.getValue()), folder.resolve(name));
    }
  }

  private static CategoryChart chart(String title, List<SpeedRow> rows) {
    CategoryChart chart =
        new CategoryChartBuilder()
            .width(WIDTH)
            .height(HEIGHT)
            .title(title + ": median time")
            .yAxisTitle(rows.get(0).unit())
            .build();
    Figures.plain(chart);
    chart.getStyler().setYAxisLogarithmic(true).setXAxisLabelRotation(30);
    chart.getStyler().setPlotGridVerticalLinesVisible(false);
    chart.getStyler().setYAxisMin(rows.stream().mapToDouble(SpeedRow::median).min().orElse(1) / 2);
    Set<String> conditions = new LinkedHashSet<>();
    Map<String, Map<String, Double>> bySeries = new LinkedHashMap<>();
    for (SpeedRow row : rows) {
      List<String> values = List.copyOf(row.params().values());
      String condition = String.join(", ", values.subList(0, values.size() - 1));
      conditions.add(condition);
      bySeries
          .computeIfAbsent(values.get(values.size() - 1), any -> new LinkedHashMap<>())
          .put(condition, row.median());
    }
    bySeries.forEach(
        (series, medians) ->
            chart.addSeries(
                series, List.copyOf(conditions), conditions.stream().map(medians::get).toList()));
    return chart;
  }
}
