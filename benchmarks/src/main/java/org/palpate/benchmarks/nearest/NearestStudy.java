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

/** Presses every solver into every shape at every depth and measures where it comes to rest. */
final class NearestStudy {
  static final double[] DEPTHS = {1, 2, 5, 10, 15, 20};

  /** What a search of radius sqrt(2 s + 1) around the guarded solver's point reaches. */
  static final String SEARCH = "search sqrt(2s+1)";

  /** The smooth solver's point with the height of its surface taken off, as the force does. */
  static final String SMOOTH_FELT = "smooth felt";

  private static final String SMOOTH = "smooth";
  private static final String GUARDED = "guarded";

  private static final GridMetric UNIT = new GridMetric(1, 1, 1);
  private static final double MAX_STEP_VOXELS = 8;

  /** The paper's solver as printed never rests on a slope; the others do long before. */
  private static final int FRAMES_AT_REST = 200;

  private final int presses;
  private final long seed;
  private final Consumer<String> progress;

  NearestStudy(int presses, long seed, Consumer<String> progress) {
    this.presses = presses;
    this.seed = seed;
    this.progress = progress;
  }

  List<NearestRow> rows() {
    Map<String, Tally> tallies = new LinkedHashMap<>();
    for (PressedSolid solid : PressedSolid.all()) {
      progress.accept("nearest free point: " + solid.shape());
      for (double depth : DEPTHS) {
        SplittableRandom random = new SplittableRandom(seed);
        for (int n = 0; n < presses; n++) {
          press(solid, depth, PressTrajectory.way(solid, depth, random), tallies);
        }
      }
    }
    List<NearestRow> rows = new ArrayList<>();
    tallies.values().forEach(tally -> rows.add(tally.row()));
    return rows;
  }

  private static void press(
      PressedSolid solid, double depth, List<Vec3> way, Map<String, Tally> tallies) {
    Vec3 device = way.get(way.size() - 1);
    NearestFreeOracle free = new NearestFreeOracle(solid.bits());
    double nearest = free.distance(device);
    solvers(solid)
        .forEach(
            (name, solver) -> {
              InteractionPoint point = rest(solver, new CollisionScene(List.of(solid.bits())), way);
              Vec3 p = point.position;
              double reached = p.sub(device, new Vec3()).length();
              tally(tallies, solid, depth, name).add(reached - nearest);
              if (name.equals(GUARDED)) {
                double found = free.distance(device, p, Math.sqrt(2 * depth + 1));
                tally(tallies, solid, depth, SEARCH).add(Math.min(found, reached) - nearest);
              }
              if (name.equals(SMOOTH)) {
                double felt = reached - point.surfaceHeightMm;
                tally(tallies, solid, depth, SMOOTH_FELT).add(felt - nearest);
              }
            });
  }

  private static Map<String, ProxySolver> solvers(PressedSolid solid) {
    SampledRayCaster sampled = new SampledRayCaster(1);
    BorderVoxels border = BorderVoxels.onTheFly();
    Map<String, ProxySolver> solvers = new LinkedHashMap<>();
    solvers.put(
        "plain twin", new PlainBaselineSolver(new PlainBaseline(solid.bits(), MAX_STEP_VOXELS)));
    solvers.put("dot", new DotSolver(sampled, UNIT, MAX_STEP_VOXELS, border));
    solvers.put("paper", new PaperSolver(sampled, UNIT, MAX_STEP_VOXELS, border));
    solvers.put(GUARDED, new GuardedSolver(UNIT, MAX_STEP_VOXELS));
    solvers.put(SMOOTH, new SmoothSolver(UNIT, MAX_STEP_VOXELS));
    return solvers;
  }

  /** Where the point is after the device has rested for a while. */
  private static InteractionPoint rest(
      ProxySolver solver, CollisionScene obstacles, List<Vec3> way) {
    InteractionPoint point = new InteractionPoint();
    point.position.set(way.get(0));
    for (Vec3 device : way) {
      solver.follow(obstacles, device, point);
    }
    for (int frame = 0; frame < FRAMES_AT_REST; frame++) {
      solver.follow(obstacles, way.get(way.size() - 1), point);
    }
    return point;
  }

  private static Tally tally(
      Map<String, Tally> tallies, PressedSolid solid, double depth, String solver) {
    return tallies.computeIfAbsent(
        solid.shape() + " " + depth + " " + solver, any -> new Tally(solid.shape(), depth, solver));
  }

  /** Sums for one row. */
  private static final class Tally {
    private final String shape;
    private final double depth;
    private final String solver;
    private double sum;
    private double worst = Double.NEGATIVE_INFINITY;
    private int count;

    Tally(String shape, double depth, String solver) {
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
