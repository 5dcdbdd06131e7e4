package org.palpate.rigid.tool;

import org.palpate.geometry.Vec3;

/**
 * Searches among the sample points near another one. Points that are near in the order of the tree
 * are near in space. Allocates nothing; any thread.
 */
public final class SampleNeighbours {
  /** The number of points on either side that are searched. */
  private static final int POINTS = 48;

  private SampleNeighbours() {}

  /**
   * {@return the point that lies lowest along a direction}
   *
   * @param tool the sample points and their tree
   * @param point the index of the point near which to search; the answer if no other is lower by
   *     more than the difference
   * @param up unit, tool frame
   * @param differenceMm how much lower another point must lie, mm
   */
  public static int lowest(RigidTool tool, int point, Vec3 up, double differenceMm) {
    int lowest = point;
    double least = along(up, tool, point) - differenceMm;
    int last = Math.min(tool.count() - 1, point + POINTS);
    for (int n = Math.max(0, point - POINTS); n <= last; n++) {
      double height = along(up, tool, n);
      if (height < least) {
        least = height;
        lowest = n;
      }
    }
    return lowest;
  }

  private static double along(Vec3 up, RigidTool tool, int n) {
    return up.x * tool.x(n) + up.y * tool.y(n) + up.z * tool.z(n);
  }

  /**
   * {@return the point that is nearest to a position}
   *
   * @param tool the sample points and their tree
   * @param point the index of the point near which to search
   * @param at the position, tool frame, mm
   */
  public static int nearest(RigidTool tool, int point, Vec3 at) {
    int nearest = point;
    double least = squaredDistance(tool, point, at);
    int last = Math.min(tool.count() - 1, point + POINTS);
    for (int n = Math.max(0, point - POINTS); n <= last; n++) {
      double square = squaredDistance(tool, n, at);
      if (square < least) {
        least = square;
        nearest = n;
      }
    }
    return nearest;
  }

  private static double squaredDistance(RigidTool tool, int n, Vec3 at) {
    double x = tool.x(n) - at.x;
    double y = tool.y(n) - at.y;
    double z = tool.z(n) - at.z;
    return x * x + y * y + z * z;
  }
}
