package org.palpate.benchmarks.nearest;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import org.palpate.benchmarks.baseline.PlainBaseline;
import org.palpate.benchmarks.baseline.PlainBaselineSolver;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.proxy.reference.BorderVoxels;
import org.palpate.proxy.reference.DotSolver;
import org.palpate.proxy.reference.PaperSolver;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.raycast.SampledRayCaster;

/** Presses every solver into every shape at every depth and measures its resting point. */
final class NearestStudy {
  static final double[] DEPTHS = {1, 2, 5, 10, 15, 20};

  /**
   * The name of an exhaustive search for the free point nearest to the device. It looks within
   * sqrt(2 s + 1) voxels of the resting point of the guarded solver, at a device depth of s voxels.
   */
  static final String SEARCH = "search sqrt(2s+1)";

  /** The name of the smooth solver if its surface height is subtracted, as the force does it. */
  static final String SMOOTH_FELT = "smooth felt";

  private static final String SMOOTH = "smooth";
  private static final String GUARDED = "guarded";

  private static final GridMetric UNIT = new GridMetric(1, 1, 1);
  private static final double MAX_STEP_VOXELS = 8;

  /** Frames with a resting device; the paper's solver as printed never rests on a slope. */
  private static final int FRAMES_AT_REST = 200;

  private final int presses;
  private final long seed;
  private final Consumer<String> progress;

  /** Creates a study. */
  NearestStudy(int presses, long seed, Consumer<String> progress) {
    this.presses = presses;
    this.seed = seed;
    this.progress = progress;
  }

  /** Measures all rows. */
  List<NearestRow> rows() {
    Map<String, ExcessSum> sums = new LinkedHashMap<>();
    for (PressedSolid solid : PressedSolid.all()) {
      progress.accept("nearest free point: " + solid.shape());
      for (double depth : DEPTHS) {
        SplittableRandom random = new SplittableRandom(seed);
        for (int n = 0; n < presses; n++) {
          press(solid, depth, PressTrajectory.positions(solid, depth, random), sums);
        }
      }
    }
    List<NearestRow> rows = new ArrayList<>();
    sums.values().forEach(sum -> rows.add(sum.row()));
    return rows;
  }

  private static void press(
      PressedSolid solid, double depth, List<Vec3> devices, Map<String, ExcessSum> sums) {
    Vec3 device = devices.get(devices.size() - 1);
    NearestFreeOracle free = new NearestFreeOracle(solid.bits());
    double nearest = free.distance(device);
    solvers(solid)
        .forEach(
            (name, solver) -> {
              InteractionPoint point =
                  rest(solver, new CollisionScene(List.of(solid.bits())), devices);
              Vec3 p = point.position;
              double reached = p.sub(device, new Vec3()).length();
              sumFor(sums, solid, depth, name).add(reached - nearest);
              if (name.equals(GUARDED)) {
                double found = free.distance(device, p, Math.sqrt(2 * depth + 1));
                sumFor(sums, solid, depth, SEARCH).add(Math.min(found, reached) - nearest);
              }
              if (name.equals(SMOOTH)) {
                double felt = reached - point.surfaceHeightMm;
                sumFor(sums, solid, depth, SMOOTH_FELT).add(felt - nearest);
              }
            });
  }

  private static Map<String, ProxySolver> solvers(PressedSolid solid) {
    SampledRayCaster sampled = new SampledRayCaster(1);
    BorderVoxels border = BorderVoxels.onTheFly();
    Map<String, ProxySolver> solvers = new LinkedHashMap<>();
    solvers.put(
        "plain baseline",
        new PlainBaselineSolver(new PlainBaseline(solid.bits(), MAX_STEP_VOXELS)));
    solvers.put("dot", new DotSolver(sampled, UNIT, MAX_STEP_VOXELS, border));
    solvers.put("paper", new PaperSolver(sampled, UNIT, MAX_STEP_VOXELS, border));
    solvers.put(GUARDED, new GuardedSolver(UNIT, MAX_STEP_VOXELS));
    solvers.put(SMOOTH, new SmoothSolver(UNIT, MAX_STEP_VOXELS));
    return solvers;
  }

  /** Returns the point after the device has rested for a while. */
  private static InteractionPoint rest(
      ProxySolver solver, CollisionScene scene, List<Vec3> devices) {
    InteractionPoint point = new InteractionPoint();
    point.position.set(devices.get(0));
    for (Vec3 device : devices) {
      solver.follow(scene, device, point);
    }
    for (int frame = 0; frame < FRAMES_AT_REST; frame++) {
      solver.follow(scene, devices.get(devices.size() - 1), point);
    }
    return point;
  }

  private static ExcessSum sumFor(
      Map<String, ExcessSum> sums, PressedSolid solid, double depth, String solver) {
    return sums.computeIfAbsent(
        solid.shape() + " " + depth + " " + solver,
        any -> new ExcessSum(solid.shape(), depth, solver));
  }

  /** The sum of a row's values. */
  private static final class ExcessSum {
    private final String shape;
    private final double depth;
    private final String solver;
    private double sum;
    private double worst = Double.NEGATIVE_INFINITY;
    private int count;

    ExcessSum(String shape, double depth, String solver) {
      this.shape = shape;
      this.depth = depth;
      this.solver = solver;
    }

    void add(double excess) {
      sum += excess;
      worst = Math.max(worst, excess);
      count++;
    }

    NearestRow row() {
      return new NearestRow(shape, depth, solver, sum / count, worst, count);
    }
  }
}
