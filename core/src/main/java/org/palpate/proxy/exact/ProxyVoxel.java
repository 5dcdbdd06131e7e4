package org.palpate.proxy.exact;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.RayHit;

/**
 * The empty voxel that contains the proxy, with the answers that follow from it and its 26
 * neighbours without a cast. They suffice in most frames of a hand that presses or slides slowly.
 *
 * <p>Relies on the proxy touching no solid. Keeps scratch, and recently used neighbourhoods until
 * {@link #forget}: haptic thread only.
 */
final class ProxyVoxel {
  /** The answer of {@link #axisOfRow} for a segment that is no row. */
  static final int NO_ROW = -1;

  private final NeighbourhoodCache neighbourhoods;
  private final boolean keeps;
  private CollisionScene scene;
  private Vec3 p;
  private int i;
  private int j;
  private int k;

  /** The solid neighbours, see {@link NeighbourhoodCache}; valid if they are known. */
  private long neighbours;

  private boolean knowsNeighbours;

  /**
   * Creates an instance that is in no voxel yet.
   *
   * @param keeps whether neighbourhoods are kept from frame to frame
   */
  ProxyVoxel(boolean keeps) {
    this.keeps = keeps;
    neighbourhoods = new NeighbourhoodCache(keeps);
  }

  /** Returns the number of neighbourhoods that were in the cache. */
  long knownNeighbourhoods() {
    return neighbourhoods.hits();
  }

  /** Forgets the neighbours, because the solids may have changed. */
  void forget() {
    neighbourhoods.forget();
    knowsNeighbours = false;
  }

  /** Follows the proxy after it moved, in the given scene. */
  void locate(CollisionScene newScene, Vec3 point) {
    if (newScene != scene) {
      forget();
    }
    scene = newScene;
    p = point;
    int newI = (int) Math.floor(point.x);
    int newJ = (int) Math.floor(point.y);
    int newK = (int) Math.floor(point.z);
    knowsNeighbours = knowsNeighbours && keeps && isCell(newI, newJ, newK);
    i = newI;
    j = newJ;
    k = newK;
  }

  /** Returns the coordinate of the voxel along an axis: 0 is x, 1 is y, 2 is z. */
  int cell(int axis) {
    return axis == 0 ? i : axis == 1 ? j : k;
  }

  /** Whether this is the voxel (i,j,k). */
  boolean isCell(int otherI, int otherJ, int otherK) {
    return i == otherI && j == otherJ && k == otherK;
  }

  /**
   * Whether the proxy lies on no grid plane, except perhaps one across the given axis. A segment
   * along the axis then touches only the voxels that it passes through.
   */
  boolean isOffPlanesExcept(int axis) {
    return (axis == 0 || p.x != i) && (axis == 1 || p.y != j) && (axis == 2 || p.z != k);
  }

  /**
   * Whether the segment from the proxy to {@code to} stays in this voxel. If so it touches no voxel
   * that the proxy does not touch already, and is free. Exact: comparisons alone.
   */
  boolean contains(Vec3 to) {
    return contains(i, to.x, p.x) && contains(j, to.y, p.y) && contains(k, to.z, p.z);
  }

  private static boolean contains(int cell, double to, double from) {
    return (to > cell && to < cell + 1.0) || to == from;
  }

  /**
   * Returns the axes, as bits, whose faces stop a segment to {@code to} before the proxy can move
   * at all. A face that may not do so is left out. A face counts under these conditions: the proxy
   * has stopped before it, the voxel beyond is solid, {@code to} lies on the face or beyond, and
   * the segment crosses this face before any face that does not stop it.
   */
  int facesThatStop(Vec3 to) {
    int faces =
        face(i, p.x, to.x, NeighbourhoodCache.STEP_X)
            | (face(j, p.y, to.y, NeighbourhoodCache.STEP_Y) << 1)
            | (face(k, p.z, to.z, NeighbourhoodCache.STEP_Z) << 2);
    return faces == 0 ? 0 : faces & ~crossedLate(faces, to);
  }

  private int face(int cell, double from, double to, int step) {
    if (to >= cell + 1.0) {
      return cell + 1.0 - from <= GuardedSolver.STOP_SHORT_VOXELS ? solidBeside(step) : 0;
    }
    return to <= cell && to < from && from - cell <= GuardedSolver.STOP_SHORT_VOXELS
        ? solidBeside(-step)
        : 0;
  }

  private int solidBeside(int step) {
    return (int) (neighbours() >>> (NeighbourhoodCache.CENTRE + step)) & 1;
  }

  /**
   * Returns the axes whose face may be crossed after some face that does not stop the segment.
   * Compares the parameters of crossings as products, to avoid divisions; the factor 2 is far more
   * than rounding can hide.
   */
  private int crossedLate(int faces, Vec3 to) {
    double deltaX = Math.abs(to.x - p.x);
    double deltaY = Math.abs(to.y - p.y);
    double deltaZ = Math.abs(to.z - p.z);
    int late = 0;
    if ((faces & 1) == 0) {
      double gap = to.x > p.x ? i + 1.0 - p.x : p.x - i;
      late |= late(deltaX, gap, deltaX, deltaY, deltaZ);
    }
    if ((faces & 2) == 0) {
      double gap = to.y > p.y ? j + 1.0 - p.y : p.y - j;
      late |= late(deltaY, gap, deltaX, deltaY, deltaZ);
    }
    if ((faces & 4) == 0) {
      double gap = to.z > p.z ? k + 1.0 - p.z : p.z - k;
      late |= late(deltaZ, gap, deltaX, deltaY, deltaZ);
    }
    return late;
  }

  private static int late(double delta, double gap, double deltaX, double deltaY, double deltaZ) {
    if (delta < gap || delta == 0) {
      return 0; // the segment ends before that face, but not before one that stops it
    }
    double least = 2 * GuardedSolver.STOP_SHORT_VOXELS * delta;
    return (least >= gap * deltaX ? 1 : 0)
        | (least >= gap * deltaY ? 2 : 0)
        | (least >= gap * deltaZ ? 4 : 0);
  }

  /**
   * Returns the axis along which the segment to {@code to} runs if it touches only the voxels of
   * one row, else {@link #NO_ROW}.
   */
  int axisOfRow(Vec3 to) {
    boolean alongX = to.x != p.x;
    boolean alongY = to.y != p.y;
    boolean alongZ = to.z != p.z;
    if (alongX) {
      return !alongY && !alongZ && isOffPlanesExcept(0) ? 0 : NO_ROW;
    }
    if (alongY) {
      return !alongZ && isOffPlanesExcept(1) ? 1 : NO_ROW;
    }
    return isOffPlanesExcept(2) ? 2 : NO_ROW;
  }

  /**
   * Casts a segment along a row of voxels. Exact: it reads the voxels of the row and computes
   * nothing but {@code hit.t}.
   *
   * @param axis the axis of the row, from {@link #axisOfRow}
   * @param to the coordinate of the end of the segment along the axis
   * @param hit receives the first solid voxel if the answer is true
   * @return whether the segment touches a solid voxel
   */
  boolean castRow(int axis, double to, RayHit hit) {
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
    return scene.isSolid(axis == 0 ? at : i, axis == 1 ? at : j, axis == 2 ? at : k);
  }

  /**
   * Whether the next voxel along an axis is empty, and so is a voxel beside that one towards the
   * device.
   */
  boolean isStepOpen(int axis, int direction, Vec3 device) {
    int above = NeighbourhoodCache.CENTRE + direction * NeighbourhoodCache.step(axis);
    long near = neighbours();
    return (near >>> above & 1) == 0
        && ((axis != 0 && isOpen(near, above, device.x - p.x, NeighbourhoodCache.STEP_X))
            || (axis != 1 && isOpen(near, above, device.y - p.y, NeighbourhoodCache.STEP_Y))
            || (axis != 2 && isOpen(near, above, device.z - p.z, NeighbourhoodCache.STEP_Z)));
  }

  private static boolean isOpen(long near, int above, double toDevice, int step) {
    return toDevice != 0 && (near >>> (toDevice > 0 ? above + step : above - step) & 1) == 0;
  }

  private long neighbours() {
    if (!knowsNeighbours) {
      knowsNeighbours = true;
      neighbours = neighbourhoods.around(scene, i, j, k);
    }
    return neighbours;
  }
}
