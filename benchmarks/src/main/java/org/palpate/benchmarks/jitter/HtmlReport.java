package org.palpate.benchmarks.jitter;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.HdrHistogram.Histogram;
import org.palpate.benchmarks.jitter.experiment.Experiment;
import org.palpate.benchmarks.jitter.experiment.ExperimentTable;
import org.palpate.benchmarks.jitter.experiment.JvmCommand;
import org.palpate.benchmarks.jitter.trace.Cause;
import org.palpate.benchmarks.jitter.trace.CauseCounts;
import org.palpate.benchmarks.jitter.trace.DelayHistograms;

/** The report as one HTML page that contains its pictures and needs no network. */
final class HtmlReport {
  private static final double NANOS_PER_MICRO = 1e3;
  private static final List<Double> PERCENTILES = List.of(50.0, 99.0, 99.9, 99.99, 99.999);
  private static final String STYLE =
      "body{font:15px/1.45 system-ui,sans-serif;max-width:1160px;margin:2em auto;padding:0 1em;"
          + "color:#222}table{border-collapse:collapse;font-size:13px;margin:1em 0}"
          + "td,th{border-bottom:1px solid #ddd;padding:3px 8px;text-align:right}"
          + "td:first-child,th:first-child,.l{text-align:left}th{background:#f4f4f4}"
          + "img{max-width:100%;display:block}summary{cursor:pointer}.bad{color:#b00020}";

  private final JitterRun run;
  private final Map<String, String> machine;
  private final Path plots;
  private final StringBuilder html = new StringBuilder();

  /**
   * Creates the report of a run.
   *
   * @param machine facts about the machine, by name
   * @param plots the folder of the pictures
   */
  HtmlReport(JitterRun run, Map<String, String> machine, Path plots) {
    this.run = run;
    this.machine = machine;
    this.plots = plots;
  }

  /** Returns the page. */
  String page() throws IOException {
    html.append("<!doctype html><html lang=\"en\"><meta charset=\"utf-8\">")
        .append("<title>How late is this JVM?</title><style>" + STYLE + "</style>")
        .append("<h1>How late is this JVM?</h1>")
        .append("<p>Each row is a loop in a fresh process, at 1 kHz unless its name has another")
        .append(" rate. Late is the time from a deadline to the start of its frame. The curves")
        .append(" are corrected for frames that the loop omitted while it was delayed")
        .append(" (coordinated omission); the tables show both. A percentile that needs more")
        .append(" frames than an experiment has equals its maximum.</p>");
    addMachine();
    for (ExperimentTable table : run.tables()) {
      addTable(table);
    }
    addExperiments();
    addSkipped();
    return html.append("</html>\n").toString();
  }

  private void addMachine() {
    html.append("<table>");
    machine.forEach(
        (name, value) ->
            html.append("<tr><th>")
                .append(escaped(name.replace('_', ' ')))
                .append("</th><td class=l>")
                .append(escaped(value))
                .append("</td></tr>"));
    html.append("</table>");
  }

  private void addTable(ExperimentTable table) throws IOException {
    html.append("<h2>").append(escaped(table.name())).append("</h2><p>");
    html.append(escaped(table.question())).append("</p>");
    addPicture(JitterPlots.curvesName(table));
    html.append("<table><tr><th>experiment</th>");
    PERCENTILES.forEach(p -> html.append("<th>p").append(number(p)).append("</th>"));
    html.append("<th>max</th><th>corrected p99.9</th><th>work p99.9</th><th>omitted</th>");
    html.append("<th>&gt; 1.5 ms</th><th>&gt; 10 ms</th><th class=l>causes of the worst ten</th>");
    html.append("<th>machine busy</th></tr>");
    for (Experiment experiment : table.experiments()) {
      ExperimentResult result = run.results().get(experiment.key());
      if (result != null) {
        addRow(result);
      }
    }
    html.append("</table>");
  }

  private void addRow(ExperimentResult result) {
    DelayHistograms delays = result.delays();
    html.append("<tr><td><a href=\"#" + result.experiment().key() + "\">")
        .append(escaped(result.experiment().key()))
        .append("</a></td>");
    PERCENTILES.forEach(p -> addCell(micros(delays.lateness(), p)));
    addCell(number(delays.lateness().getMaxValue() / NANOS_PER_MICRO));
    addCell(micros(delays.corrected(), 99.9));
    addCell(micros(delays.work(), 99.9));
    addCell(Long.toString(delays.omitted()));
    addCell(Long.toString(delays.overOneAndAHalfMillis()));
    addCell(Long.toString(delays.overTenMillis()));
    html.append("<td class=l>").append(escaped(CauseCounts.text(result.causes()))).append("</td>");
    addCell(Math.round(100 * result.machine().busyFraction()) + " %");
    html.append("</tr>");
  }

  private void addExperiments() throws IOException {
    html.append("<h2>Experiments</h2>");
    for (ExperimentResult result : run.results().values()) {
      html.append("<details id=\"" + result.experiment().key() + "\"><summary>")
          .append(escaped(result.experiment().key()))
          .append("</summary>");
      addPicture(JitterPlots.timelineName(result.experiment()));
      addCauses(result);
      addOutcome(result);
      html.append("</details>");
    }
  }

  private void addCauses(ExperimentResult result) {
    html.append("<table><tr><th>at, s</th><th>late, us</th><th>work, us</th>");
    html.append("<th class=l>cause</th><th class=l>evidence</th></tr>");
    for (Cause cause : result.causes()) {
      html.append("<tr>");
      addCell(number((cause.dueNanos() - result.firstDueNanos()) / 1e9));
      addCell(number(cause.latenessNanos() / NANOS_PER_MICRO));
      addCell(number(cause.workNanos() / NANOS_PER_MICRO));
      html.append("<td class=l>").append(escaped(cause.kind().label())).append("</td>");
      html.append("<td class=l>").append(escaped(cause.evidence())).append("</td></tr>");
    }
    html.append("</table>");
  }

  private void addOutcome(ExperimentResult result) {
    html.append("<p>");
    result.outcome().stringPropertyNames().stream()
        .sorted()
        .forEach(name -> html.append(escaped(name + ": " + result.outcome(name))).append("<br>"));
    if (!result.experiment().isControl()) {
      html.append("<code>")
          .append(escaped(String.join(" ", JvmCommand.flags(result.experiment()))))
          .append("</code>");
    }
    html.append("</p>");
  }

  private void addSkipped() {
    if (!run.skipped().isEmpty()) {
      html.append("<h2>Skipped</h2><ul>");
      run.skipped()
          .forEach(
              (key, why) ->
                  html.append("<li class=bad>").append(escaped(key + ": " + why)).append("</li>"));
      html.append("</ul>");
    }
  }

  private void addPicture(String name) throws IOException {
    Path picture = plots.resolve(name);
    if (Files.exists(picture)) {
      String bytes = Base64.getEncoder().encodeToString(Files.readAllBytes(picture));
      html.append("<img loading=lazy alt=\"" + name + "\" src=\"data:image/png;base64,")
          .append(bytes)
          .append("\">");
    }
  }

  private void addCell(String text) {
    html.append("<td>").append(escaped(text)).append("</td>");
  }

  private static String micros(Histogram histogram, double percentile) {
    return number(histogram.getValueAtPercentile(percentile) / NANOS_PER_MICRO);
  }

  private static String number(double value) {
    return value == Math.rint(value)
        ? Long.toString((long) value)
        : String.format(Locale.ROOT, value < 100 ? "%.2f" : "%.0f", value);
  }

  static String escaped(String text) {
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
  }
}
