package org.palpate.benchmarks.speed;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.palpate.benchmarks.report.MachineSummary;
import org.palpate.benchmarks.report.Progress;
import org.palpate.io.file.AtomicFile;
import org.palpate.io.table.ReportJson;

/** Runs a study and writes its table as CSV and JSON, and plots, to a folder. */
public final class SpeedRun {
  private SpeedRun() {}

  /**
   * Runs a study.
   *
   * @param folder the output folder, created if missing
   * @param quick whether to use one fork and short iterations
   * @param data the folder of scans
   * @param out receives the table
   * @param progress receives progress lines
   * @return median times by condition
   */
  public static Map<String, Object> run(
      SpeedStudy study,
      Path folder,
      boolean quick,
      Path data,
      PrintWriter out,
      PrintWriter progress)
      throws IOException {
    Files.createDirectories(folder);
    Map<String, Object> machine = MachineSummary.facts();
    out.println(MachineSummary.line(machine));
    out.flush();
    SpeedRunner runner =
        new SpeedRunner(quick, data.toAbsolutePath().toString(), Progress.to(progress));
    List<SpeedRow> rows = runner.run(study.subjects(quick));
    if (study == SpeedStudy.ALL) {
      progress.println("the longest frames");
      progress.flush();
      rows.addAll(new FrameTails().rows());
    }
    if (study == SpeedStudy.SKIPS) {
      rows.addAll(new SceneSkips(quick).rows(out));
    }
    rows.forEach(row -> out.println(line(row)));
    if (study == SpeedStudy.TABLE1) {
      printPaper(out);
    }
    printAllocations(rows, out);
    study.table().write(folder, rows, SpeedRow::cells);
    writeJson(folder.resolve(study.fileStem() + ".json"), machine, rows);
    SpeedPlots.plot(folder, study, rows);
    Map<String, Object> medians = new LinkedHashMap<>();
    rows.forEach(row -> medians.put(row.name() + ", " + row.condition(), row.median()));
    return medians;
  }

  private static String line(SpeedRow row) {
    return String.format(
        Locale.ROOT,
        "%-10s %-18s %-48s %12.2f %s  (%.2f to %.2f)%s",
        row.group(),
        row.name(),
        row.condition(),
        row.median(),
        row.unit(),
        row.least(),
        row.greatest(),
        rate(row));
  }

  /** Returns frames per second for Table 1, as the paper does. */
  private static String rate(SpeedRow row) {
    return row.group().equals("table1")
        ? String.format(Locale.ROOT, "  %,.0f kHz", 1e6 / row.median())
        : "";
  }

  private static void printPaper(PrintWriter out) {
    out.println(
        "The paper, in Java on one core of a Xeon W5580, response with a real device: Head_small"
            + " 113x256x256 146 kHz, Torso 520x512x512 134 kHz, Head_big 464x532x532 141 kHz;"
            + " collision alone 750 kHz. Its other data are not public; \"to\" marks resampled"
            + " data.");
  }

  private static void printAllocations(List<SpeedRow> rows, PrintWriter out) {
    List<SpeedRow> frames = rows.stream().filter(row -> !Double.isNaN(row.bytes())).toList();
    List<SpeedRow> guilty = frames.stream().filter(row -> !row.allocatesNothing()).toList();
    out.println(
        frames.size() - guilty.size() + " of " + frames.size() + " frame benchmarks at 0 B/op");
    guilty.forEach(
        row ->
            out.printf(
                Locale.ROOT,
                "  not: %s, %s: %.2f B/op%n",
                row.name(),
                row.condition(),
                row.bytes()));
    out.flush();
  }

  static void writeJson(Path file, Map<String, Object> machine, List<SpeedRow> rows)
      throws IOException {
    Map<String, Object> report = new LinkedHashMap<>(machine);
    List<Object> entries = new ArrayList<>();
    for (SpeedRow row : rows) {
      Map<String, Object> entry = new LinkedHashMap<>();
      entry.put("group", row.group());
      entry.put("benchmark", row.name());
      entry.putAll(row.params());
      entry.put("unit", row.unit());
      entry.put("median", row.median());
      entry.put("least", row.least());
      entry.put("greatest", row.greatest());
      entry.put("bytes_per_op", row.bytes());
      entries.add(entry);
    }
    report.put("rows", entries);
    try (AtomicFile out = new AtomicFile(file)) {
      ReportJson.write(report, out.stream());
      out.commit();
    }
  }
}
