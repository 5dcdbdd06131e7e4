package org.palpate.fracture.fit;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.palpate.geometry.Pose;
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

  /** The components of a pose in the table: the centroid, the rotation, the score. */
  private static final int WIDTH = 8;

  private PoseVotes() {}

  /**
   * Returns the same poses with their votes as scores. The work is at most quadratic in their
   * number, with a table that the processor reads in order.
   *
   * @param centroid the centroid of the fragment
   * @param edgeMm the edge of a voxel, mm
   */
  static List<FitCandidate> count(List<FitCandidate> all, Vec3 centroid, double edgeMm) {
    double mostMm = NEAR_EDGES * edgeMm;
    double leastDot = StrictMath.cos(NEAR_RAD / 2);
    List<FitCandidate> ordered = new ArrayList<>(all);
    ordered.sort(Comparator.comparingDouble(each -> each.pose().transform(centroid, new Vec3()).x));
    double[] table = table(ordered, centroid);
    double[] votes = new double[ordered.size()];
    for (int n = 0; n < votes.length; n++) {
      int a = WIDTH * n;
      votes[n] += table[a + 7];
      for (int b = a + WIDTH; b < table.length && table[b] - table[a] < mostMm; b += WIDTH) {
        if (isNear(table, a, b, mostMm, leastDot)) {
          votes[n] += table[b + 7];
          votes[b / WIDTH] += table[a + 7];
        }
      }
    }
    List<FitCandidate> voted = new ArrayList<>();
    for (int n = 0; n < votes.length; n++) {
      voted.add(new FitCandidate(ordered.get(n).pose(), votes[n]));
    }
    return voted;
  }

  private static double[] table(List<FitCandidate> all, Vec3 centroid) {
    double[] table = new double[WIDTH * all.size()];
    Vec3 at = new Vec3();
    for (int n = 0; n < all.size(); n++) {
      Pose pose = all.get(n).pose();
      pose.transform(centroid, at);
      double[] row = {
        at.x,
        at.y,
        at.z,
        pose.rotation.w,
        pose.rotation.x,
        pose.rotation.y,
        pose.rotation.z,
        all.get(n).score()
      };
      System.arraycopy(row, 0, table, WIDTH * n, WIDTH);
    }
    return table;
  }

  /** Whether the poses of two rows are near each other. */
  private static boolean isNear(double[] table, int a, int b, double mostMm, double leastDot) {
    double dot = 0;
    for (int n = 3; n < 7; n++) {
      dot += table[a + n] * table[b + n];
    }
    double square = 0;
    for (int n = 0; n < 3; n++) {
      square += (table[a + n] - table[b + n]) * (table[a + n] - table[b + n]);
    }
    return square < mostMm * mostMm && Math.abs(dot) > leastDot;
  }
}
