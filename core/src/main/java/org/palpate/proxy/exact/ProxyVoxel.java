package org.palpate.proxy.exact;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.RayHit;

/**
 * The empty voxel that the interaction point is in, and what can be told from it and its 26
 * neighbours alone, without a cast: most frames of a hand that presses or slides slowly.
 *
 * <p>Relies on the point touching no solid. Keeps scratch, and the neighbours of the voxels last
 * looked at until {@link #forget}: haptic thread only.
 */
final class ProxyVoxel {
  private final NeighbourhoodCache neighbourhoods;
  private final boolean keeps;
  private CollisionScene obstacles;
  private Vec3 p;
  private int i;
  private int j;
  private int k;

  /** The solid neighbours, see {@link NeighbourhoodCache}, once asked for. */
  private long solidNear;

  private boolean knowsNear;

  /** In no voxel yet; {@code keeps} says whether neighbours are kept. */
  ProxyVoxel(boolean keeps) {
    this.keeps = keeps;
    neighbourhoods = new NeighbourhoodCache(keeps);
  }

  /** How often the neighbours were known. */
  long knownNeighbours() {
    return neighbourhoods.known();
  }

  /** Forgets what was solid, since that may have changed. */
  void forget() {
    neighbourhoods.forget();
    knowsNear = false;
  }

  /** Sets the point, after it moved. */
  void locate(CollisionScene solids, Vec3 point) {
    if (solids != obstacles) {
      forget();
    }
    obstacles = solids;
    p = point;
    int newI = (int) Math.floor(point.x);
    int newJ = (int) Math.floor(point.y);
    int newK = (int) Math.floor(point.z);
    knowsNear = knowsNear && keeps && isCell(newI, newJ, newK);
    i = newI;
    j = newJ;
    k = newK;
  }

  /** The voxel's coordinate along an axis. */
  int cell(int axis) {
    return axis == 0 ? i : axis == 1 ? j : k;
  }

  /** Whether this is the voxel (i,j,k). */
  boolean isCell(int otherI, int otherJ, int otherK) {
    return i == otherI && j == otherJ && k == otherK;
  }

  /**
   * Whether the point lies on no grid plane but maybe one across the axis, so that a way along the
   * axis touches only the voxels that it goes through.
   */
  boolean isInsideBut(int axis) {
    return (axis == 0 || p.x != i) && (axis == 1 || p.y != j) && (axis == 2 || p.z != k);
  }

  /**
   * Whether the straight way from the point to {@code to} stays in this voxel, and so touches no
   * voxel that the point itself does not touch: it is free for sure. Exact: only comparisons.
   */
  boolean contains(Vec3 to) {
    return contains(i, to.x, p.x) && contains(j, to.y, p.y) && contains(k, to.z, p.z);
  }

  private static boolean contains(int cell, double to, double from) {
    return (to > cell && to < cell + 1.0) || to == from;
  }

  /**
   * The axes, as bits, whose faces stop the straight way to {@code to} before the point can move at
   * all; one that is not sure to do so is left out. Sure is: the point has come to its stop before
   * the face, the voxel beyond is solid, {@code to} lies at the face or beyond, and the way crosses
   * this face before any face that is no such stop.
   */
  int stopsOnWayTo(Vec3 to) {
    int stops =
        stop(i, p.x, to.x, NeighbourhoodCache.STEP_X)
            | (stop(j, p.y, to.y, NeighbourhoodCache.STEP_Y) << 1)
            | (stop(k, p.z, to.z, NeighbourhoodCache.STEP_Z) << 2);
    return stops == 0 ? 0 : stops & ~crossedTooLate(stops, to);
  }

  private int stop(int cell, double from, double to, int step) {
    if (to >= cell + 1.0) {
      return cell + 1.0 - from <= GuardedSolver.STOP_SHORT_VOXELS ? solidBeside(step) : 0;
    }
    return to <= cell && to < from && from - cell <= GuardedSolver.STOP_SHORT_VOXELS
        ? solidBeside(-step)
        : 0;
  }

  private int solidBeside(int step) {
    return (int) (solidNear() >>> (NeighbourhoodCache.CENTRE + step)) & 1;
  }

  /**
   * The stops that some other face may be crossed before. Compares parameters of crossings as
   * products, so that nothing is divided; twice is far more than rounding can hide.
   */
  private int crossedTooLate(int stops, Vec3 to) {
    double deltaX = Math.abs(to.x - p.x);
    double deltaY = Math.abs(to.y - p.y);
    double deltaZ = Math.abs(to.z - p.z);
    int late = 0;
    if ((stops & 1) == 0) {
      double gap = to.x > p.x ? i + 1.0 - p.x : p.x - i;
      late |= late(deltaX, gap, deltaX, deltaY, deltaZ);
    }
    if ((stops & 2) == 0) {
      double gap = to.y > p.y ? j + 1.0 - p.y : p.y - j;
      late |= late(deltaY, gap, deltaX, deltaY, deltaZ);
    }
    if ((stops & 4) == 0) {
      double gap = to.z > p.z ? k + 1.0 - p.z : p.z - k;
      late |= late(deltaZ, gap, deltaX, deltaY, deltaZ);
    }
    return late;
  }

  private static int late(double delta, double gap, double deltaX, double deltaY, double deltaZ) {
    if (delta < gap || delta == 0) {
      return 0; // the way ends before that face, but not before a stop
    }
    double least = 2 * GuardedSolver.STOP_SHORT_VOXELS * delta;
    return (least >= gap * deltaX ? 1 : 0)
        | (least >= gap * deltaY ? 2 : 0)
        | (least >= gap * deltaZ ? 4 : 0);
  }

  /**
   * The axis along which the straight way to {@code to} runs, where it runs along one and touches
   * only the voxels that it goes through; else -1.
   */
  int axisOfWay(Vec3 to) {
    boolean alongX = to.x != p.x;
    boolean alongY = to.y != p.y;
    boolean alongZ = to.z != p.z;
    if (alongX) {
      return !alongY && !alongZ && isInsideBut(0) ? 0 : -1;
    }
    if (alongY) {
      return !alongZ && isInsideBut(1) ? 1 : -1;
    }
    return isInsideBut(2) ? 2 : -1;
  }

  /**
   * Whether the way along an axis touches a solid, and the first one that it meets. Exact: a row of
   * voxels is looked at, and nothing computed but {@code hit.t}.
   *
   * @param axis as {@link #axisOfWay} says
   */
  boolean meetsAlong(int axis, double to, RayHit hit) {
    double from = p.get(axis);
    int step = to > from ? 1 : -1;
    int last = to > from ? (int) Math.floor(to) : (int) Math.ceil(to) - 1;
    int at = cell(axis);
    while (at != last) {
      at += step;
      if (isSolidInRow(axis, at, step)) {
        double plane = step > 0 ? at : at + 1;
        hit.set((plane - from) / (to - from), i, j, k, axis);
        hit.setCell(axis, at);
        return true;
      }
    }
    return false;
  }

  private boolean isSolidInRow(int axis, int at, int step) {
    if (at == cell(axis) + step) {
      return solidBeside(step * NeighbourhoodCache.step(axis)) != 0;
    }
    return obstacles.isSolid(axis == 0 ? at : i, axis == 1 ? at : j, axis == 2 ? at : k);
  }

  /** Whether the next voxel along an axis is empty, and one beside that towards the device. */
  boolean isStairOpen(int axis, int direction, Vec3 device) {
    int above = NeighbourhoodCache.CENTRE + direction * NeighbourhoodCache.step(axis);
    long near = solidNear();
    return (near >>> above & 1) == 0
        && ((axis != 0 && isOpen(near, above, device.x - p.x, NeighbourhoodCache.STEP_X))
            || (axis != 1 && isOpen(near, above, device.y - p.y, NeighbourhoodCache.STEP_Y))
            || (axis != 2 && isOpen(near, above, device.z - p.z, NeighbourhoodCache.STEP_Z)));
  }

  private static boolean isOpen(long near, int above, double toDevice, int step) {
    return toDevice != 0 && (near >>> (toDevice > 0 ? above + step : above - step) & 1) == 0;
  }

  private long solidNear() {
    if (!knowsNear) {
      knowsNear = true;
      solidNear = neighbourhoods.around(obstacles, i, j, k);
    }
    return solidNear;
  }
}
