package org.palpate.fracture;

import org.palpate.geometry.AffineMap;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.fracture.PosedBits;

/**
 * Counts pairs of voxels of two posed fragments whose interiors intersect, by the 15 axes that can
 * separate two boxes. It compares every pair of near voxels. One thread an instance.
 *
 * <p>Reference: Gottschalk, Lin, Manocha, OBBTree, 1996.
 */
public final class VoxelOverlap {
  /** Voxels that share less than this along some axis only touch, mm. */
  private static final double TOUCHING_MM = 1e-9;

  private final PosedBits one;
  private final BitCube otherBits;
  private final Vec3 spacing;
  private final Vec3 ownHalf;
  private final AffineMap map;

  /** The unit axes of the one fragment's voxels, along the axes of the other's grid. */
  private final Vec3[] axes = new Vec3[3];

  /** The 15 directions along which two voxels may be apart, and the half widths of both there. */
  private final Vec3[] directions = new Vec3[15];

  private final double[] reachesMm = new double[15];
  private final double longestMm;

  /**
   * Prepares to count; poses and bits must not change meanwhile.
   *
   * @param one the fragment whose voxels are visited
   * @param other the fragment whose voxels near them are looked up
   */
  public VoxelOverlap(PosedBits one, PosedBits other) {
    this.one = one;
    otherBits = other.bits();
    spacing = other.grid().spacingMm();
    Vec3 own = one.grid().spacingMm();
    ownHalf = new Vec3(own.x / 2, own.y / 2, own.z / 2);
    map = other.gridFrom(one.grid(), one.pose());
    longestMm = (own.length() + spacing.length()) / 2;
    for (int axis = 0; axis < 3; axis++) {
      Vec3 step = new Vec3();
      step.set(axis, 1 / own.get(axis));
      map.transformDirection(step, step);
      axes[axis] = new Vec3(step.x * spacing.x, step.y * spacing.y, step.z * spacing.z);
    }
    setDirections();
  }

  private void setDirections() {
    int count = 0;
    for (int a = 0; a < 3; a++) {
      Vec3 unit = new Vec3();
      unit.set(a, 1);
      directions[count++] = unit;
      directions[count++] = axes[a];
      for (int b = 0; b < 3; b++) {
        directions[count++] = unit.cross(axes[b], new Vec3());
      }
    }
    for (int n = 0; n < count; n++) {
      Vec3 d = directions[n];
      double length = d.length();
      d = directions[n] = d.mul(length > 1e-9 ? 1 / length : 0, new Vec3());
      for (int axis = 0; axis < 3; axis++) {
        reachesMm[n] += Math.abs(d.get(axis)) * spacing.get(axis) / 2;
        reachesMm[n] += Math.abs(d.dot(axes[axis])) * ownHalf.get(axis);
      }
    }
  }

  /** {@return the number of pairs} */
  public long count() {
    long pairs = 0;
    IntBox box = one.bits().bounds();
    Vec3 p = new Vec3();
    for (int k = box.lowZ; k <= box.highZ; k++) {
      for (int j = box.lowY; j <= box.highY; j++) {
        for (int i = box.lowX; i <= box.highX; i++) {
          if (one.bits().get(i, j, k)) {
            pairs += countAt(map.transform(p.set(i + 0.5, j + 0.5, k + 0.5), p));
          }
        }
      }
    }
    return pairs;
  }

  /** Returns the number of voxels of the other fragment that a voxel with a centre overlaps. */
  private int countAt(Vec3 c) {
    IntBox box = otherBits.bounds();
    int pairs = 0;
    int highZ = (int) Math.min(box.highZ, c.z + longestMm / spacing.z);
    int highY = (int) Math.min(box.highY, c.y + longestMm / spacing.y);
    int highX = (int) Math.min(box.highX, c.x + longestMm / spacing.x);
    for (int k = low(box.lowZ, c.z - longestMm / spacing.z); k <= highZ; k++) {
      for (int j = low(box.lowY, c.y - longestMm / spacing.y); j <= highY; j++) {
        for (int i = low(box.lowX, c.x - longestMm / spacing.x); i <= highX; i++) {
          pairs += otherBits.get(i, j, k) && overlaps(c, i, j, k) ? 1 : 0;
        }
      }
    }
    return pairs;
  }

  private static int low(int least, double coordinate) {
    return (int) Math.max(least, Math.floor(coordinate));
  }

  private boolean overlaps(Vec3 c, int i, int j, int k) {
    double x = (c.x - i - 0.5) * spacing.x;
    double y = (c.y - j - 0.5) * spacing.y;
    double z = (c.z - k - 0.5) * spacing.z;
    for (int n = 0; n < directions.length; n++) {
      Vec3 d = directions[n];
      boolean isDirection = d.x != 0 || d.y != 0 || d.z != 0;
      if (isDirection && Math.abs(d.x * x + d.y * y + d.z * z) >= reachesMm[n] - TOUCHING_MM) {
        return false;
      }
    }
    return true;
  }
}
