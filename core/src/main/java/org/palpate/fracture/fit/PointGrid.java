package org.palpate.fracture.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.palpate.geometry.Vec3;

/**
 * Points in cubic buckets, so that those near a place are found without a look at all of them. Work
 * and memory grow with the number of points and not with the size of their box. One thread an
 * instance.
 */
final class PointGrid {
  /** The bits of a key for each axis, and half the range that they cover. */
  private static final int KEY_BITS = 21;

  private static final int[] NONE = {};
  private static final long KEY_OFFSET = 1L << (KEY_BITS - 1);

  private final List<Vec3> points;
  private final double bucketMm;
  private final Map<Long, int[]> buckets = new HashMap<>();
  private int[] found = new int[64];

  /**
   * Puts points into buckets.
   *
   * @param points the points, which must not change
   * @param bucketMm the edge of a bucket, mm: about the radius in which points are sought
   */
  PointGrid(List<Vec3> points, double bucketMm) {
    this.points = points;
    this.bucketMm = bucketMm;
    Map<Long, List<Integer>> lists = new HashMap<>();
    for (int n = 0; n < points.size(); n++) {
      Vec3 p = points.get(n);
      long key = key(bucket(p.x), bucket(p.y), bucket(p.z));
      lists.computeIfAbsent(key, unused -> new ArrayList<>()).add(n);
    }
    lists.forEach(
        (key, list) -> buckets.put(key, list.stream().mapToInt(Integer::intValue).toArray()));
  }

  private long bucket(double mm) {
    return (long) Math.floor(mm / bucketMm);
  }

  private static long key(long i, long j, long k) {
    return ((i + KEY_OFFSET) << (2 * KEY_BITS)) + ((j + KEY_OFFSET) << KEY_BITS) + k + KEY_OFFSET;
  }

  /**
   * Returns the indices of the points within a radius, in an order that the points determine.
   *
   * @param middle the middle of the ball
   * @param mm its radius, mm
   */
  int[] around(Vec3 middle, double mm) {
    int count = 0;
    for (long i = bucket(middle.x - mm); i <= bucket(middle.x + mm); i++) {
      for (long j = bucket(middle.y - mm); j <= bucket(middle.y + mm); j++) {
        for (long k = bucket(middle.z - mm); k <= bucket(middle.z + mm); k++) {
          for (int n : buckets.getOrDefault(key(i, j, k), NONE)) {
            if (squareMm2(points.get(n), middle) < mm * mm) {
              found = count < found.length ? found : Arrays.copyOf(found, 2 * count);
              found[count++] = n;
            }
          }
        }
      }
    }
    return Arrays.copyOf(found, count);
  }

  private static double squareMm2(Vec3 p, Vec3 q) {
    double x = p.x - q.x;
    double y = p.y - q.y;
    double z = p.z - q.z;
    return x * x + y * y + z * z;
  }
}
