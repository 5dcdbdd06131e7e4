package org.palpate.proxy.exact;

import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;

/**
 * Remembers that no climb from a voxel led nearer to the device, and where each ended. As long as
 * the point stays in its voxel, and the device in its own along the axes on which a climb came as
 * far as the device, mostly the same faces stop the same climbs: where the ends, moved along with
 * the device as far as no face stopped them, are no nearer than the point, a search can be skipped.
 *
 * <p>Mostly: a climb that would go another way round by now is found only after the point has moved
 * on, or the device rests. Nothing else rests on it: a skipped search leaves the point where it is,
 * and a device that rests is searched for in full before the point does.
 */
final class FailedStepCache {
  /** Six directions and three stairs each are 18; more than this are not remembered. */
  private static final int CAPACITY = 24;

  private final GridMetric metric;
  private final boolean remembers;
  private final Vec3[] ends = new Vec3[CAPACITY];

  /**
   * For each end, as bits, the axes along which it lay before (1, 2, 4) or beyond the device (8,
   * 16, 32).
   */
  private final int[] stops = new int[CAPACITY];

  private final Vec3 device = new Vec3();
  private boolean known;

  /** The axes, as bits, along which a climb came as far as the device. */
  private int reached;

  private int count;
  private int i;
  private int j;
  private int k;
  private int way;

  FailedStepCache(GridMetric metric, boolean remembers) {
    this.metric = metric;
    this.remembers = remembers;
    for (int n = 0; n < CAPACITY; n++) {
      ends[n] = new Vec3();
    }
  }

  /** Forgets, since solids changed or the search was not a full one. */
  void forget() {
    known = false;
  }

  /**
   * Begins a search, and forgets the last one.
   *
   * @param voxel where the point is
   * @param newWay on which sides of the point the device lies, and how far, any code for it
   * @param newDevice where the device is
   */
  void begin(ProxyVoxel voxel, int newWay, Vec3 newDevice) {
    known = false;
    count = 0;
    reached = 0;
    way = newWay;
    i = voxel.cell(0);
    j = voxel.cell(1);
    k = voxel.cell(2);
    device.set(newDevice);
  }

  /** A climb would at best end at {@code end}, too far from the device, wherever that goes. */
  void addBest(Vec3 end) {
    if (count < CAPACITY) {
      ends[count].set(end);
      stops[count] =
          stop(end.x, device.x) | stop(end.y, device.y) << 1 | stop(end.z, device.z) << 2;
    }
    count++;
  }

  /** A climb ended at {@code end}, too far from the device. */
  void add(Vec3 end) {
    addBest(end);
    reached |=
        (end.x == device.x ? 1 : 0) | (end.y == device.y ? 2 : 0) | (end.z == device.z ? 4 : 0);
  }

  private static int stop(double end, double at) {
    return end < at ? 1 : end > at ? 8 : 0;
  }

  /** The search was in vain, and all its ends were added. */
  void remember() {
    known = remembers && count <= CAPACITY;
  }

  /**
   * Whether a search would be in vain again.
   *
   * @param square of the distance of the point from the device now, mm^2
   */
  boolean holds(ProxyVoxel voxel, int newWay, Vec3 newDevice, double square) {
    if (!known || way != newWay || !voxel.isCell(i, j, k) || !isWhereItWas(newDevice)) {
      return false;
    }
    for (int n = 0; n < count; n++) {
      if (nearest(ends[n], stops[n], newDevice) < square) {
        return false;
      }
    }
    return true;
  }

  /** Whether the device is in the same voxel, along the axes where that matters. */
  private boolean isWhereItWas(Vec3 now) {
    return ((reached & 1) == 0 || Math.floor(now.x) == Math.floor(device.x))
        && ((reached & 2) == 0 || Math.floor(now.y) == Math.floor(device.y))
        && ((reached & 4) == 0 || Math.floor(now.z) == Math.floor(device.z));
  }

  private double nearest(Vec3 end, int stop, Vec3 now) {
    double x = left(end.x, now.x, stop) * metric.spacingX();
    double y = left(end.y, now.y, stop >> 1) * metric.spacingY();
    double z = left(end.z, now.z, stop >> 2) * metric.spacingZ();
    return x * x + y * y + z * z;
  }

  /** How far the device is from the end along an axis, beyond the face that stopped it there. */
  private static double left(double end, double at, int stop) {
    // compared by hand, since Math.max of doubles takes several times as long
    if ((stop & 1) != 0) {
      return at > end ? at - end : 0;
    }
    return (stop & 8) != 0 && end > at ? end - at : 0;
  }
}
