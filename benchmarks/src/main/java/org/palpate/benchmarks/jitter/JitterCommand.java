package org.palpate.benchmarks.jitter;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.regex.Pattern;
import java.util.regex.PatternSyntaxException;
import org.palpate.app.options.NumberRange;
import org.palpate.app.options.OutputOptions;
import org.palpate.app.options.VolumeOptions;
import org.palpate.app.process.PalpateException;
import org.palpate.benchmarks.jitter.experiment.Experiment;
import org.palpate.benchmarks.jitter.experiment.ExperimentRunner;
import org.palpate.benchmarks.jitter.experiment.ExperimentScene;
import org.palpate.benchmarks.jitter.experiment.ExperimentTable;
import org.palpate.benchmarks.jitter.experiment.ExperimentTables;
import org.palpate.benchmarks.jitter.experiment.Jdk;
import org.palpate.benchmarks.jitter.experiment.Jdks;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code palpate jitter}: measures how late JVMs run a frame, and finds the causes. */
@Command(
    name = "jitter",
    description = {
      "Measures how late this JVM wakes up and runs a frame, and finds the causes. Each experiment"
          + " runs in a fresh process: JDKs, collectors, waits, scheduling and workloads, beside"
          + " the same loop in C++.",
      "A second run with the same folder continues where the first one ended."
    },
    footer = {
      "",
      "Examples:",
      "  palpate jitter --quick --out jitter",
      "  palpate jitter --out jitter --table waits --table collectors",
      "  palpate jitter --out jitter --jdk /opt/jdk-25 --cells '.*zgc-hybrid-fifo.*' --seconds 60",
      "  palpate jitter --out jitter --table rates --volume CThead.nrrd --segment 'bone=>=1500'",
      "  palpate jitter --out jitter --minutes 20",
      "  palpate jitter --out jitter --list"
    })
public final class JitterCommand implements Callable<Integer> {
  private static final NumberRange SECONDS =
      new NumberRange("--seconds", "the measured time", 1, 86_400, "s", "10");
  private static final NumberRange MINUTES =
      new NumberRange("--minutes", "the time", 0, 1_000_000, "minutes", "20");
  private static final NumberRange HEAP =
      new NumberRange("--heap", "the heap", 128, 65_536, "MB", "512");
  private static final int QUICK_SECONDS = 3;
  // Processes start slowly on a busy machine; the last experiment and the report fit into two
  // minutes.
  private static final double QUICK_BUDGET_SECONDS = 90;
  private static final int DEFAULT_SECONDS = 10;

  @Spec private CommandSpec spec;

  @Mixin private VolumeOptions volume;

  @Mixin private OutputOptions output;

  @Option(
      names = "--out",
      paramLabel = "DIR",
      required = true,
      description = "Folder of the files.")
  private Path folder;

  @Option(names = "--quick", description = "Runs a dozen experiments in under two minutes.")
  private boolean quick;

  @Option(
      names = "--table",
      paramLabel = "NAME",
      description =
          "Only this table; may be given again. One of: machine, recommended, rates, simplest,"
              + " waits, collectors, workloads, compilers, heaps.")
  private List<String> tables = new ArrayList<>();

  @Option(
      names = "--cells",
      paramLabel = "REGEX",
      description = "Only experiments whose name matches; --list shows the names.")
  private String namePattern = ".*";

  @Option(
      names = "--jdk",
      paramLabel = "DIR",
      description =
          "A Java installation; may be given again. Default: the newest one found of every"
              + " release.")
  private List<Path> homes = new ArrayList<>();

  @Option(
      names = "--seconds",
      paramLabel = "S",
      description = "Measured time of an experiment. Default: 10; 3 with --quick.")
  private Integer seconds;

  @Option(
      names = "--minutes",
      paramLabel = "M",
      description =
          "Starts no experiment after this time and then reports the results; 0 reports those of an"
              + " earlier run. Default: no end; 1.5 with --quick.")
  private Double minutes;

  @Option(names = "--heap", paramLabel = "MB", description = "Heap of an experiment. Default: 512.")
  private int heapMb = 512;

  @Option(names = "--list", description = "Lists the experiments and their duration, and ends.")
  private boolean list;

  @Override
  public Integer call() throws Exception {
    PrintWriter out = spec.commandLine().getOut();
    check();
    List<ExperimentTable> chosen = chosenTables();
    List<Experiment> all = JitterRun.experiments(chosen);
    if (all.isEmpty()) {
      throw PalpateException.wrongUse(
          "no experiment matches", namePattern, "--list shows their names");
    }
    out.println(all.size() + " experiments, about " + JitterRun.minutes(JitterRun.secondsFor(all)));
    if (list) {
      all.forEach(experiment -> out.println("  " + experiment.key()));
      return 0;
    }
    return measure(chosen, out);
  }

  private void check() {
    SECONDS.checkGiven(seconds);
    HEAP.check(heapMb);
    MINUTES.checkGiven(minutes);
    output.checked(folder);
  }

  private int measure(List<ExperimentTable> chosen, PrintWriter out)
      throws IOException, InterruptedException {
    String scene = ExperimentScene.textOf(volume);
    ExperimentScene.check(scene);
    Path root = Files.createDirectories(folder).toRealPath();
    var machine = MachineFacts.read();
    JitterRun run = new JitterRun(chosen, new ExperimentRunner(root, scene), budgetSeconds(), out);
    run.run();
    if (run.results().isEmpty()) {
      String first = run.skipped().values().iterator().next();
      throw PalpateException.failed("no experiment ran", first, "look into " + root, null);
    }
    ReportFiles files = new ReportFiles(root, run, machine);
    files.write();
    if (output.report().isPresent()) {
      files.writeJson(output.report().get());
    }
    out.println(root.resolve("index.html"));
    return 0;
  }

  private double budgetSeconds() {
    if (minutes != null) {
      return 60 * minutes;
    }
    return quick ? QUICK_BUDGET_SECONDS : Double.POSITIVE_INFINITY;
  }

  private List<ExperimentTable> chosenTables() {
    List<Jdk> jdks = jdks();
    int chosenSeconds = seconds != null ? seconds : quick ? QUICK_SECONDS : DEFAULT_SECONDS;
    ExperimentTables known = new ExperimentTables(jdks, heapMb, chosenSeconds);
    for (String name : tables) {
      if (!ExperimentTables.NAMES.contains(name)) {
        throw PalpateException.wrongUse(
            "no such table", name, "choose one of " + String.join(", ", ExperimentTables.NAMES));
      }
    }
    List<ExperimentTable> all = quick ? known.quick() : known.all();
    return all.stream()
        .filter(table -> tables.isEmpty() || tables.contains(table.name()))
        .map(this::matching)
        .filter(table -> !table.experiments().isEmpty())
        .toList();
  }

  private ExperimentTable matching(ExperimentTable table) {
    Pattern pattern;
    try {
      pattern = Pattern.compile(namePattern);
    } catch (PatternSyntaxException e) {
      throw PalpateException.wrongUse(
          e.getDescription(), "--cells " + namePattern, "give a regular expression", e);
    }
    List<Experiment> found =
        table.experiments().stream()
            .filter(experiment -> pattern.matcher(experiment.key()).matches())
            .toList();
    return new ExperimentTable(table.name(), table.question(), found);
  }

  private List<Jdk> jdks() {
    if (homes.isEmpty()) {
      return Jdks.found();
    }
    List<Jdk> jdks = new ArrayList<>();
    for (Path home : homes) {
      try {
        jdks.add(Jdk.at(home));
      } catch (IOException e) {
        throw PalpateException.wrongUse(
            "no Java installation", home.toString(), "give the folder that holds bin/java", e);
      }
    }
    return jdks;
  }
}
