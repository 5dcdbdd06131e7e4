package org.palpate.proxy;

import org.palpate.geometry.Vec3;

/**
 * Remembers that no climb from a voxel led nearer to the device, how near the best one came, and
 * where the device was: the places that climbs reach come nearer by no more than the device moves,
 * so until that makes up for the difference a search can be skipped.
 *
 * <p>Nothing rests on it but time: a skipped search leaves the point where it is.
 */
final class FruitlessClimbs {
  private final Metric metric;
  private final Vec3 device = new Vec3();
  private boolean known;
  private int i;
  private int j;
  private int k;
  private int sides;
  private double nearestMm;

  FruitlessClimbs(Metric metric) {
    this.metric = metric;
  }

  /** Forgets, since solids changed. */
  void forget() {
    known = false;
  }

  /**
   * Remembers a search.
   *
   * @param voxel where the point was
   * @param newSides on which sides of the point the device lay, any code for it
   * @param newDevice where the device was
   * @param newNearestMm the least distance to the device at which a climb ended; infinite where
   *     there was none to try
   */
  void remember(PointVoxel voxel, int newSides, Vec3 newDevice, double newNearestMm) {
    known = true;
    sides = newSides;
    i = voxel.cell(0);
    j = voxel.cell(1);
    k = voxel.cell(2);
    device.set(newDevice);
    nearestMm = newNearestMm;
  }

  /**
   * Whether a search would be in vain again.
   *
   * @param distanceMm of the point from the device now
   */
  boolean holds(PointVoxel voxel, int newSides, Vec3 newDevice, double distanceMm) {
    return known
        && sides == newSides
        && voxel.isCell(i, j, k)
        && nearestMm
                - metric.distance(
                    device.x, device.y, device.z, newDevice.x, newDevice.y, newDevice.z)
            >= distanceMm;
  }
}
