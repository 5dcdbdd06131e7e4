package org.palpate.fracture.fit;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;

/**
 * A pose that may fit.
 *
 * @param pose from the rest of a fragment to the rest of another
 * @param score how much speaks for it
 */
record FitCandidate(Pose pose, double score) {
  /** Two poses whose displacement is smaller than this may count as one, edges. */
  private static final double SAME_EDGES = 1.5;

  /** They do if their rotations also differ by less than this. */
  private static final double SAME_RAD = Math.toRadians(6);

  /** Two poses whose displacement is larger than this are different places, edges. */
  private static final double ELSEWHERE_EDGES = 5;

  /** Two poses whose rotations differ by more than this are different places, too. */
  private static final double ELSEWHERE_RAD = Math.toRadians(15);

  /**
   * Returns the best of some candidates that differ from each other, the best first.
   *
   * @param centroid the centroid of the fragment, where displacements are measured
   * @param edgeMm the edge of a voxel, mm
   * @param most the number of candidates that are wanted
   */
  static List<FitCandidate> different(
      List<FitCandidate> all, Vec3 centroid, double edgeMm, int most) {
    List<FitCandidate> sorted = new ArrayList<>(all);
    sorted.sort(Comparator.comparingDouble(each -> -each.score));
    List<FitCandidate> kept = new ArrayList<>();
    for (int n = 0; n < sorted.size() && kept.size() < most; n++) {
      Pose pose = sorted.get(n).pose;
      if (kept.stream()
          .noneMatch(o -> isNear(pose, o.pose, centroid, SAME_EDGES * edgeMm, SAME_RAD))) {
        kept.add(sorted.get(n));
      }
    }
    return kept;
  }

  /** Whether two poses are different places, more than an error of a fit apart. */
  static boolean isElsewhere(Pose one, Pose two, Vec3 centroid, double edgeMm) {
    return !isNear(one, two, centroid, ELSEWHERE_EDGES * edgeMm, ELSEWHERE_RAD);
  }

  /** Whether two poses are near each other at a point, and their rotations too. */
  static boolean isNear(Pose one, Pose two, Vec3 point, double mostMm, double mostRad) {
    if (Math.abs(one.rotation.dot(two.rotation)) < StrictMath.cos(mostRad / 2)) {
      return false;
    }
    Vec3 p = one.transform(point, new Vec3());
    return p.sub(two.transform(point, new Vec3()), p).length() < mostMm;
  }
}
