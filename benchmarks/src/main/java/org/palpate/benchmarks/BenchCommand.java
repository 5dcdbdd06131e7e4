package org.palpate.benchmarks;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import org.palpate.app.OutputOptions;
import org.palpate.app.PalpateException;
import org.palpate.app.Report;
import org.palpate.benchmarks.accuracy.AccuracyRun;
import org.palpate.benchmarks.stability.StabilityRun;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code palpate bench}: measurements that leave tables and plots in a folder. */
@Command(
    name = "bench",
    description = "Measures, and leaves tables and plots in a folder.",
    footer = {
      "",
      "Examples:",
      "  palpate bench --stability --out figures",
      "  palpate bench --stability --quick --out figures",
      "  palpate bench --accuracy --out figures"
    })
public final class BenchCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;
  @Mixin private OutputOptions output;

  @Option(
      names = "--stability",
      description = {
        "Person, device and contact as one loop in simulation:",
        "how stiff a surface may be before the hand shakes, beside the theory."
      })
  private boolean stability;

  @Option(
      names = "--accuracy",
      description = {
        "Run time against error, for every solver and collision method:",
        "solvers pressed into surfaces known by formula and slid along them."
      })
  private boolean accuracy;

  @Option(names = "--quick", description = "Fewer values in each sweep.")
  private boolean quick;

  @Option(
      names = "--out",
      paramLabel = "DIR",
      required = true,
      description = "Where tables and plots go; made where it is not there.")
  private Path folder;

  @Override
  public Integer call() {
    if (!stability && !accuracy) {
      throw PalpateException.wrongUse(
          "nothing to measure was chosen", "bench", "add --stability or --accuracy");
    }
    PrintWriter out = spec.commandLine().getOut();
    PrintWriter progress = spec.commandLine().getErr();
    Report report = new Report("bench", output.report(), List.of());
    try {
      if (stability) {
        report.put("least_margin", StabilityRun.run(folder, quick, out, progress));
      }
      if (accuracy) {
        report.put("time_over_twin", AccuracyRun.run(folder, quick, out, progress));
      }
    } catch (IOException e) {
      throw PalpateException.failed(
          "cannot write", folder.toString(), "choose a folder that may be written to", e);
    }
    if (report.isWanted()) {
      report.write();
    }
    return 0;
  }
}
