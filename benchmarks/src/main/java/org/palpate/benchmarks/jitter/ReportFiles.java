package org.palpate.benchmarks.jitter;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.HdrHistogram.Histogram;
import org.palpate.benchmarks.jitter.experiment.Experiment;
import org.palpate.benchmarks.jitter.experiment.ExperimentTable;
import org.palpate.benchmarks.report.TableFile;
import org.palpate.io.file.AtomicFile;
import org.palpate.io.table.ReportJson;

/** Writes the results of a run: tables, histograms, pictures and one page. */
final class ReportFiles {
  private static final double NANOS_PER_MICRO = 1e3;

  private final Path folder;
  private final JitterRun run;
  private final Map<String, String> machine;

  /**
   * Creates a writer.
   *
   * @param machine facts about the machine, by name
   */
  ReportFiles(Path folder, JitterRun run, Map<String, String> machine) {
    this.folder = folder;
    this.run = run;
    this.machine = machine;
  }

  /** Writes all files and replaces those of an earlier report. */
  void write() throws IOException {
    TableFile.write(
        folder.resolve("cells.csv"),
        ResultRows.columns(),
        run.results().values(),
        ResultRows::cells);
    writeHistograms();
    writeJson(folder.resolve("jitter.json"));
    Path plots = Files.createDirectories(folder.resolve("plots"));
    new JitterPlots(plots).write(run);
    AtomicFile.write(folder.resolve("index.html"), new HtmlReport(run, machine, plots).page());
  }

  private void writeHistograms() throws IOException {
    Path histograms = Files.createDirectories(folder.resolve("hgrm"));
    for (ExperimentResult result : run.results().values()) {
      String key = result.experiment().key();
      write(histograms.resolve(key + ".late.hgrm"), result.delays().lateness());
      write(histograms.resolve(key + ".late-corrected.hgrm"), result.delays().corrected());
      write(histograms.resolve(key + ".period.hgrm"), result.delays().period());
      write(histograms.resolve(key + ".work.hgrm"), result.delays().work());
    }
  }

  private static void write(Path path, Histogram histogram) throws IOException {
    try (AtomicFile file = new AtomicFile(path)) {
      PrintStream stream = new PrintStream(file.stream(), false, StandardCharsets.UTF_8);
      histogram.outputPercentileDistribution(stream, NANOS_PER_MICRO);
      stream.flush();
      file.commit();
    }
  }

  /** Writes all numbers as one JSON object. */
  void writeJson(Path path) throws IOException {
    try (AtomicFile file = new AtomicFile(path)) {
      ReportJson.write(json(), file.stream());
      file.commit();
    }
  }

  private Map<String, Object> json() {
    Map<String, Object> report = new LinkedHashMap<>();
    String version = ReportFiles.class.getPackage().getImplementationVersion();
    report.put("version", version);
    report.put("java", System.getProperty("java.version"));
    report.put("command", "jitter");
    report.put("machine", machine);
    List<Object> tables = new ArrayList<>();
    for (ExperimentTable table : run.tables()) {
      tables.add(
          Map.of(
              "name", table.name(),
              "question", table.question(),
              "cells", table.experiments().stream().map(Experiment::key).toList()));
    }
    report.put("tables", tables);
    report.put("cells", run.results().values().stream().map(ResultRows::nested).toList());
    report.put("left_out", run.skipped());
    return report;
  }
}
