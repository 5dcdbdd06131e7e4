package org.palpate.fracture.fit;

import java.util.ArrayList;
import java.util.List;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

/**
 * Lets poses vote for each other: the votes of a pose are the sum of the scores of all poses near
 * it, its own too. Many pairs of points agree about the true pose, and few about any other. One
 * thread.
 *
 * <p>Reference: Stockman 1987, "Object recognition and localization via pose clustering".
 */
final class PoseVotes {
  /** Poses vote for each other only if their centroids are less than this apart, edges. */
  private static final double NEAR_EDGES = 5;

  /** Poses vote for each other only if the angle between them is smaller than this. */
  private static final double NEAR_RAD = Math.toRadians(12);

  private PoseVotes() {}

  /**
   * Returns the same poses with their votes as scores. The work is at most quadratic in their
   * number, and much less if their rotations differ.
   *
   * @param all poses whose rotations differ by less than 180 degrees
   * @param centroid the centroid of the fragment
   * @param edgeMm the edge of a voxel, mm
   */
  static List<FitCandidate> count(List<FitCandidate> all, Vec3 centroid, double edgeMm) {
    double mostMm = NEAR_EDGES * edgeMm;
    double leastDot = StrictMath.cos(NEAR_RAD / 2);
    double chord = 2 * StrictMath.sin(NEAR_RAD / 4);
    List<Vec3> turns = turns(all);
    PointGrid grid = new PointGrid(turns, chord);
    double[] places = places(all, centroid);
    List<FitCandidate> voted = new ArrayList<>();
    for (int n = 0; n < all.size(); n++) {
      double votes = 0;
      for (int m : grid.around(turns.get(n), chord)) {
        FitCandidate voter = all.get(m);
        if (squareMm2(places, n, m) < mostMm * mostMm
            && Math.abs(voter.pose().rotation.dot(all.get(n).pose().rotation)) > leastDot) {
          votes += voter.score();
        }
      }
      voted.add(new FitCandidate(all.get(n).pose(), votes));
    }
    return voted;
  }

  /**
   * Returns the rotation of each pose relative to the first, as the vector part of a quaternion. If
   * rotations are near each other, their vectors differ by no more than the quaternions do.
   */
  private static List<Vec3> turns(List<FitCandidate> all) {
    List<Vec3> turns = new ArrayList<>();
    Quaternion turn = new Quaternion();
    for (FitCandidate each : all) {
      all.get(0).pose().rotation.conjugate(turn).multiply(each.pose().rotation, turn);
      double sign = turn.w < 0 ? -1 : 1;
      turns.add(new Vec3(sign * turn.x, sign * turn.y, sign * turn.z));
    }
    return turns;
  }

  /** Returns the components of each centroid. */
  private static double[] places(List<FitCandidate> all, Vec3 centroid) {
    double[] places = new double[3 * all.size()];
    Vec3 at = new Vec3();
    for (int n = 0; n < all.size(); n++) {
      all.get(n).pose().transform(centroid, at);
      places[3 * n] = at.x;
      places[3 * n + 1] = at.y;
      places[3 * n + 2] = at.z;
    }
    return places;
  }

  private static double squareMm2(double[] places, int n, int m) {
    double x = places[3 * n] - places[3 * m];
    double y = places[3 * n + 1] - places[3 * m + 1];
    double z = places[3 * n + 2] - places[3 * m + 2];
    return x * x + y * y + z * z;
  }
}
