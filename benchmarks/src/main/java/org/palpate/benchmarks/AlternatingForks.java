package org.palpate.benchmarks;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.VerboseMode;
import org.palpate.loop.Median;

/**
 * Runs {@link ResponseBenchmark} with alternating solvers, each in a fresh process and for several
 * rounds, so that a disturbance of the machine affects all of them alike. Prints medians and ratios
 * to the plain baseline.
 */
public final class AlternatingForks {
  private static final String[] SOLVERS = {"twin", "guarded", "paper", "dot"};
  private static final int DEFAULT_ROUNDS = 3;

  private AlternatingForks() {}

  /** Runs the benchmark; the first argument is the number of rounds. */
  public static void main(String[] args) throws RunnerException {
    int rounds = args.length > 0 ? Integer.parseInt(args[0]) : DEFAULT_ROUNDS;
    Map<String, Map<String, List<Double>>> nanosBySceneBySolver = new TreeMap<>();
    for (int round = 0; round < rounds; round++) {
      for (String solver : SOLVERS) {
        run(solver, nanosBySceneBySolver);
      }
    }
    print(nanosBySceneBySolver, System.out);
  }

  private static void run(String solver, Map<String, Map<String, List<Double>>> into)
      throws RunnerException {
    OptionsBuilder options = new OptionsBuilder();
    options.include(ResponseBenchmark.class.getName());
    options.param("solver", solver);
    options.forks(1);
    options.jvmArgs(SessionJvm.flags().toArray(String[]::new));
    options.verbosity(VerboseMode.SILENT);
    for (RunResult result : new Runner(options.build()).run()) {
      String scene =
          result.getParams().getParam("scene") + " speed " + result.getParams().getParam("speed");
      into.computeIfAbsent(scene, any -> new TreeMap<>())
          .computeIfAbsent(solver, any -> new ArrayList<>())
          .add(result.getPrimaryResult().getScore());
    }
  }

  private static void print(Map<String, Map<String, List<Double>>> nanos, PrintStream out) {
    nanos.forEach(
        (scene, bySolver) -> {
          double baseline = median(bySolver.get(SOLVERS[0]));
          for (String solver : SOLVERS) {
            double own = median(bySolver.get(solver));
            out.printf(
                Locale.ROOT,
                "%-24s %-8s %8.1f ns  %5.2f of baseline%n",
                scene,
                solver,
                own,
                own / baseline);
          }
        });
  }

  private static double median(List<Double> values) {
    return Median.of(values.stream().mapToDouble(Double::doubleValue).toArray());
  }
}
