package org.palpate.fracture.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * Searches poses of a fragment within 60 mm and 75 degrees of its present one for that at which it
 * fits best to another fragment. It proposes that pose and moves nothing.
 *
 * <p>Pairs of points around which the surface is rough are laid on pairs of the other surface that
 * have the same distance and angles. {@link Junction} scores each pose roughly, closes the gaps of
 * the best ones in two rounds, and scores them again. {@link FaceFit} finds the last tenths of a
 * millimetre. A search takes up to a few seconds. Its work is bounded, and the same arguments give
 * the same bits. One thread an instance, never the haptic one.
 */
public final class GlobalFit {
  /**
   * The largest displacement of a proposal from the present pose relative to the other fragment.
   */
  private static final double FARTHEST_MM = 60;

  /** The largest rotation of a proposal from that pose. */
  private static final double FARTHEST_RAD = Math.toRadians(75);

  private static final long SEED = 1;

  /** The pairs of rough points that are drawn; those that are near enough are laid on the other. */
  private static final int DRAWS = 20_000;

  /** The share of the points that count as rough. */
  private static final double ROUGH_SHARE = 0.25;

  /** The radius around a point in which its normals are compared, edges. */
  private static final double ROUGH_EDGES = 3;

  /** The least cosine between normals on the same side of a thin wall. */
  private static final double SAME_SIDE_COSINE = -0.2;

  /** The least cosine between a normal and the opposite one that it is laid on. */
  private static final double LIKE_COSINE = 0.85;

  /** The least length of the sum of two normals across the line between their points. */
  private static final double LEAST_ACROSS = 0.5;

  /** The number of points around a pair that a rough score reads. */
  private static final int NEAR_POINTS = 60;

  /** The radius around the middle of a pair in which these points lie, edges. */
  private static final double NEAR_EDGES = 10;

  /** The number of points of the whole surface that a rough score reads. */
  private static final int WHOLE_POINTS = 40;

  private static final double LEAST_ROUGH_SCORE = 0.15;

  /** The number of poses that are kept for each pair of the fragment. */
  private static final int KEPT_OF_PAIR = 3;

  /** The number of poses that enter the first round. */
  private static final int KEPT = 1000;

  /** The number of poses that enter the second round. */
  private static final int KEPT_FINE = 60;

  /** The number of points by which the first round moves and scores a pose. */
  private static final int POINTS = 600;

  /** The same number for the second round. */
  private static final int POINTS_FINE = 4000;

  /** The distance from which points count nothing in the first round, edges. */
  private static final double WIDTH_EDGES = 3;

  /** The same distance for the second round. */
  private static final double WIDTH_FINE_EDGES = 1.5;

  /** Two poses whose displacement is smaller than this may count as one, edges. */
  private static final double SAME_EDGES = 1.5;

  /** They do if their rotations also differ by less than this. */
  private static final double SAME_RAD = Math.toRadians(6);

  private final List<VoxelGrid> grids;
  private final List<BitCube> fragments;
  private final FragmentSurfaces surfaces;
  private final double gapMm;
  private final double edgeMm;

  /** The cells, rough points and pairs of each fragment, made when they are needed first. */
  private final SurfaceCells[] cells;

  private final int[][] rough;
  private final PointPairs[] pairs;

  private final Vec3[] ownAxes = {new Vec3(), new Vec3(), new Vec3()};
  private final Vec3[] otherAxes = {new Vec3(), new Vec3(), new Vec3()};
  private final Quaternion scratch = new Quaternion();

  /**
   * A pose that is proposed.
   *
   * @param pose the pose of the fragment, from rest to present, world mm
   * @param scoreMm2 the area that speaks for the pose less the area against it, mm^2
   * @param nextScoreMm2 the score of the best pose that differs from it, mm^2; 0 without one
   */
  public record Proposal(Pose pose, double scoreMm2, double nextScoreMm2) {}

  /** A pose from the rest of the fragment to the rest of the other, and its score. */
  private record Candidate(Pose pose, double score) {}

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
    edgeMm = surfaces.edgeMm();
    cells = new SurfaceCells[fragments.size()];
    rough = new int[fragments.size()][];
    pairs = new PointPairs[fragments.size()];
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
    Pose start = poses.get(other).inverseMultiply(poses.get(fragment), new Pose());
    List<Candidate> best = search(fragment, other, start);
    if (best.isEmpty() || best.get(0).score <= 0) {
      return Optional.empty();
    }
    Pose pose = poses.get(other).multiply(best.get(0).pose, new Pose());
    pose.rotation.normalize();
    double next = best.size() > 1 ? best.get(1).score : 0;
    return Optional.of(
        new Proposal(
            fitted(fragment, other, pose, poses.get(other)), best.get(0).score, Math.max(0, next)));
  }

  /**
   * Returns the pose near another at which {@link FaceFit} finds the fit, or that pose without one.
   */
  private Pose fitted(int fragment, int other, Pose pose, Pose ofOther) {
    FaceFit local =
        new FaceFit(
            List.of(grids.get(fragment), grids.get(other)),
            List.of(fragments.get(fragment), fragments.get(other)),
            OptionalDouble.of(gapMm));
    return local
        .fit(0, n -> false, List.of(pose, ofOther))
        .map(target -> ofRest(target.pose(), surfaces.of(fragment).centroid()))
        .orElse(pose);
  }

  /** Returns the pose from rest that belongs to the pose of a point of the fragment. */
  private static Pose ofRest(Pose ofPoint, Vec3 point) {
    Pose pose = new Pose();
    pose.rotation.set(ofPoint.rotation);
    pose.rotation.rotate(point, pose.translation);
    ofPoint.translation.sub(pose.translation, pose.translation);
    return pose;
  }

  /** Returns the best poses at which a fragment fits to another, the best first. */
  private List<Candidate> search(int fragment, int other, Pose start) {
    FragmentSurface surface = surfaces.of(fragment);
    if (rough(fragment).length < 2 || rough(other).length < 2) {
      return List.of();
    }
    Junction junction = new Junction(surface, cells(other), edgeMm, gapMm);
    List<Candidate> found = lay(fragment, other, start, junction);
    for (boolean isFine : new boolean[] {false, true}) {
      int[] points = spread(surface.points().size(), isFine ? POINTS_FINE : POINTS);
      double widthMm = (isFine ? WIDTH_FINE_EDGES : WIDTH_EDGES) * edgeMm;
      List<Candidate> refined = new ArrayList<>();
      for (Candidate each : different(found, surface, isFine ? KEPT_FINE : KEPT)) {
        Pose pose = new Pose().set(each.pose);
        junction.refine(pose, points, widthMm);
        refined.add(new Candidate(pose, junction.score(pose, points)));
      }
      found = refined;
    }
    return different(found, surface, 2);
  }

  /**
   * Lays pairs of a fragment on pairs of the other, and returns the poses whose rough score is
   * high.
   */
  private List<Candidate> lay(int fragment, int other, Pose start, Junction junction) {
    FragmentSurface surface = surfaces.of(fragment);
    FragmentSurface faced = surfaces.of(other);
    SplittableRandom random = new SplittableRandom(SEED);
    int[] own = rough(fragment);
    int[] whole = spread(surface.points().size(), WHOLE_POINTS);
    List<Candidate> all = new ArrayList<>();
    for (int n = 0; n < DRAWS; n++) {
      int one = own[random.nextInt(own.length)];
      int two = own[random.nextInt(own.length)];
      if (PointPairs.isPair(surface, one, two, edgeMm)) {
        int[] near = near(surface, one, two);
        List<Candidate> ofPair = new ArrayList<>();
        pairs(other)
            .findFitting(
                surface,
                one,
                two,
                (first, second) -> {
                  Pose pose = new Pose();
                  if (laidOn(surface, one, two, faced, first, second, pose)
                      && isNear(pose, start, surface, FARTHEST_MM, FARTHEST_RAD)) {
                    double score = junction.roughScore(pose, near, whole);
                    if (score > LEAST_ROUGH_SCORE) {
                      ofPair.add(new Candidate(pose, score));
                    }
                  }
                });
        all.addAll(different(ofPair, surface, KEPT_OF_PAIR));
      }
    }
    return all;
  }

  private SurfaceCells cells(int fragment) {
    if (cells[fragment] == null) {
      cells[fragment] =
          new SurfaceCells(
              surfaces.of(fragment), fragments.get(fragment), grids.get(fragment), edgeMm);
    }
    return cells[fragment];
  }

  private PointPairs pairs(int fragment) {
    if (pairs[fragment] == null) {
      pairs[fragment] =
          new PointPairs(
              surfaces.of(fragment), rough(fragment), edgeMm, new SplittableRandom(SEED));
    }
    return pairs[fragment];
  }

  /** Returns the points of a fragment around which the normals of one side differ most. */
  private int[] rough(int fragment) {
    if (rough[fragment] == null) {
      FragmentSurface surface = surfaces.of(fragment);
      double[] alike =
          IntStream.range(0, surface.points().size()).mapToDouble(n -> alike(surface, n)).toArray();
      double[] sorted = alike.clone();
      Arrays.sort(sorted);
      double most = sorted.length == 0 ? 0 : sorted[(int) (ROUGH_SHARE * (sorted.length - 1))];
      rough[fragment] = IntStream.range(0, alike.length).filter(n -> alike[n] <= most).toArray();
    }
    return rough[fragment];
  }

  /** Returns the length of the mean of the normals around a point, 0 to 1. */
  private double alike(FragmentSurface surface, int n) {
    Vec3 sum = new Vec3();
    int count = 0;
    for (int m : around(surface, surface.points().get(n), ROUGH_EDGES * edgeMm)) {
      if (surface.normals().get(m).dot(surface.normals().get(n)) > SAME_SIDE_COSINE) {
        sum.add(surface.normals().get(m), sum);
        count++;
      }
    }
    return sum.length() / count;
  }

  private static int[] around(FragmentSurface surface, Vec3 middle, double mm) {
    int[] indices = new int[surface.points().size()];
    int count = 0;
    for (int n = 0; n < indices.length; n++) {
      Vec3 p = surface.points().get(n);
      double x = p.x - middle.x;
      double y = p.y - middle.y;
      double z = p.z - middle.z;
      if (x * x + y * y + z * z < mm * mm) {
        indices[count++] = n;
      }
    }
    return Arrays.copyOf(indices, count);
  }

  /** Returns some of the points around the middle of a pair. */
  private int[] near(FragmentSurface surface, int one, int two) {
    Vec3 middle = new Vec3();
    surface.points().get(one).add(surface.points().get(two), middle).mul(0.5, middle);
    int[] all = around(surface, middle, NEAR_EDGES * edgeMm);
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

  /**
   * Writes the pose that lays a pair on another, normals against normals. Returns whether both fit.
   */
  private boolean laidOn(
      FragmentSurface own,
      int one,
      int two,
      FragmentSurface faced,
      int first,
      int second,
      Pose dest) {
    if (!axes(own, one, two, 1, ownAxes) || !axes(faced, first, second, -1, otherAxes)) {
      return false;
    }
    scratch.setAxes(ownAxes[0], ownAxes[1], ownAxes[2]).conjugate(scratch);
    dest.rotation.setAxes(otherAxes[0], otherAxes[1], otherAxes[2]);
    dest.rotation.multiply(scratch, dest.rotation).normalize();
    Vec3 n = dest.rotation.rotate(own.normals().get(one), ownAxes[0]);
    Vec3 m = dest.rotation.rotate(own.normals().get(two), ownAxes[1]);
    Vec3 middle = own.points().get(one).add(own.points().get(two), ownAxes[2]);
    dest.rotation.rotate(middle, middle);
    faced.points().get(first).add(faced.points().get(second), dest.translation);
    dest.translation.sub(middle, dest.translation).mul(0.5, dest.translation);
    return -n.dot(faced.normals().get(first)) >= LIKE_COSINE
        && -m.dot(faced.normals().get(second)) >= LIKE_COSINE;
  }

  /**
   * Finds axes of a pair: x along it, z as the sum of the normals across it. False if that is
   * short.
   */
  private static boolean axes(FragmentSurface of, int one, int two, int sign, Vec3[] dest) {
    of.points().get(two).sub(of.points().get(one), dest[0]);
    dest[0].mul(1 / dest[0].length(), dest[0]);
    of.normals().get(one).add(of.normals().get(two), dest[2]).mul(sign, dest[2]);
    dest[2].sub(dest[0].mul(dest[0].dot(dest[2]), dest[1]), dest[2]);
    double length = dest[2].length();
    if (length < LEAST_ACROSS) {
      return false;
    }
    dest[2].mul(1 / length, dest[2]).cross(dest[0], dest[1]);
    return true;
  }

  /** Returns the best of some poses that differ from each other, the best first. */
  private List<Candidate> different(List<Candidate> all, FragmentSurface surface, int most) {
    List<Candidate> kept = new ArrayList<>();
    all.sort(Comparator.comparingDouble(each -> -each.score));
    for (int n = 0; n < all.size() && kept.size() < most; n++) {
      Pose pose = all.get(n).pose;
      if (kept.stream()
          .noneMatch(o -> isNear(pose, o.pose, surface, SAME_EDGES * edgeMm, SAME_RAD))) {
        kept.add(all.get(n));
      }
    }
    return kept;
  }

  private static boolean isNear(
      Pose one, Pose two, FragmentSurface surface, double mostMm, double mostRad) {
    if (Math.abs(one.rotation.dot(two.rotation)) < StrictMath.cos(mostRad / 2)) {
      return false;
    }
    Vec3 p = one.transform(surface.centroid(), new Vec3());
    return p.sub(two.transform(surface.centroid(), new Vec3()), p).length() < mostMm;
  }
}
