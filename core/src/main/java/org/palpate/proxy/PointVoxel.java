package org.palpate.proxy;

import org.palpate.geometry.Vec3;

/**
 * The empty voxel that the interaction point is in, and what can be told from it and its six
 * neighbours alone, without a cast: most frames of a hand that presses or slides slowly.
 *
 * <p>Relies on the point touching no solid. Keeps scratch: haptic thread only.
 */
final class PointVoxel {
  private final int[] cell = new int[3];
  private Obstacles obstacles;
  private Vec3 p;

  /** Sets the point, after it moved. */
  void locate(Obstacles solids, Vec3 point) {
    obstacles = solids;
    p = point;
    cell[0] = (int) Math.floor(point.x);
    cell[1] = (int) Math.floor(point.y);
    cell[2] = (int) Math.floor(point.z);
  }

  /** The voxel's coordinate along an axis. */
  int cell(int axis) {
    return cell[axis];
  }

  /** Whether this is the voxel (i,j,k). */
  boolean isCell(int i, int j, int k) {
    return cell[0] == i && cell[1] == j && cell[2] == k;
  }

  /**
   * Whether the point lies on no grid plane but maybe one across the axis, so that a way along the
   * axis touches only the voxels that it goes through.
   */
  boolean isInsideBut(int axis) {
    return (axis == 0 || p.x != cell[0])
        && (axis == 1 || p.y != cell[1])
        && (axis == 2 || p.z != cell[2]);
  }

  /**
   * Whether the straight way from the point to {@code to} stays in this voxel, and so touches no
   * voxel that the point itself does not touch: it is free for sure. Exact: only comparisons.
   */
  boolean contains(Vec3 to) {
    return contains(0, to.x, p.x) && contains(1, to.y, p.y) && contains(2, to.z, p.z);
  }

  private boolean contains(int axis, double to, double from) {
    return (to > cell[axis] && to < cell[axis] + 1.0) || to == from;
  }

  /**
   * An axis whose face stops the straight way to {@code to} before the point can move at all, or -1
   * where that is not sure. Sure is: the point has come to its stop before the face, the voxel
   * beyond is solid, {@code to} lies at the face or beyond, and the way crosses this face before
   * any face that is no such stop.
   */
  int stopOnWayTo(Vec3 to) {
    int stops = stopsTowards(to);
    for (int axis = 0; stops >> axis != 0; axis++) {
      if ((stops >> axis & 1) != 0 && isCrossedFirst(axis, stops, to)) {
        return axis;
      }
    }
    return -1;
  }

  private int stopsTowards(Vec3 to) {
    return (isStop(0, p.x, to.x) ? 1 : 0)
        | (isStop(1, p.y, to.y) ? 2 : 0)
        | (isStop(2, p.z, to.z) ? 4 : 0);
  }

  private boolean isStop(int axis, double from, double to) {
    if (to >= cell[axis] + 1.0) {
      return cell[axis] + 1 - from <= GuardedSolver.STOP_SHORT_VOXELS && isSolidBeside(axis, 1);
    }
    return to <= cell[axis]
        && to < from
        && from - cell[axis] <= GuardedSolver.STOP_SHORT_VOXELS
        && isSolidBeside(axis, -1);
  }

  private boolean isSolidBeside(int axis, int step) {
    return obstacles.isSolid(
        axis == 0 ? cell[0] + step : cell[0],
        axis == 1 ? cell[1] + step : cell[1],
        axis == 2 ? cell[2] + step : cell[2]);
  }

  /**
   * Compares parameters of crossings as products, so that nothing is divided; twice is far more
   * than rounding can hide.
   */
  private boolean isCrossedFirst(int stop, int stops, Vec3 to) {
    double stopDelta = Math.abs(to.get(stop) - p.get(stop));
    for (int axis = 0; axis < 3; axis++) {
      double delta = to.get(axis) - p.get(axis);
      double gap = delta > 0 ? cell[axis] + 1 - p.get(axis) : p.get(axis) - cell[axis];
      boolean other = (stops >> axis & 1) == 0 && delta != 0;
      if (other && 2 * GuardedSolver.STOP_SHORT_VOXELS * Math.abs(delta) >= gap * stopDelta) {
        return false;
      }
    }
    return true;
  }
}
