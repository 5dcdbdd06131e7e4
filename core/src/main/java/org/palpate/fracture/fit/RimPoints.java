package org.palpate.fracture.fit;

import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.palpate.geometry.Vec3;

/**
 * The points of a surface that are most like the rim of a fracture face, each with a frame. Around
 * such a point the normals of skin and face fan out about the tangent of the rim, to which all of
 * them are perpendicular. On a thin wall the normals of both skins cancel, so their mean shows
 * where the face looks. Both are found from the matrix of second moments of the normals: the
 * tangent is its least eigenvector, and the outward direction its middle one. One thread.
 *
 * <p>References: Page et al. 2002, "Normal vector voting", for edges of surfaces; Huang et al.
 * 2006, "Reassembling fractured objects by geometric matching".
 */
final class RimPoints {
  /** The radius around a point in which normals are compared, edges. */
  private static final double BALL_EDGES = 5;

  /** The number of points that are kept. */
  private static final int MOST = 600;

  /** The least rating of a point that is kept. */
  private static final double LEAST_RATING = -0.15;

  /** The least rating of a point on a sharp rim. */
  private static final double SHARP_RATING = 0;

  /** The least cosine between the normal of a point and the outward direction. */
  private static final double LEAST_OUTWARD = 0.3;

  private final FragmentSurface surface;
  private final List<Rated> rated;
  private final int sharp;

  /**
   * A point and its frame.
   *
   * @param point where it lies, world mm
   * @param tangent a unit vector along the rim; its sign has no meaning
   * @param outward a unit vector out of the face, perpendicular to the tangent
   */
  record Frame(Vec3 point, Vec3 tangent, Vec3 outward) {}

  /** A frame, and how much its point is like a rim. */
  private record Rated(Frame frame, double rating) {}

  /**
   * Finds the points.
   *
   * @param grid the points of the surface
   * @param edgeMm the edge of a voxel, mm
   */
  RimPoints(FragmentSurface surface, PointGrid grid, double edgeMm) {
    this.surface = surface;
    rated =
        IntStream.range(0, surface.points().size())
            .mapToObj(n -> rate(n, grid.around(surface.points().get(n), BALL_EDGES * edgeMm)))
            .filter(each -> each.rating > LEAST_RATING)
            .sorted(Comparator.comparingDouble(each -> -each.rating))
            .limit(MOST)
            .toList();
    sharp = (int) rated.stream().filter(each -> each.rating > SHARP_RATING).count();
  }

  /** Returns the number of points, of which those most like a rim come first. */
  int size() {
    return rated.size();
  }

  /** Returns the number of points on sharp rims, which are the first ones. */
  int sharp() {
    return sharp;
  }

  /** Whether all points are on sharp rims, as on a large fragment. */
  boolean isSharp() {
    return sharp == size();
  }

  /** Returns a point with its frame. */
  Frame frame(int n) {
    return rated.get(n).frame;
  }

  private Rated rate(int n, int[] ball) {
    double[][] moments = new double[3][3];
    Vec3 mean = new Vec3();
    for (int m : ball) {
      Vec3 normal = surface.normals().get(m);
      mean.add(normal.mul(1.0 / ball.length, new Vec3()), mean);
      for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 3; column++) {
          moments[row][column] += normal.get(row) * normal.get(column) / ball.length;
        }
      }
    }
    SymmetricEigen eigen = new SymmetricEigen(moments);
    int[] order =
        IntStream.range(0, 3)
            .boxed()
            .sorted(Comparator.comparingDouble(eigen::value))
            .mapToInt(Integer::intValue)
            .toArray();
    Vec3 outward = vector(eigen, order[1]);
    if (mean.dot(outward) < 0) {
      outward.mul(-1, outward);
    }
    double along = mean.dot(outward);
    double across = Math.abs(mean.dot(vector(eigen, order[2])));
    boolean isOut = surface.normals().get(n).dot(outward) > LEAST_OUTWARD;
    Frame frame = new Frame(surface.points().get(n), vector(eigen, order[0]), outward);
    return new Rated(frame, isOut ? along - across - eigen.value(order[0]) : -1);
  }

  private static Vec3 vector(SymmetricEigen eigen, int n) {
    return new Vec3(eigen.component(n, 0), eigen.component(n, 1), eigen.component(n, 2));
  }
}
