package org.palpate.proxy.exact;

import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;

/**
 * Remembers that no step up from a voxel led nearer to the device, and the point at which each
 * attempt ended. A search can be skipped as long as three conditions hold:
 *
 * <ul>
 *   <li>The proxy stays in its voxel, and the device stays on the same sides of it.
 *   <li>The device stays in its own voxel along each axis on which an attempt reached the device's
 *       coordinate. Then the same faces usually stop the same attempts.
 *   <li>No end is nearer to the device than the proxy is. For this test, an end moves with the
 *       device along each axis on which no face stopped it.
 * </ul>
 *
 * <p>"Usually": an attempt that would now take another path is found late, after the proxy has left
 * its voxel or when the device rests. Safety does not depend on it, because a skipped search leaves
 * the proxy where it is. The solver searches in full before it lets the proxy rest.
 *
 * <p>Haptic thread only; allocates nothing after construction.
 */
final class FailedStepCache {
  /**
   * The largest number of ends; a search with more is not remembered. Six directions of three steps
   * each make 18.
   */
  private static final int CAPACITY = 24;

  private final GridMetric metric;
  private final boolean remembers;
  private final Vec3[] ends = new Vec3[CAPACITY];

  /**
   * For each end, one bit for each axis: its coordinate is less (1, 2, 4) or greater (8, 16, 32)
   * than that of the device.
   */
  private final int[] endSides = new int[CAPACITY];

  private final Vec3 device = new Vec3();
  private boolean known;

  /** The axes, as bits, along which an attempt reached the device's coordinate. */
  private int reachedAxes;

  private int count;
  private int i;
  private int j;
  private int k;
  private int deviceSides;

  FailedStepCache(GridMetric metric, boolean remembers) {
    this.metric = metric;
    this.remembers = remembers;
    for (int n = 0; n < CAPACITY; n++) {
      ends[n] = new Vec3();
    }
  }

  /** Forgets the last search, because the solids changed or a full search is needed. */
  void forget() {
    known = false;
  }

  /**
   * Begins a search and forgets the last one.
   *
   * @param voxel the voxel of the proxy
   * @param p the proxy
   * @param newDevice the device position
   * @param far whether the device is so far away that the search tries several steps
   */
  void begin(ProxyVoxel voxel, Vec3 p, Vec3 newDevice, boolean far) {
    known = false;
    count = 0;
    reachedAxes = 0;
    deviceSides = sides(p, newDevice, far);
    i = voxel.cell(0);
    j = voxel.cell(1);
    k = voxel.cell(2);
    device.set(newDevice);
  }

  /** Adds the end of an attempt that would fail even if nothing stopped it on top of the step. */
  void addBestEnd(Vec3 end) {
    if (count < CAPACITY) {
      ends[count].set(end);
      endSides[count] =
          endSide(end.x, device.x) | endSide(end.y, device.y) << 1 | endSide(end.z, device.z) << 2;
    }
    count++;
  }

  /** Adds the end of an attempt that failed. */
  void addEnd(Vec3 end) {
    addBestEnd(end);
    reachedAxes |=
        (end.x == device.x ? 1 : 0) | (end.y == device.y ? 2 : 0) | (end.z == device.z ? 4 : 0);
  }

  private static int endSide(double end, double at) {
    return end < at ? 1 : end > at ? 8 : 0;
  }

  /** Remembers the search: it has failed, and the ends of all its attempts were added. */
  void remember() {
    known = remembers && count <= CAPACITY;
  }

  /**
   * Whether the remembered search would fail again.
   *
   * @param square the squared distance of the proxy p from the device now, mm^2
   */
  boolean wouldFailAgain(ProxyVoxel voxel, Vec3 p, Vec3 deviceNow, double square, boolean far) {
    if (!known
        || deviceSides != sides(p, deviceNow, far)
        || !voxel.isCell(i, j, k)
        || !isInSameVoxel(deviceNow)) {
      return false;
    }
    for (int n = 0; n < count; n++) {
      if (squareFromMovedEnd(ends[n], endSides[n], deviceNow) < square) {
        return false;
      }
    }
    return true;
  }

  /**
   * Returns the side of the proxy on which the device lies along each axis, two bits an axis, and
   * whether it is far, one bit.
   */
  private static int sides(Vec3 p, Vec3 device, boolean far) {
    return side(device.x - p.x)
        | side(device.y - p.y) << 2
        | side(device.z - p.z) << 4
        | (far ? 1 << 6 : 0);
  }

  private static int side(double toDevice) {
    return toDevice > 0 ? 1 : toDevice < 0 ? 2 : 0;
  }

  /** Whether the device is still in its voxel, along the axes that an attempt reached. */
  private boolean isInSameVoxel(Vec3 now) {
    return ((reachedAxes & 1) == 0 || Math.floor(now.x) == Math.floor(device.x))
        && ((reachedAxes & 2) == 0 || Math.floor(now.y) == Math.floor(device.y))
        && ((reachedAxes & 4) == 0 || Math.floor(now.z) == Math.floor(device.z));
  }

  private double squareFromMovedEnd(Vec3 end, int sides, Vec3 now) {
    double x = distance(end.x, now.x, sides) * metric.spacingX();
    double y = distance(end.y, now.y, sides >> 1) * metric.spacingY();
    double z = distance(end.z, now.z, sides >> 2) * metric.spacingZ();
    return x * x + y * y + z * z;
  }

  /** Returns the distance of the device along an axis from the face that stopped the end. */
  private static double distance(double end, double at, int side) {
    // Math.max of doubles would take several times as long.
    if ((side & 1) != 0) {
      return at > end ? at - end : 0;
    }
    return (side & 8) != 0 && end > at ? end - at : 0;
  }
}
