package org.palpate.benchmarks.command;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import org.palpate.app.options.NumberRange;
import org.palpate.app.options.OutputOptions;
import org.palpate.app.output.Report;
import org.palpate.app.process.PalpateException;
import org.palpate.app.process.VirtualDisplay;
import org.palpate.benchmarks.accuracy.AccuracyRun;
import org.palpate.benchmarks.carve.CarveRun;
import org.palpate.benchmarks.elastic.ElasticRun;
import org.palpate.benchmarks.fracture.FractureRun;
import org.palpate.benchmarks.gpu.GpuRun;
import org.palpate.benchmarks.hold.HoldRun;
import org.palpate.benchmarks.nearest.NearestRun;
import org.palpate.benchmarks.rigid.RigidRun;
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

/** {@code palpate bench}: runs measurements and writes tables and plots to a folder. */
@Command(
    name = "bench",
    description = "Runs measurements (by default all of speed) and writes tables and plots.",
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
      "  palpate bench --rigid --quick --out figures",
      "  palpate bench --carve --quick --out figures",
      "  palpate bench --carve --frames 20000000 --seed 8",
      "  palpate bench --elastic --quick --out figures",
      "  palpate bench --fracture --quick --out figures",
      "  palpate bench --hold --out figures",
      "  palpate bench --gpu --quick --out figures",
      "  palpate bench --stress --frames 20000000 --seed 7",
      "  palpate bench --skips --scale --stability --quick"
    })
public final class BenchCommand implements Callable<Integer> {
  private static final Path DATA = Path.of(System.getProperty("palpate.data", "../shared/data"));
  private static final long DEFAULT_FRAMES = 10_000_000;
  private static final NumberRange FRAMES =
      new NumberRange("--frames", "the number of frames", 1, 1e12, "", "1000000");
  private static final long CARVED_FRAMES = 100_000_000;
  private static final long QUICK_CARVED_FRAMES = 1_000_000;
  private static final long DEFAULT_SEED = 7;
  private static final String SEEDED = "--stress, --rigid, --carve, --elastic or --fracture";
  private static final String DEFAULT_SOLVER = "guarded";

  /** One in this many frames of --stress is a whole frame, with device, edits and force. */
  private static final long WHOLE_FRAMES_DIVISOR = 10;

  @Spec private CommandSpec spec;
  @Mixin private OutputOptions output;

  @Option(
      names = "--stability",
      description =
          "Simulates person, device and contact as one closed loop: the largest stiffness without"
              + " vibration, beside the theory.")
  private boolean stability;

  @Option(
      names = "--accuracy",
      description =
          "Run time against error, for every solver and collision method, on slides along surfaces"
              + " that a formula describes; also the distance to the nearest free point at rest.")
  private boolean accuracy;

  @Option(
      names = "--rigid",
      description =
          "Rigid tools: every leg judged exactly, overlaps, frame times, forces, pegs in holes,"
              + " halves that fit, stuck frames, and published methods beside them.")
  private boolean rigid;

  @Option(
      names = "--carve",
      description =
          "Tools that cut: time of a cut, every leg judged exactly under hostile hands, edits and"
              + " undo beside protected voxels, and voxels compared with a plain copy.")
  private boolean carve;

  @Option(
      names = "--elastic",
      description =
          "Elastic segments: legs and tetrahedra judged exactly, times of frames and updates, steps"
              + " of the force, work, rest, and comparisons with formulas and finer lattices.")
  private boolean elastic;

  @Option(
      names = "--fracture",
      description =
          "Broken tubes and jaws that a simulated hand puts together: distance and angle from the"
              + " truth. The jaw is that of CThead in the folder of -Dpalpate.data"
              + " (../shared/data).")
  private boolean fracture;

  @Option(
      names = "--hold",
      description =
          "Frames of sessions in which the hand holds one of eight fragments of a bone, with a"
              + " window and without: processor time, and lateness beside the loop in C++. Draws,"
              + " so it needs OpenGL.")
  private boolean hold;

  @Option(
      names = "--gpu",
      description =
          "Legs of a tool's points judged by the CPU on one and two threads and by every OpenCL"
              + " device, against their number: round trip, launch and transfer.")
  private boolean gpu;

  @Option(
      names = "--stress",
      description = {
        "Hostile scenes and hands against the guarantee; every leg is judged exactly.",
        "A second run with the same folder continues where the first one ended."
      })
  private boolean stress;

  @Option(
      names = "--frames",
      paramLabel = "N",
      description = {
        "With --stress: total number of frames. Default: 10000000.",
        "With --carve: frames of a point that is attacked; each kind of tool is attacked in a"
            + " hundredth of them. Default: 100000000; 1000000 with --quick."
      })
  private Long frames;

  @Option(
      names = "--seed",
      paramLabel = "S",
      description =
          "With --stress, --rigid, --carve, --elastic or --fracture: seed of the attack, or of"
              + " hands and scenes. Default: 7.")
  private Long seed;

  @Option(
      names = "--solver",
      paramLabel = "NAME",
      description =
          "With --stress: guarded (all promises) or smooth (legs and rest). Default: guarded.")
  private String solver;

  @Option(
      names = "--sync",
      description =
          "Cost of scene changes for the haptic thread: direct, by the paper's synchronized"
              + " accumulators, by wait-free ones. Draws, so it needs OpenGL.")
  private boolean sync;

  @Option(
      names = "--table1",
      description =
          "The paper's Table 1 on scans, in their own size and resampled to its sizes. Reads the"
              + " folder of -Dpalpate.data (../shared/data).")
  private boolean table1;

  @Option(
      names = "--surfaces",
      description =
          "Triangles, time and memory of the scans' surfaces, in their own size and resampled to"
              + " the paper's sizes. Reads the folder of -Dpalpate.data (../shared/data).")
  private boolean surfaces;

  @Option(
      names = "--skips",
      description =
          "Gain of each skip: with and without it, where it helps and where it does not. Draws, so"
              + " it needs OpenGL.")
  private boolean skips;

  @Option(
      names = "--cpp",
      description =
          "The guarded frame against a port to C++ over the same bricks; needs g++. Both must give"
              + " the same bits.")
  private boolean cpp;

  @Option(names = "--scale", description = "The same hand in grids of 256^3 to 2048^3 voxels.")
  private boolean scale;

  @Option(names = "--quick", description = "Uses fewer values in each sweep.")
  private boolean quick;

  @Option(
      names = "--out",
      paramLabel = "DIR",
      description = "Folder of the files, created if missing. Default: palpate-bench.")
  private Path folder = Path.of("palpate-bench");

  @Override
  public Integer call() {
    output.checked(folder);
    List<SpeedStudy> speeds = speedStudies();
    Attack attack = attack();
    Path data = table1Data();
    if ((sync || skips || hold) && !GraphicsDriver.hasDisplay()) {
      return new VirtualDisplay().rerun(spec.commandLine().getParseResult().originalArgs());
    }
    Report report = new Report("bench", output.report(), List.of());
    progress().println("bench takes " + expectedDuration(speeds) + " on two processors");
    progress().flush();
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
          "a promise is broken (" + e.summary() + ")", e.caseFolder(), "see replay.txt there", e);
    } catch (GraphicsException e) {
      throw PalpateException.failed(e.what(), "bench --sync", e.remedy(), e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return PalpateException.FAILED;
    } catch (IOException e) {
      throw PalpateException.failed(
          "the measurement did not finish (" + e.getMessage() + ")",
          folder.toString(),
          "remove the cause, or choose another folder with --out",
          e);
    }
    if (report.isWanted()) {
      report.write();
    }
    return 0;
  }

  /** Returns the sum of the studies' durations as text. */
  private String expectedDuration(List<SpeedStudy> speeds) {
    List<StudyDuration> others = new ArrayList<>();
    addIf(cpp, StudyDuration.CPP, others);
    addIf(stability, StudyDuration.STABILITY, others);
    addIf(accuracy, StudyDuration.ACCURACY, others);
    addIf(rigid, StudyDuration.RIGID, others);
    addIf(carve, StudyDuration.CARVE, others);
    addIf(elastic, StudyDuration.ELASTIC, others);
    addIf(fracture, StudyDuration.FRACTURE, others);
    addIf(hold, StudyDuration.HOLD, others);
    addIf(gpu, StudyDuration.GPU, others);
    addIf(sync, StudyDuration.SYNC, others);
    addIf(surfaces, StudyDuration.SURFACES, others);
    double seconds = stress ? StudyDuration.stressSeconds(attackedFrames()) : 0;
    seconds += speeds.stream().mapToDouble(study -> study.expectedSeconds(quick)).sum();
    return StudyDuration.text(seconds, others, quick);
  }

  private static void addIf(boolean wanted, StudyDuration study, List<StudyDuration> dest) {
    if (wanted) {
      dest.add(study);
    }
  }

  private long attackedFrames() {
    return frames == null ? DEFAULT_FRAMES : frames;
  }

  private long carvedFrames() {
    return frames == null ? (quick ? QUICK_CARVED_FRAMES : CARVED_FRAMES) : frames;
  }

  private PrintWriter out() {
    return spec.commandLine().getOut();
  }

  private PrintWriter progress() {
    return spec.commandLine().getErr();
  }

  /** Returns the chosen studies of speed; all of speed if no study is chosen. */
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
    if (studies.isEmpty() && !hasOtherStudy()) {
      studies.add(SpeedStudy.ALL);
    }
    return studies;
  }

  private boolean hasOtherStudy() {
    return hasSeed() || stability || accuracy || hold || gpu || sync || cpp || surfaces;
  }

  /** Whether a study was chosen that takes a seed. */
  private boolean hasSeed() {
    return stress || rigid || carve || elastic || fracture;
  }

  private Path table1Data() {
    return table1 ? scans() : DATA;
  }

  /** Returns the folder of the scans. */
  private static Path scans() {
    if (!Files.isDirectory(DATA)) {
      throw PalpateException.wrongUse(
          "the scans of Table 1 are missing",
          DATA.toString(),
          "name their folder with -Dpalpate.data");
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
    if (rigid) {
      report.put("rigid_targets_missed", RigidRun.run(folder, quick, seed(), out(), progress()));
    }
    if (carve) {
      report.put(
          "carve_targets_missed",
          CarveRun.run(folder, quick, carvedFrames(), seed(), out(), progress()));
    }
    if (elastic) {
      report.put(
          "elastic_targets_missed", ElasticRun.run(folder, quick, seed(), out(), progress()));
    }
    if (fracture) {
      report.put(
          "fracture_targets_missed",
          FractureRun.run(DATA, folder, quick, seed(), out(), progress()));
    }
    if (hold) {
      report.put("hold_targets_missed", HoldRun.run(folder, quick, out(), progress()));
    }
    if (gpu) {
      report.put("gpus_measured", GpuRun.run(folder, quick, out(), progress()));
    }
    if (sync) {
      report.put("sync_work_p99_us", SyncRun.run(folder, quick, out(), progress()));
    }
    if (surfaces) {
      report.put("triangles", SurfaceStudy.run(scans(), folder, out(), progress()));
    }
  }

  /** Returns the chosen attack, or null; without one its options are refused. */
  private Attack attack() {
    FRAMES.checkGiven(frames);
    if (!stress) {
      refuse("--frames", carve ? null : frames, "--stress or --carve");
      refuse("--seed", hasSeed() ? null : seed, SEEDED);
      refuse("--solver", solver, "--stress");
      return null;
    }
    return new Attack(attackedFrames(), seed(), solverUnderAttack());
  }

  private long seed() {
    return seed == null ? DEFAULT_SEED : seed;
  }

  private static void refuse(String option, Object given, String needed) {
    if (given != null) {
      throw PalpateException.wrongUse(
          "this option needs " + needed,
          option + " " + given,
          "add " + needed + ", or remove the option");
    }
  }

  private StressSession.Attacked solverUnderAttack() {
    String name = solver == null ? DEFAULT_SOLVER : solver;
    return switch (name) {
      case "guarded" -> StressSession.Attacked.GUARDED;
      case "smooth" -> StressSession.Attacked.SMOOTH;
      default ->
          throw PalpateException.wrongUse(
              "no such solver to attack", "--solver " + name, "choose guarded or smooth");
    };
  }

  /** The attack of --stress. */
  private final class Attack {
    private final long frameCount;
    private final long attackSeed;
    private final StressSession.Attacked attacked;

    Attack(long frameCount, long attackSeed, StressSession.Attacked attacked) {
      this.frameCount = frameCount;
      this.attackSeed = attackSeed;
      this.attacked = attacked;
    }

    void run(Report report) throws IOException {
      StressSession session = new StressSession(folder, attackSeed, attacked, progress());
      StressTotals totals = session.run(frameCount);
      out()
          .println(
              attacked
                  + ": "
                  + totals.frames()
                  + " frames, "
                  + totals.legs()
                  + " legs, 0 violations, seed "
                  + attackSeed);
      out().println(session.attackFrames(frameCount / WHOLE_FRAMES_DIVISOR));
      out().println();
      session.printWork(out());
      out().println();
      session.printBaselines(out());
      report.put("seed", attackSeed).put("frames", totals.frames()).put("legs", totals.legs());
      report.put("violations", 0).put("exact_decisions", totals.exactDecisions());
    }
  }
}
