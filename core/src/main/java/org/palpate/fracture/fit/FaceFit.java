package org.palpate.fracture.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.IntPredicate;
import org.palpate.force.guide.FitTarget;
import org.palpate.fracture.FaceLine;
import org.palpate.fracture.PartialVoxels;
import org.palpate.fracture.SmoothedBits;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * Finds the pose of a fragment near its present one at which its fracture faces fit best to the
 * faces that they face.
 *
 * <p>Points of both faces are found between voxels on lines across the fracture, see {@link
 * FaceLine}. The fit minimizes the squared differences between their distances and the width of the
 * gap, by Gauss-Newton steps with robust weights. Distances are measured half way between both
 * normals. One thread an instance.
 *
 * <p>Reference: Rusinkiewicz, A symmetric objective function for ICP, 2019.
 */
public final class FaceFit {
  /** The widest gap that can be chosen, mm. */
  public static final double MOST_GAP_MM = 3;

  /** The largest distance of a face from the rim voxels that it belongs to, edges. */
  private static final double OWN_EDGES = 2;

  /** The largest depth of a face inside what it faces, edges. */
  private static final double DEEPEST_EDGES = 2;

  /** The largest cosine between the normals of points that face each other. */
  private static final double FACING_COSINE = -0.6;

  /** The longest step, mm. */
  private static final double STEP_LIMIT_MM = 1;

  /** The most pairs of a fit, and the least. */
  private static final int MOST_PAIRS = 500;

  private static final int LEAST_PAIRS = 20;

  private static final int MOST_STEPS = 12;

  /** A step below this ends the fit, mm. */
  private static final double SMALL_STEP_MM = 0.003;

  /** Distances that differ more from the median count less, voxel edges: at first and at last. */
  private static final double WIDE_EDGES = 1;

  private static final double NARROW_EDGES = 0.35;

  private static final double NARROWING_EDGES = 0.15;

  /**
   * A line counts one half if its deep occupancy is less than 1 by this. Near the skin, smoothed
   * voxels do not tell exactly where a face is, and the errors of facing points do not cancel.
   */
  private static final double HALF_COUNTED_LOSS = 0.1;

  /** Distances that are farther apart than this are independent, voxel edges. */
  private static final double INDEPENDENT_EDGES = 3.5 * FragmentSurface.SIGMA;

  /** The least noise of a distance that is believed, voxel edges. */
  private static final double LEAST_NOISE_EDGES = 0.05;

  private final OptionalDouble gapMm;
  private final FragmentSurfaces surfaces;
  private final double edgeMm;
  private final Vec3 point = new Vec3();
  private final Vec3 normal = new Vec3();
  private final Vec3 direction = new Vec3();
  private final FaceLine line;
  private final Quaternion scratch = new Quaternion();

  /**
   * A point of a face that moves, at the start of a fit, and the direction of what it faces.
   *
   * @param loss how much its deep occupancy is less than 1
   */
  private record Candidate(
      Vec3 point, Vec3 normal, Vec3 across, SmoothedBits faced, double areaMm2, double loss) {}

  /** A candidate that faces a point of another fragment, and the area for which it counts. */
  private record Pair(Vec3 arm, Vec3 direction, double distanceMm, double areaMm2) {}

  /**
   * Prepares fits of fragments on one grid.
   *
   * @param grid the grid of all fragments at rest
   * @param fragments the voxels of each fragment at rest
   * @param gapMm the width of the gap between faces that fit; if empty, the fit finds it, and so
   *     does not determine how far apart the fragments are
   */
  public FaceFit(VoxelGrid grid, List<BitCube> fragments, OptionalDouble gapMm) {
    this(Collections.nCopies(fragments.size(), grid), fragments, gapMm);
  }

  /**
   * Prepares fits of fragments on grids of their own.
   *
   * @param grids the grid of each fragment
   * @param fragments the voxels of each fragment at rest
   * @param gapMm the width of the gap, or empty, as for one grid
   */
  public FaceFit(List<VoxelGrid> grids, List<BitCube> fragments, OptionalDouble gapMm) {
    this(grids, fragments, Collections.nCopies(fragments.size(), Optional.empty()), gapMm);
  }

  /**
   * Prepares fits of fragments whose faces lie where grey values place them.
   *
   * @param grids the grid of each fragment
   * @param fragments the voxels of each fragment at rest
   * @param partial how full the voxels at the surface of each fragment are; if empty, only the bits
   *     count
   * @param gapMm the width of the gap, or empty, as for one grid
   */
  public FaceFit(
      List<VoxelGrid> grids,
      List<BitCube> fragments,
      List<Optional<PartialVoxels>> partial,
      OptionalDouble gapMm) {
    this.gapMm = gapMm;
    surfaces = new FragmentSurfaces(grids, fragments, partial);
    edgeMm = surfaces.edgeMm();
    line = surfaces.faceLine();
  }

  /**
   * Fits a fragment, some tens of milliseconds; the first fit of a fragment takes longer.
   *
   * @param fragment its index
   * @param movesAlong which fragments move along with it
   * @param poses the pose of each fragment, from rest to present, world mm
   * @return empty if too little of it faces another fragment
   */
  public Optional<FitTarget> fit(int fragment, IntPredicate movesAlong, List<Pose> poses) {
    Pose start = new Pose();
    start.set(
        poses.get(fragment).transform(surfaces.of(fragment).centroid(), new Vec3()),
        poses.get(fragment).rotation);
    List<Candidate> candidates = candidates(n -> n == fragment || movesAlong.test(n), poses);
    return converge(fragment, start, candidates);
  }

  /** Finds the points of the faces that move. */
  private List<Candidate> candidates(IntPredicate moves, List<Pose> poses) {
    List<FragmentSurfaces.FacingPoint> facing = surfaces.facing(moves, poses);
    int stride = 1 + (facing.size() - 1) / MOST_PAIRS;
    SmoothedBits[] smoothed = new SmoothedBits[poses.size()];
    List<Candidate> candidates = new ArrayList<>();
    for (int k = 0; k < facing.size(); k += stride) {
      FragmentSurfaces.FacingPoint each = facing.get(k);
      for (int n : new int[] {each.fragment(), each.other()}) {
        smoothed[n] = smoothed[n] == null ? surfaces.smoothed(n, poses) : smoothed[n];
      }
      each.direction().mul(-1, direction);
      double mm = OWN_EDGES * edgeMm;
      if (line.find(smoothed[each.fragment()], each.point(), direction, -mm, mm)) {
        candidates.add(
            new Candidate(
                new Vec3().set(line.point()),
                new Vec3().set(line.normal()),
                each.direction(),
                smoothed[each.other()],
                stride * surfaces.of(each.fragment()).areaMm2(),
                1 - line.deepOccupancy()));
      }
    }
    return candidates;
  }

  private Optional<FitTarget> converge(int fragment, Pose start, List<Candidate> candidates) {
    double leverMm = surfaces.of(fragment).leverMm();
    Pose present = new Pose().set(start);
    double[] pull = {};
    for (int n = 0; n < MOST_STEPS; n++) {
      List<Pair> pairs = pairs(candidates, start, present);
      if (pairs.size() < LEAST_PAIRS) {
        return Optional.empty();
      }
      double edges = Math.max(NARROW_EDGES, WIDE_EDGES - NARROWING_EDGES * n);
      FitEquations solution = solve(pairs, leverMm, edges * edgeMm);
      pull = solution.pull();
      double length = move(present, solution.step(), leverMm);
      if (length < SMALL_STEP_MM && edges == NARROW_EDGES) {
        break;
      }
    }
    return Optional.of(new FitTarget(fragment, present, leverMm, pull));
  }

  /** Pairs candidates with the points that they face after a motion. */
  private List<Pair> pairs(List<Candidate> candidates, Pose start, Pose present) {
    List<Pair> pairs = new ArrayList<>();
    Quaternion turn = new Quaternion();
    present.rotation.multiply(start.rotation.conjugate(scratch), turn);
    for (Candidate each : candidates) {
      turn.rotate(each.point.sub(start.translation, point), point);
      turn.rotate(each.normal, normal);
      Vec3 arm = new Vec3().set(point);
      point.add(present.translation, point);
      double reach = FragmentSurfaces.REACH_MM;
      if (line.find(each.faced, point, each.across, -DEEPEST_EDGES * edgeMm, reach)
          && line.normal().dot(normal) <= FACING_COSINE) {
        normal.sub(line.normal(), direction);
        direction.mul(1 / direction.length(), direction);
        double distance = line.point().sub(point, point).dot(direction);
        double loss = Math.max(each.loss, 1 - line.deepOccupancy()) / HALF_COUNTED_LOSS;
        double areaMm2 = each.areaMm2 / (1 + loss * loss);
        pairs.add(new Pair(arm, new Vec3().set(direction), distance, areaMm2));
      }
    }
    return pairs;
  }

  private static double medianMm(List<Pair> pairs) {
    double[] sorted = pairs.stream().mapToDouble(Pair::distanceMm).toArray();
    Arrays.sort(sorted);
    return sorted[sorted.length / 2];
  }

  private FitEquations solve(List<Pair> pairs, double leverMm, double widthMm) {
    double median = medianMm(pairs);
    FitEquations equations = new FitEquations(leverMm, gapMm.isPresent());
    double areaMm2 = 0;
    for (Pair pair : pairs) {
      double off = (pair.distanceMm - median) / widthMm;
      double weight = 1 / ((1 + off * off) * (1 + off * off));
      areaMm2 += weight * pair.areaMm2;
      equations.add(
          pair.arm, pair.direction, pair.distanceMm - gapMm.orElse(0), weight * pair.areaMm2);
    }
    double independentMm = INDEPENDENT_EDGES * edgeMm;
    equations.solve(areaMm2 / (independentMm * independentMm), LEAST_NOISE_EDGES * edgeMm);
    return equations;
  }

  /** Moves a pose by a step, at most by the limit; returns the length of the whole step, mm. */
  private double move(Pose present, double[] step, double leverMm) {
    double length = Math.sqrt(Arrays.stream(step).map(x -> x * x).sum());
    double fraction = length > STEP_LIMIT_MM ? STEP_LIMIT_MM / length : 1;
    Vec3 displacement = new Vec3(step[0], step[1], step[2]);
    Vec3 rotation = new Vec3(step[3] / leverMm, step[4] / leverMm, step[5] / leverMm);
    present.displace(displacement, rotation, fraction, scratch, present);
    return length;
  }
}
