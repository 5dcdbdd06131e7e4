package org.palpate.fracture.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * Searches poses of a fragment within 60 mm and 75 degrees of its present one for that at which it
 * fits best to another fragment. It proposes that pose and moves nothing.
 *
 * <p>Pairs of points on the rims of fracture faces are laid on pairs of the other surface that have
 * the same distance and angles. {@link Junction} scores each pose roughly, and poses near each
 * other vote for each other. Junction then closes the gaps of the best ones in two rounds, and
 * scores them again. {@link FaceFit} finds the last tenths of a millimetre of the best of these.
 * There the area that touches exactly decides. A search takes up to a few seconds. Its work is
 * bounded, and the same arguments give the same bits. One thread an instance, never the haptic one.
 */
final class GlobalFit {
  /**
   * The largest displacement of a proposal from the present pose relative to the other fragment.
   */
  private static final double FARTHEST_MM = 60;

  /** The largest rotation of a proposal from that pose. */
  private static final double FARTHEST_RAD = Math.toRadians(75);

  private static final long SEED = 1;

  /** The pairs of rim points that are drawn; those that are neither near nor far are laid. */
  private static final int DRAWS = 6000;

  /** The edge of the buckets in which points are sought, edges. */
  private static final double BUCKET_EDGES = 5;

  /** The number of points around a pair that a rough score reads. */
  private static final int NEAR_POINTS = 60;

  /** The radius around the middle of a pair in which these points lie, edges. */
  private static final double NEAR_EDGES = 10;

  /** The number of points of the whole surface that a rough score reads. */
  private static final int WHOLE_POINTS = 40;

  private static final double LEAST_ROUGH_SCORE = 0.1;

  /** The most poses that vote; no more are laid then. */
  private static final int MOST_VOTING = 10_000;

  /** The number of poses that enter the first round. */
  private static final int KEPT = 1000;

  /** The number of poses that enter the second round. */
  private static final int KEPT_FINE = 60;

  /** The number of poses that are fitted exactly. */
  private static final int KEPT_EXACT = 8;

  /** The number of points by which the first round moves and scores a pose. */
  private static final int POINTS = 600;

  /** The same number for the second round. */
  private static final int POINTS_FINE = 4000;

  /** The distance from which points count nothing in the first round, edges. */
  private static final double WIDTH_EDGES = 1.5;

  /** The same distance for the second round. */
  private static final double WIDTH_FINE_EDGES = 1;

  private final List<VoxelGrid> grids;
  private final List<BitCube> fragments;
  private final FragmentSurfaces surfaces;
  private final double gapMm;
  private final double edgeMm;

  /** The cells, points, rims and pairs of each fragment, made when they are needed first. */
  private final SurfaceCells[] cells;

  private final PointGrid[] points;
  private final RimPoints[] rims;
  private final RimPairs[] sharpPairs;
  private final RimPairs[] allPairs;

  private final RimLaying laying = new RimLaying();

  /**
   * A pose that is proposed.
   *
   * @param pose the pose of the fragment, from rest to present, world mm
   * @param scoreMm2 the area that speaks for the pose less the area against it, mm^2
   * @param nextScoreMm2 the score of the best pose at another place, mm^2; 0 without one
   */
  public record Proposal(Pose pose, double scoreMm2, double nextScoreMm2) {}

  /**
   * Prepares searches.
   *
   * @param grids the grid of each fragment
   * @param fragments the voxels of each fragment at rest
   * @param gapMm the width of the gap between faces that fit, mm
   */
  public GlobalFit(List<VoxelGrid> grids, List<BitCube> fragments, double gapMm) {
    this.grids = List.copyOf(grids);
    this.fragments = List.copyOf(fragments);
    this.gapMm = gapMm;
    surfaces = new FragmentSurfaces(grids, fragments);
    edgeMm = coarsestEdgeMm();
    cells = new SurfaceCells[fragments.size()];
    points = new PointGrid[fragments.size()];
    rims = new RimPoints[fragments.size()];
    sharpPairs = new RimPairs[fragments.size()];
    allPairs = new RimPairs[fragments.size()];
  }

  /**
   * Returns the edge of the square for which one point of a surface stands, mm; the longest one of
   * all fragments. That is the edge of a voxel unless a fragment has so many rim voxels that some
   * have no point. So a large scan is searched at a lower resolution.
   */
  private double coarsestEdgeMm() {
    return IntStream.range(0, fragments.size())
        .mapToDouble(n -> Math.sqrt(surfaces.of(n).areaMm2()))
        .reduce(surfaces.edgeMm(), Math::max);
  }

  /**
   * Proposes a pose at which a fragment fits to another.
   *
   * @param fragment the index of the fragment
   * @param other the index of the other fragment
   * @param poses the pose of each fragment, from rest to present, world mm
   * @return the proposal; empty if more area speaks against each pose than for it
   */
  public Optional<Proposal> propose(int fragment, int other, List<Pose> poses) {
    if (rim(fragment).size() == 0 || rim(other).size() == 0) {
      return Optional.empty();
    }
    Pose start = poses.get(other).inverseMultiply(poses.get(fragment), new Pose());
    List<FitCandidate> best = search(fragment, other, start);
    if (best.isEmpty() || best.get(0).score() <= 0) {
      return Optional.empty();
    }
    Vec3 centroid = surfaces.of(fragment).centroid();
    Pose pose = poses.get(other).multiply(best.get(0).pose(), new Pose());
    pose.rotation.normalize();
    double next =
        best.stream()
            .filter(
                each -> FitCandidate.isElsewhere(each.pose(), best.get(0).pose(), centroid, edgeMm))
            .mapToDouble(FitCandidate::score)
            .reduce(0, Math::max);
    return Optional.of(new Proposal(pose, best.get(0).score(), next));
  }

  /** Returns the area of the surface of a fragment, mm^2. */
  double surfaceMm2(int fragment) {
    FragmentSurface surface = surfaces.of(fragment);
    return surface.areaMm2() * surface.points().size();
  }

  /** Whether two poses of a fragment are different places, more than an error of the fit apart. */
  boolean isElsewhere(int fragment, Pose one, Pose two) {
    return FitCandidate.isElsewhere(one, two, surfaces.of(fragment).centroid(), edgeMm);
  }

  /**
   * Scores a pose of a fragment beside another one that it need not touch.
   *
   * @param relative leads from the rest of the fragment to the rest of the other
   * @return the area that speaks for the pose less the area against it, mm^2; 0 far away
   */
  double score(int fragment, int other, Pose relative) {
    FragmentSurface surface = surfaces.of(fragment);
    if (surface.points().isEmpty() || surfaces.of(other).points().isEmpty()) {
      return 0;
    }
    int[] read = spread(surface.points().size(), POINTS_FINE);
    return new Junction(surface, cells(other), edgeMm, gapMm).score(relative, read);
  }

  /**
   * Returns the pose at which {@link FaceFit} lays a fragment on all others; its own without one.
   */
  Pose settled(int fragment, List<Integer> others, List<Pose> poses) {
    List<Integer> all = new ArrayList<>(List.of(fragment));
    all.addAll(others);
    FaceFit fit =
        new FaceFit(
            all.stream().map(grids::get).toList(),
            all.stream().map(fragments::get).toList(),
            OptionalDouble.of(gapMm));
    return fitted(fit, all.stream().map(poses::get).toList(), surfaces.of(fragment).centroid());
  }

  /** Returns some of the best poses at which a fragment fits to another, the best first. */
  private List<FitCandidate> search(int fragment, int other, Pose start) {
    FragmentSurface surface = surfaces.of(fragment);
    Junction junction = new Junction(surface, cells(other), edgeMm, gapMm);
    List<FitCandidate> laid = lay(fragment, other, true, start, junction);
    List<FitCandidate> found = new ArrayList<>(different(laid, surface, KEPT));
    if (!rim(fragment).isSharp() || !rim(other).isSharp()) { // Or it would lay the same poses.
      laid = lay(fragment, other, false, start, junction);
      found.addAll(different(laid, surface, KEPT));
    }
    int[] read = spread(surface.points().size(), POINTS);
    found = refine(found, junction, read, WIDTH_EDGES);
    read = spread(surface.points().size(), POINTS_FINE);
    found = refine(different(found, surface, KEPT_FINE), junction, read, WIDTH_FINE_EDGES);
    List<FitCandidate> exact = new ArrayList<>();
    FaceFit local =
        new FaceFit(
            List.of(grids.get(fragment), grids.get(other)),
            List.of(fragments.get(fragment), fragments.get(other)),
            OptionalDouble.of(gapMm));
    for (FitCandidate each : different(found, surface, KEPT_EXACT)) {
      Pose pose = fitted(local, List.of(each.pose(), new Pose()), surface.centroid());
      exact.add(new FitCandidate(pose, junction.exactScore(pose, read)));
    }
    return different(exact, surface, KEPT_EXACT);
  }

  private List<FitCandidate> different(List<FitCandidate> all, FragmentSurface surface, int most) {
    return FitCandidate.different(all, surface.centroid(), edgeMm, most);
  }

  /** Moves candidates so that gaps close, and scores them again. */
  private List<FitCandidate> refine(
      List<FitCandidate> all, Junction junction, int[] read, double widthEdges) {
    List<FitCandidate> refined = new ArrayList<>();
    for (FitCandidate each : all) {
      Pose pose = new Pose().set(each.pose());
      junction.refine(pose, read, widthEdges * edgeMm);
      refined.add(new FitCandidate(pose, junction.score(pose, read)));
    }
    return refined;
  }

  /**
   * Returns the pose near another at which {@link FaceFit} finds the fit, or that pose without one.
   */
  private static Pose fitted(FaceFit local, List<Pose> poses, Vec3 centroid) {
    return local
        .fit(0, n -> false, poses)
        .map(target -> ofRest(target.pose(), centroid))
        .orElse(poses.get(0));
  }

  /** Returns the pose from rest that belongs to the pose of a point of the fragment. */
  private static Pose ofRest(Pose ofPoint, Vec3 point) {
    Pose pose = new Pose();
    pose.rotation.set(ofPoint.rotation);
    pose.rotation.rotate(point, pose.translation);
    ofPoint.translation.sub(pose.translation, pose.translation);
    return pose;
  }

  /** Lays pairs of rim points on each other, and returns the poses with their votes. */
  private List<FitCandidate> lay(
      int fragment, int other, boolean isSharp, Pose start, Junction junction) {
    FragmentSurface surface = surfaces.of(fragment);
    RimPoints own = rim(fragment);
    int size = isSharp ? own.sharp() : own.size();
    if (size == 0) {
      return List.of();
    }
    int[] whole = spread(surface.points().size(), WHOLE_POINTS);
    List<FitCandidate> all = new ArrayList<>();
    SplittableRandom random = new SplittableRandom(SEED);
    for (int n = 0; n < DRAWS && all.size() < MOST_VOTING; n++) {
      RimPoints.Frame one = own.frame(random.nextInt(size));
      RimPoints.Frame two = own.frame(random.nextInt(size));
      int[] near = near(fragment, one.point(), two.point());
      if (near.length > 0) {
        layPair(
            one,
            two,
            other,
            isSharp,
            pose -> {
              if (FitCandidate.isNear(pose, start, surface.centroid(), FARTHEST_MM, FARTHEST_RAD)) {
                double score = junction.roughScore(pose, near, whole);
                if (score > LEAST_ROUGH_SCORE) {
                  all.add(new FitCandidate(pose, score));
                }
              }
              return all.size() < MOST_VOTING;
            });
      }
    }
    return PoseVotes.count(all, surface.centroid(), edgeMm);
  }

  /**
   * Lays a pair on all pairs of another surface that fit to it.
   *
   * @param wantsMore receives the poses; returns whether it wants another one
   */
  private void layPair(
      RimPoints.Frame one,
      RimPoints.Frame two,
      int other,
      boolean isSharp,
      Predicate<Pose> wantsMore) {
    RimPoints faced = rim(other);
    pairs(other, isSharp)
        .findFitting(
            one,
            two,
            (first, second) -> {
              Pose pose = new Pose();
              return !laying.lay(one, two, faced.frame(first), faced.frame(second), pose)
                  || wantsMore.test(pose);
            });
  }

  private SurfaceCells cells(int fragment) {
    if (cells[fragment] == null) {
      cells[fragment] =
          new SurfaceCells(
              surfaces.of(fragment), fragments.get(fragment), grids.get(fragment), edgeMm);
    }
    return cells[fragment];
  }

  private PointGrid points(int fragment) {
    if (points[fragment] == null) {
      points[fragment] = new PointGrid(surfaces.of(fragment).points(), BUCKET_EDGES * edgeMm);
    }
    return points[fragment];
  }

  private RimPoints rim(int fragment) {
    if (rims[fragment] == null) {
      rims[fragment] = new RimPoints(surfaces.of(fragment), points(fragment), edgeMm);
    }
    return rims[fragment];
  }

  private RimPairs pairs(int fragment, boolean isSharp) {
    RimPairs[] pairs = isSharp ? sharpPairs : allPairs;
    if (pairs[fragment] == null) {
      RimPoints rim = rim(fragment);
      pairs[fragment] = new RimPairs(rim, isSharp ? rim.sharp() : rim.size(), edgeMm);
    }
    return pairs[fragment];
  }

  /** Returns some of the points around the middle of a pair. */
  private int[] near(int fragment, Vec3 one, Vec3 two) {
    Vec3 middle = one.add(two, new Vec3());
    int[] all = points(fragment).around(middle.mul(0.5, middle), NEAR_EDGES * edgeMm);
    return Arrays.stream(spread(all.length, NEAR_POINTS)).map(n -> all[n]).toArray();
  }

  /** Returns evenly spread indices below a limit, at most a number of them. */
  private static int[] spread(int limit, int count) {
    int[] indices = new int[Math.min(limit, count)];
    for (int n = 0; n < indices.length; n++) {
      indices[n] = (int) ((n + 0.5) * limit / indices.length);
    }
    return indices;
  }
}
