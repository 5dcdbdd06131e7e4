package org.palpate.proxy.smooth.field;

import java.util.ArrayDeque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.palpate.collision.CollisionScene;

/**
 * The smoothed field as its definition has it: every voxel that cannot be reached inside the window
 * adds its share times the convolution of two boxes of voxels and a quadratic B-spline, axis by
 * axis.
 */
final class NaiveOccupancyField {
  private final CollisionScene obstacles;
  private final int[][] boxes;
  private final Share share;

  /** The share of solid of a voxel that is solid or that can be reached. */
  interface Share {
    double of(int i, int j, int k, boolean isSolid);
  }

  /** The field for the two box widths along each axis. */
  NaiveOccupancyField(CollisionScene obstacles, int[][] boxes) {
    this(obstacles, boxes, (i, j, k, isSolid) -> isSolid ? 1 : 0);
  }

  /** The field of shares; what cannot be reached is wholly solid. */
  NaiveOccupancyField(CollisionScene obstacles, int[][] boxes, Share share) {
    this.obstacles = obstacles;
    this.boxes = boxes;
    this.share = share;
  }

  /** The value at a point as seen from the cell of the seed. */
  double value(double x, double y, double z, int[] seed) {
    int[] low = {low(x), low(y), low(z)};
    Set<List<Integer>> reached = flood(low, seed);
    double sum = 0;
    for (int k = low[2]; k < low[2] + 12; k++) {
      for (int j = low[1]; j < low[1] + 12; j++) {
        for (int i = low[0]; i < low[0] + 12; i++) {
          boolean isSolid = obstacles.isSolid(i, j, k);
          boolean isLost = !isSolid && !reached.contains(List.of(i, j, k));
          sum +=
              (isLost ? 1 : share.of(i, j, k, isSolid))
                  * weight(0, x - i - 0.5)
                  * weight(1, y - j - 0.5)
                  * weight(2, z - k - 0.5);
        }
      }
    }
    return sum;
  }

  private static int low(double v) {
    return (int) Math.floor(v + 0.5) - 6;
  }

  private double weight(int axis, double offset) {
    int wide = boxes[axis][0];
    int narrow = boxes[axis][1];
    double sum = 0;
    for (int a = 0; a < wide; a++) {
      for (int b = 0; b < narrow; b++) {
        sum += spline(offset - (a - (wide - 1) / 2.0) - (b - (narrow - 1) / 2.0));
      }
    }
    return sum / (wide * narrow);
  }

  private static double spline(double t) {
    double u = Math.abs(t);
    if (u <= 0.5) {
      return 0.75 - u * u;
    }
    return u < 1.5 ? 0.5 * (1.5 - u) * (1.5 - u) : 0;
  }

  private Set<List<Integer>> flood(int[] low, int[] seed) {
    Set<List<Integer>> reached = new HashSet<>();
    List<Integer> start = List.of(seed[0], seed[1], seed[2]);
    if (!isFree(low, start)) {
      addAllFree(low, reached);
      return reached;
    }
    ArrayDeque<List<Integer>> open = new ArrayDeque<>();
    open.add(start);
    reached.add(start);
    int[][] steps = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    while (!open.isEmpty()) {
      List<Integer> at = open.remove();
      for (int[] s : steps) {
        List<Integer> next = List.of(at.get(0) + s[0], at.get(1) + s[1], at.get(2) + s[2]);
        if (isFree(low, next) && reached.add(next)) {
          open.add(next);
        }
      }
    }
    return reached;
  }

  private void addAllFree(int[] low, Set<List<Integer>> reached) {
    for (int n = 0; n < 1728; n++) {
      List<Integer> voxel = List.of(low[0] + n % 12, low[1] + n / 12 % 12, low[2] + n / 144);
      if (isFree(low, voxel)) {
        reached.add(voxel);
      }
    }
  }

  private boolean isFree(int[] low, List<Integer> voxel) {
    for (int axis = 0; axis < 3; axis++) {
      if (voxel.get(axis) < low[axis] || voxel.get(axis) >= low[axis] + 12) {
        return false;
      }
    }
    return !obstacles.isSolid(voxel.get(0), voxel.get(1), voxel.get(2));
  }
}
