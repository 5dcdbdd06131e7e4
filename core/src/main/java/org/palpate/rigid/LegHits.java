package org.palpate.rigid;

import org.palpate.raycast.Ray;
import org.palpate.raycast.RayHit;

/**
 * The legs of a proposed motion that touch a solid. For each other mover and each leaf of the tree
 * of sample points, verification adds at most one leg: the one that touches first. Written by
 * {@link BodyVerifier}; haptic thread only.
 */
final class LegHits {
  /** The number of hits at which verification stops, because the proposal is far from free. */
  static final int CAPACITY = 40;

  /** The value of {@link #axis} for a leg that starts at the voxel. */
  static final int NO_AXIS = -1;

  /**
   * The number of the pair; see {@link MoverVerifier}. Who carries the point makes no difference.
   */
  final int[] body = new int[CAPACITY + 1];

  final int[] point = new int[CAPACITY + 1];

  /** The fraction of the leg before it meets the solid, 0 to 1. */
  final double[] t = new double[CAPACITY + 1];

  /** The grid axis along which the leg enters the voxel: 0 is x. */
  final int[] axis = new int[CAPACITY + 1];

  /** The direction along that axis from the voxel to the leg's start: 1 or -1. */
  final int[] side = new int[CAPACITY + 1];

  /** The distance from the leg's start to the plane of the voxel's face, mm. */
  final double[] gapMm = new double[CAPACITY + 1];

  private int count;
  private int present;

  void clear() {
    count = 0;
  }

  /** Sets the number of the pair to which the next hits belong. */
  void setBody(int pair) {
    present = pair;
  }

  int count() {
    return count;
  }

  boolean isFull() {
    return count >= CAPACITY;
  }

  /** Adds a hit whose face is not known. */
  void add(int ofPoint, double atT) {
    body[count] = present;
    point[count] = ofPoint;
    t[count] = atT;
    axis[count] = NO_AXIS;
    count++;
  }

  /**
   * Adds to the last hit the face through which its leg enters a cell.
   *
   * @param hit of the leg, with an axis
   * @param edgeMm the edge of a cell along that axis, mm
   */
  void setFace(Ray leg, RayHit hit, double edgeMm) {
    double start = hit.axis == 0 ? leg.fromX : hit.axis == 1 ? leg.fromY : leg.fromZ;
    double end = hit.axis == 0 ? leg.toX : hit.axis == 1 ? leg.toY : leg.toZ;
    int cell = hit.cell(hit.axis);
    boolean up = end > start;
    axis[count - 1] = hit.axis;
    side[count - 1] = up ? -1 : 1;
    gapMm[count - 1] = (up ? cell - start : start - (cell + 1.0)) * edgeMm;
  }

  /** Removes all hits from index {@code first} on but the earliest. */
  void keepEarliestFrom(int first) {
    for (int n = first + 1; n < count; n++) {
      if (t[n] < t[first]) {
        copy(n, first);
      }
    }
    count = Math.min(count, first + 1);
  }

  /** Removes the earliest hit and moves it behind the others, at index {@link #count}. */
  int takeEarliest() {
    int earliest = 0;
    for (int n = 1; n < count; n++) {
      if (t[n] < t[earliest]) {
        earliest = n;
      }
    }
    count--;
    swap(earliest, count);
    return count;
  }

  private void swap(int a, int b) {
    int spare = CAPACITY;
    copy(a, spare);
    copy(b, a);
    copy(spare, b);
  }

  private void copy(int from, int to) {
    body[to] = body[from];
    point[to] = point[from];
    t[to] = t[from];
    axis[to] = axis[from];
    side[to] = side[from];
    gapMm[to] = gapMm[from];
  }
}
