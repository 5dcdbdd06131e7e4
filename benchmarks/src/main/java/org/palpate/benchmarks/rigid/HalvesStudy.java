package org.palpate.benchmarks.rigid;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import org.palpate.body.BodyScene;
import org.palpate.body.GrownSolids;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/** Moves the upper half of a ball, cut along noise, back onto the lower one. */
final class HalvesStudy {
  private static final String STUDY = "halves";
  private static final int EDGE = 72;
  private static final double RADIUS = 27;
  private static final double[] NOISE_RMS = {2, 6};
  private static final int WAVES = 14;
  private static final double EXACT_MM = 0.01;
  private static final double EXACT_DEGREES = 0.01;

  /** The half begins this far off, mm, or the least farther distance that is free. */
  private static final double OFF_MM = 10;

  private static final double OFF_RAD = Math.toRadians(20);
  private static final int APPROACH_FRAMES = 600;
  private static final Vec3 APPROACH = unit(0.2, -0.15, 0.97);
  private static final Vec3 TURN = unit(0.5, -0.35, 0.79);

  private static final double LIFT_STEP_MM = 0.1;
  private static final double MOST_SIDEWAYS_MM = 2;
  private static final double MOST_LIFT_MM = 12;

  private final long seed;
  private final ToolWatch watch;
  private final Quaternion scratch = new Quaternion();

  HalvesStudy(long seed) {
    this.seed = seed;
    watch = new ToolWatch(seed);
  }

  private static Vec3 unit(double x, double y, double z) {
    Vec3 v = new Vec3(x, y, z);
    return v.mul(1 / v.length(), v);
  }

  List<RigidFigure> figures() {
    List<RigidFigure> figures = new ArrayList<>();
    for (double rms : NOISE_RMS) {
      for (boolean isSawn : new boolean[] {true, false}) {
        for (ToolClearance clearance : ToolClearance.values()) {
          figures.addAll(fit(halves(rms, isSawn), rms, isSawn, clearance));
        }
      }
    }
    figures.addAll(watch.figures("halves"));
    return figures;
  }

  private List<RigidFigure> fit(
      BitCube[] halves, double rms, boolean isSawn, ToolClearance clearance) {
    RigidTool upper = ToolSampler.ofSegment(halves[1], VoxelGrid.ofUnitVoxels(EDGE, EDGE, EDGE));
    BodyScene lower = SurfaceScene.scene(halves[0]);
    KeepOut keepOut = new KeepOut(lower, upper, clearance.clearance(lower, upper));
    Pose home = new Pose();
    upper.referenceMm(home.translation);
    boolean mustFit = isSawn || clearance == ToolClearance.POINTS;
    double mostMm = mustFit ? EXACT_MM : leastLiftMm(keepOut, home);
    ToolRun run = new ToolRun(lower, upper, clearance);
    moveBack(run, keepOut, home);
    Vec3 shift = new Vec3();
    Vec3 turn = new Vec3();
    home.differenceTo(run.motion.pose(), shift, turn, scratch);
    String condition =
        String.format(
            Locale.ROOT,
            "noise %.0f, %s, %s",
            rms,
            isSawn ? "kerf of 1 voxel" : "no kerf",
            clearance.option);
    return List.of(
        new RigidFigure(STUDY, condition, "residual", shift.length(), "mm", mostMm),
        new RigidFigure(
            STUDY,
            condition,
            "residual angle",
            Math.toDegrees(turn.length()),
            "degrees",
            mustFit ? EXACT_DEGREES : Double.NaN));
  }

  private void moveBack(ToolRun run, KeepOut keepOut, Pose home) {
    Pose device = new Pose();
    double offMm = OFF_MM;
    while (!run.solver.place(device(home, offMm, 1, device), run.motion)) {
      offMm++;
    }
    for (int frame = 1; frame <= APPROACH_FRAMES; frame++) {
      run.follow(device(home, offMm, 1 - frame / (double) APPROACH_FRAMES, device));
      watch.watch(run, keepOut, device);
    }
    watch.rest(run, device);
  }

  private Pose device(Pose home, double offMm, double part, Pose dest) {
    Vec3 shift = APPROACH.mul(offMm, new Vec3());
    Vec3 turn = TURN.mul(OFF_RAD, new Vec3());
    return home.displace(shift, turn, part, scratch, dest);
  }

  /** Returns the shortest of many displacements at which all points are free, by trying them. */
  private static double leastLiftMm(KeepOut keepOut, Pose home) {
    double least = Double.POSITIVE_INFINITY;
    Pose lifted = new Pose();
    for (double x = -MOST_SIDEWAYS_MM; x <= MOST_SIDEWAYS_MM; x += 2 * LIFT_STEP_MM) {
      for (double y = -MOST_SIDEWAYS_MM; y <= MOST_SIDEWAYS_MM; y += 2 * LIFT_STEP_MM) {
        for (double z = 0; z <= MOST_LIFT_MM; z += LIFT_STEP_MM) {
          double length = Math.sqrt(x * x + y * y + z * z);
          if (length < least) {
            lifted.set(home);
            lifted.translation.add(new Vec3(x, y, z), lifted.translation);
            least = isFree(keepOut, lifted) ? length : least;
          }
        }
      }
    }
    return least;
  }

  /** Whether points are free, as the guarantee says: one that touches a cell is not. */
  private static boolean isFree(KeepOut keepOut, Pose pose) {
    return keepOut.isFree(pose) && keepOut.isFree(pose, pose);
  }

  /** Returns the lower and the upper half. */
  private BitCube[] halves(double rms, boolean isSawn) {
    double[][] waves = waves(rms);
    BitCube lower = new BitCube(EDGE, EDGE, EDGE);
    BitCube upper = new BitCube(EDGE, EDGE, EDGE);
    double middle = EDGE / 2.0;
    for (int k = 0; k < EDGE; k++) {
      for (int j = 0; j < EDGE; j++) {
        for (int i = 0; i < EDGE; i++) {
          double x = i + 0.5 - middle;
          double y = j + 0.5 - middle;
          double z = k + 0.5 - middle;
          if (x * x + y * y + z * z < RADIUS * RADIUS) {
            (z < noise(waves, x, y) ? lower : upper).set(i, j, k);
          }
        }
      }
    }
    if (isSawn) {
      saw(lower, upper);
    }
    return new BitCube[] {lower, upper};
  }

  /** Removes the voxels of the upper half that touch the lower one. */
  private static void saw(BitCube lower, BitCube upper) {
    GrownSolids kerf = new GrownSolids(lower, new GridMetric(1, 1, 1), 1, 1);
    int pad = kerf.padVoxels();
    for (int k = 0; k < EDGE; k++) {
      for (int j = 0; j < EDGE; j++) {
        for (int i = 0; i < EDGE; i++) {
          if (kerf.cells().get(i + pad, j + pad, k + pad)) {
            upper.clear(i, j, k);
          }
        }
      }
    }
  }

  /** Returns plane waves: two wave numbers, a phase and an amplitude each. */
  private double[][] waves(double rms) {
    SplittableRandom random = new SplittableRandom(seed);
    double[][] waves = new double[WAVES][];
    for (int n = 0; n < WAVES; n++) {
      double number = 2 * Math.PI / (8 + 22 * random.nextDouble());
      double heading = 2 * Math.PI * random.nextDouble();
      waves[n] =
          new double[] {
            number * Math.cos(heading),
            number * Math.sin(heading),
            2 * Math.PI * random.nextDouble(),
            rms / Math.sqrt(WAVES / 2.0)
          };
    }
    return waves;
  }

  private static double noise(double[][] waves, double x, double y) {
    double sum = 0;
    for (double[] wave : waves) {
      sum += wave[3] * Math.sin(wave[0] * x + wave[1] * y + wave[2]);
    }
    return sum;
  }
}
