package org.palpate.benchmarks.speed;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
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
      String name = study.fileStem() + "-" + table.getKey().replace(' ', '-') + ".png";
      Figures.save(chart(table.getKey(), table.getValue()), folder.resolve(name));
    }
  }

  private static CategoryChart chart(String table, List<SpeedRow> rows) {
    Set<String> shared = shared(rows);
    CategoryChart chart =
        new CategoryChartBuilder()
            .width(WIDTH)
            .height(HEIGHT)
            .title(title(table, shared, rows.get(0)))
            .yAxisTitle(axisTitle(rows.get(0).unit()))
            .build();
    Figures.plain(chart);
    chart.getStyler().setYAxisLogarithmic(true).setXAxisLabelRotation(30);
    chart.getStyler().setPlotGridVerticalLinesVisible(false);
    chart.getStyler().setYAxisMin(rows.stream().mapToDouble(SpeedRow::median).min().orElse(1) / 2);
    Set<String> conditions = new LinkedHashSet<>();
    Map<String, Map<String, Double>> bySeries = new LinkedHashMap<>();
    for (SpeedRow row : rows) {
      List<Map.Entry<String, String>> params = List.copyOf(row.params().entrySet());
      Map.Entry<String, String> last = params.get(params.size() - 1);
      String condition =
          params.subList(0, params.size() - 1).stream()
              .filter(param -> !shared.contains(param.getKey()))
              .map(param -> words(param.getKey(), param.getValue()))
              .collect(Collectors.joining(", "));
      conditions.add(condition);
      bySeries
          .computeIfAbsent(words(last.getKey(), last.getValue()), any -> new LinkedHashMap<>())
          .put(condition, row.median());
    }
    addPublished(rows.get(0).group(), conditions, bySeries);
    bySeries.forEach(
        (series, medians) ->
            chart.addSeries(
                series, List.copyOf(conditions), conditions.stream().map(medians::get).toList()));
    return chart;
  }

  /**
   * Returns the parameters that have the same value in all rows, so that the title can name them
   * once. If all rows have the same condition, the parameters stay with the bars.
   */
  private static Set<String> shared(List<SpeedRow> rows) {
    Set<String> shared = new LinkedHashSet<>(conditionKeys(rows.get(0)));
    shared.removeIf(key -> rows.stream().map(row -> row.params().get(key)).distinct().count() > 1);
    return rows.stream().allMatch(row -> shared.containsAll(conditionKeys(row)))
        ? Set.of()
        : shared;
  }

  /** Returns the parameters of a row but the last, which has a colour. */
  private static List<String> conditionKeys(SpeedRow row) {
    List<String> keys = List.copyOf(row.params().keySet());
    return keys.subList(0, keys.size() - 1);
  }

  private static String title(String table, Set<String> shared, SpeedRow row) {
    return table
        + shared.stream()
            .map(key -> ", " + words(key, row.params().get(key)))
            .collect(Collectors.joining())
        + ": median time";
  }

  private static void addPublished(
      String group, Set<String> conditions, Map<String, Map<String, Double>> bySeries) {
    Map<String, Double> published = new LinkedHashMap<>();
    for (String condition : conditions) {
      PublishedSpeed.nanos(group, condition).ifPresent(nanos -> published.put(condition, nanos));
    }
    if (!published.isEmpty()) {
      bySeries.put(PublishedSpeed.SERIES, published);
    }
  }

  private static String axisTitle(String unit) {
    return unit.equals("ns/op") ? "median time of a frame or call, ns" : "median, " + unit;
  }

  /** Returns the value of a parameter with its unit or name. */
  private static String words(String parameter, String value) {
    return switch (parameter) {
      case "depth" -> value + " voxels deep";
      case "speed" -> value + " voxels a frame";
      case "length" -> value + " voxels long";
      case "edge" -> value + "^3 voxels";
      case "points", "threads", "objects" -> value + " " + parameter;
      default -> Figures.words(value);
    };
  }
}
