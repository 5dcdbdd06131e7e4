package org.palpate.benchmarks.command;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import org.palpate.app.options.OutputOptions;
import org.palpate.app.output.Report;
import org.palpate.app.process.PalpateException;
import org.palpate.app.process.VirtualDisplay;
import org.palpate.benchmarks.accuracy.AccuracyRun;
import org.palpate.benchmarks.nearest.NearestRun;
import org.palpate.benchmarks.speed.CppComparison;
import org.palpate.benchmarks.speed.SpeedRun;
import org.palpate.benchmarks.speed.SpeedStudy;
import org.palpate.benchmarks.stability.StabilityRun;
import org.palpate.benchmarks.stress.StressSession;
import org.palpate.benchmarks.stress.StressTotals;
import org.palpate.benchmarks.surface.SurfaceStudy;
import org.palpate.benchmarks.sync.SyncRun;
import org.palpate.scene.window.GraphicsDriver;
import org.palpate.scene.window.GraphicsException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code palpate bench}: measurements that leave tables and plots in a folder. */
@Command(
    name = "bench",
    description =
        "Measures, the speed of all unless told what, and leaves tables and plots in a folder.",
    footer = {
      "",
      "Examples:",
      "  palpate bench --quick --out figures",
      "  palpate bench --table1 --out figures",
      "  palpate bench --skips --out figures",
      "  palpate bench --scale --out figures",
      "  palpate bench --cpp --out figures",
      "  palpate bench --stability --out figures",
      "  palpate bench --stability --quick --out figures",
      "  palpate bench --accuracy --out figures",
      "  palpate bench --sync --out figures",
      "  palpate bench --surfaces --out figures",
      "  palpate bench --stress --frames 20000000 --seed 7",
      "  palpate bench --skips --scale --stability --quick"
    })
public final class BenchCommand implements Callable<Integer> {
  private static final Path DATA = Path.of(System.getProperty("palpate.data", "../shared/data"));
  private static final long USUAL_FRAMES = 10_000_000;
  private static final long USUAL_SEED = 7;
  private static final String USUAL_SOLVER = "guarded";

  /** Of the frames of --stress so many run whole, with device, edits and force. */
  private static final long WHOLE_FRAMES_SHARE = 10;

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
        "solvers pressed into surfaces known by formula and slid along them;",
        "and how far from the nearest free point they come to rest."
      })
  private boolean accuracy;

  @Option(
      names = "--stress",
      description = {
        "Hostile scenes and hands against the guarantee, every leg judged exactly.",
        "Run again with the same folder, it goes on where it ended."
      })
  private boolean stress;

  @Option(
      names = "--frames",
      paramLabel = "N",
      description = "With --stress: frames in all (10000000).")
  private Long frames;

  @Option(names = "--seed", paramLabel = "S", description = "With --stress: which attack (7).")
  private Long seed;

  @Option(
      names = "--solver",
      paramLabel = "NAME",
      description =
          "With --stress: guarded (every promise) or smooth (its legs). Default: guarded.")
  private String solver;

  @Option(
      names = "--sync",
      description = {
        "What changing the scene costs the haptic thread: directly, by the paper's",
        "synchronized accumulators, by wait-free ones. Draws, so it needs OpenGL."
      })
  private boolean sync;

  @Option(
      names = "--table1",
      description = {
        "The paper's Table 1 on scans, as they are and resampled to its sizes.",
        "Reads the folder of -Dpalpate.data (../shared/data)."
      })
  private boolean table1;

  @Option(
      names = "--surfaces",
      description = {
        "Triangles, time and memory of the scans' surfaces, as they are and resampled to the",
        "paper's sizes. Reads the folder of -Dpalpate.data (../shared/data)."
      })
  private boolean surfaces;

  @Option(
      names = "--skips",
      description = {
        "What each skip is worth: with and without, where it helps and where not.",
        "Draws, so it needs OpenGL."
      })
  private boolean skips;

  @Option(
      names = "--cpp",
      description = {
        "The guarded frame against the same in C++ over the same bricks; needs g++.",
        "Both must take the same way to the bit."
      })
  private boolean cpp;

  @Option(names = "--scale", description = "The same hand in grids of 256^3 to 2048^3 voxels.")
  private boolean scale;

  @Option(names = "--quick", description = "Fewer values in each sweep.")
  private boolean quick;

  @Option(
      names = "--out",
      paramLabel = "DIR",
      description = "Where files go (palpate-bench); made where it is not there.")
  private Path folder = Path.of("palpate-bench");

  @Override
  public Integer call() {
    output.checked(folder);
    List<SpeedStudy> speeds = speedStudies();
    Attack attack = attack();
    Path data = dataOfTable1();
    if ((sync || skips) && !GraphicsDriver.hasDisplay()) {
      return new VirtualDisplay().rerun(spec.commandLine().getParseResult().originalArgs());
    }
    Report report = new Report("bench", output.report(), List.of());
    try {
      for (SpeedStudy study : speeds) {
        report.put(
            study.name().toLowerCase(Locale.ROOT),
            SpeedRun.run(study, folder, quick, data, out(), progress()));
      }
      measureOthers(report);
      if (attack != null) {
        attack.run(report);
      }
    } catch (StressSession.FailedCaseException e) {
      throw PalpateException.failed(
          "a promise was broken (" + e.summary() + ")", e.place(), "see replay.txt there", e);
    } catch (GraphicsException e) {
      throw PalpateException.failed(e.what(), "bench --sync", e.remedy(), e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return PalpateException.FAILED;
    } catch (IOException e) {
      throw PalpateException.failed(
          "not measured to the end (" + e.getMessage() + ")",
          folder.toString(),
          "mend that, or choose another folder with --out",
          e);
    }
    if (report.isWanted()) {
      report.write();
    }
    return 0;
  }

  private PrintWriter out() {
    return spec.commandLine().getOut();
  }

  private PrintWriter progress() {
    return spec.commandLine().getErr();
  }

  /** The studies of speed that were chosen; all of it where nothing at all was. */
  private List<SpeedStudy> speedStudies() {
    List<SpeedStudy> studies = new ArrayList<>();
    if (table1) {
      studies.add(SpeedStudy.TABLE1);
    }
    if (skips) {
      studies.add(SpeedStudy.SKIPS);
    }
    if (scale) {
      studies.add(SpeedStudy.SCALE);
    }
    if (studies.isEmpty() && !stability && !accuracy && !sync && !stress && !cpp && !surfaces) {
      studies.add(SpeedStudy.ALL);
    }
    return studies;
  }

  private Path dataOfTable1() {
    return table1 ? scans() : DATA;
  }

  /** The folder of the scans. */
  private static Path scans() {
    if (!Files.isDirectory(DATA)) {
      throw PalpateException.wrongUse(
          "the scans of Table 1 are not there",
          DATA.toString(),
          "name their folder: -Dpalpate.data");
    }
    return DATA;
  }

  private void measureOthers(Report report)
      throws IOException, InterruptedException, GraphicsException {
    if (cpp) {
      report.put("java_over_cpp", CppComparison.run(folder, out()));
    }
    if (stability) {
      report.put("least_margin", StabilityRun.run(folder, quick, out(), progress()));
    }
    if (accuracy) {
      report.put("time_over_twin", AccuracyRun.run(folder, quick, out(), progress()));
      NearestRun.run(folder, quick, out(), progress());
    }
    if (sync) {
      report.put("sync_work_p99_us", SyncRun.run(folder, quick, out(), progress()));
    }
    if (surfaces) {
      report.put("triangles", SurfaceStudy.run(scans(), folder, out(), progress()));
    }
  }

  /** The attack that was asked for, or null; refuses its options where it was not. */
  private Attack attack() {
    if (!stress) {
      refuseWithoutStress("--frames", frames);
      refuseWithoutStress("--seed", seed);
      refuseWithoutStress("--solver", solver);
      return null;
    }
    if (frames != null && frames < 1) {
      throw PalpateException.wrongUse(
          "a positive number is needed", "--frames " + frames, "try --frames 1000000");
    }
    return new Attack(
        frames == null ? USUAL_FRAMES : frames,
        seed == null ? USUAL_SEED : seed,
        solverUnderAttack());
  }

  private static void refuseWithoutStress(String option, Object given) {
    if (given != null) {
      throw PalpateException.wrongUse(
          "this belongs to --stress, which was not asked for",
          option + " " + given,
          "add --stress, or leave it out");
    }
  }

  private StressSession.Attacked solverUnderAttack() {
    String name = solver == null ? USUAL_SOLVER : solver;
    return switch (name) {
      case "guarded" -> StressSession.Attacked.GUARDED;
      case "smooth" -> StressSession.Attacked.SMOOTH;
      default ->
          throw PalpateException.wrongUse(
              "no solver to attack", "--solver " + name, "choose guarded or smooth");
    };
  }

  /** What --stress does. */
  private final class Attack {
    private final long wanted;
    private final long ofSeed;
    private final StressSession.Attacked attacked;

    Attack(long wanted, long ofSeed, StressSession.Attacked attacked) {
      this.wanted = wanted;
      this.ofSeed = ofSeed;
      this.attacked = attacked;
    }

    void run(Report report) throws IOException {
      StressSession session = new StressSession(folder, ofSeed, attacked, progress());
      StressTotals totals = session.run(wanted);
      out()
          .println(
              attacked
                  + ": "
                  + totals.frames()
                  + " frames, "
                  + totals.legs()
                  + " legs, 0 violations, seed "
                  + ofSeed);
      out().println(session.attackFrames(wanted / WHOLE_FRAMES_SHARE));
      out().println();
      session.tellSteps(out());
      out().println();
      session.printBaselines(out());
      report.put("seed", ofSeed).put("frames", totals.frames()).put("legs", totals.legs());
      report.put("violations", 0).put("exact_decisions", totals.exactDecisions());
    }
  }
}
