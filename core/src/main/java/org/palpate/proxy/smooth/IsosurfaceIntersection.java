package org.palpate.proxy.smooth;

import org.palpate.geometry.Vec3;
import org.palpate.proxy.smooth.field.OccupancyField;

/**
 * Finds where a straight way comes to the surface: by Newton's steps back from a place that is
 * inside, and by halving where these lead out of what is left or are slow. So most of what is
 * looked at lies in one window.
 */
final class IsosurfaceIntersection {
  /** How near above the surface the place is that is found, and what is aimed at. */
  static final double EDGES = 0.02;

  private static final double AIM_EDGES = 0.01;
  private static final int MOST_STEPS = 60;

  /** Where Newton's steps have not arrived after so many, every other step halves. */
  private static final int SURE_STEPS = 3;

  private final OccupancyField field;
  private final ClosestPointSearch search;
  private final Vec3 edges;
  private final Vec3 at = new Vec3();
  private final Vec3 way = new Vec3();
  private Vec3 from;
  private Vec3 to;

  IsosurfaceIntersection(OccupancyField field, ClosestPointSearch search, Vec3 edges) {
    this.field = field;
    this.search = search;
    this.edges = edges;
  }

  /**
   * The share of the way at which it comes to the surface, or a little before it. Leaves the field
   * seeded anywhere on the way.
   *
   * @param last a share of the way; nothing beyond it is looked at
   * @param mostWindows what is found so far has to do once the field has read so many
   * @return not a number where the way has not come inside by then
   */
  double find(Vec3 start, Vec3 end, double last, long mostWindows) {
    from = start;
    to = end;
    way.set((to.x - from.x) * edges.x, (to.y - from.y) * edges.y, (to.z - from.z) * edges.z);
    double length = way.length();
    double low = 0;
    double high = last;
    if (!(over(high) < 0)) {
      return Double.NaN;
    }
    double next = last + stepEdges() / length;
    for (int n = 0; (high - low) * length > EDGES && isWorth(n, mostWindows); n++) {
      boolean tries = n < SURE_STEPS || (n & 1) != 0;
      double share = tries && next > low && next < high ? next : 0.5 * (low + high);
      double over = over(share);
      if (over < 0) {
        high = share;
      } else if (over <= EDGES) {
        return share;
      } else {
        low = share;
      }
      next = share + stepEdges() / length;
    }
    return low;
  }

  private boolean isWorth(int step, long mostWindows) {
    return step < MOST_STEPS && field.windows < mostWindows;
  }

  /** How far over the surface a share of the way lies, edges; infinite where there is none. */
  private double over(double share) {
    VerifiedMotion.between(from, to, share, at);
    field.seed(at.x, at.y, at.z);
    field.evaluate(at.x, at.y, at.z);
    return search.findNormal() ? search.heightEdges : Double.POSITIVE_INFINITY;
  }

  /** How far along the way the surface lies from where the field stands; no number if unknown. */
  private double stepEdges() {
    double down = -way.dot(search.normal) / way.length();
    return search.findNormal() ? search.heightEdges / down - AIM_EDGES : Double.NaN;
  }
}
