package org.palpate.benchmarks.moving;

import org.palpate.body.Body;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/**
 * Counts by brute force the pairs of solid voxels of two bodies whose interiors intersect, by the
 * 15 directions that can separate two cuboids. It sees neither sample points nor clearances. Keeps
 * scratch: one thread.
 */
final class VoxelOverlap {
  /** Voxels that share less than this only touch, mm. */
  private static final double TOUCHING_MM = 1e-9;

  /** The cross product of parallel edges is no direction. */
  private static final double LEAST_LENGTH = 1e-9;

  private static final Vec3[] UNITS = {new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1)};

  private final Vec3[] axes = {new Vec3(), new Vec3(), new Vec3()};
  private final Vec3 centre = new Vec3();
  private final Vec3 between = new Vec3();
  private final Vec3 direction = new Vec3();
  private final IntBox around = new IntBox();
  private final RigidTransform pose = RigidTransform.identity();

  /** Returns the number of pairs of voxels that overlap. */
  long count(Body a, Body b) {
    setAxes(a, b);
    long pairs = 0;
    IntBox box = a.bits().bounds();
    for (int k = box.lowZ; k <= box.highZ; k++) {
      for (int j = box.lowY; j <= box.highY; j++) {
        for (int i = box.lowX; i <= box.highX; i++) {
          pairs += a.bits().get(i, j, k) ? countAround(a, b, i, j, k) : 0;
        }
      }
    }
    return pairs;
  }

  /** Writes the axes of the voxels of a along the axes of the grid of b, unit, in mm. */
  private void setAxes(Body a, Body b) {
    a.pose().transform(pose);
    for (int n = 0; n < 3; n++) {
      a.grid().gridMmToWorld().rotate(UNITS[n], axes[n]);
      pose.rotate(axes[n], axes[n]);
      b.pose().rotation.inverseRotate(axes[n], axes[n]);
      b.grid().gridMmToWorld().inverseRotate(axes[n], axes[n]);
    }
  }

  private long countAround(Body a, Body b, int i, int j, int k) {
    a.grid().gridToWorld(centre.set(i + 0.5, j + 0.5, k + 0.5), centre);
    a.pose().transform(centre, centre);
    b.pose().inverseTransform(centre, centre);
    b.grid().worldToGrid(centre, centre);
    Vec3 spacing = b.grid().spacingMm();
    setAround(b, (a.grid().spacingMm().length() + spacing.length()) / 2);
    long pairs = 0;
    for (int w = around.lowZ; w <= around.highZ; w++) {
      for (int v = around.lowY; v <= around.highY; v++) {
        for (int u = around.lowX; u <= around.highX; u++) {
          boolean solid = b.bits().get(u, v, w);
          pairs += solid && overlaps(a.grid().spacingMm(), spacing, u, v, w) ? 1 : 0;
        }
      }
    }
    return pairs;
  }

  /** Sets the voxels of b whose centres may lie within a distance of the present centre. */
  private void setAround(Body b, double reachMm) {
    Vec3 spacing = b.grid().spacingMm();
    IntBox box = b.bits().bounds();
    around.lowX = low(centre.x - reachMm / spacing.x, box.lowX);
    around.lowY = low(centre.y - reachMm / spacing.y, box.lowY);
    around.lowZ = low(centre.z - reachMm / spacing.z, box.lowZ);
    around.highX = high(centre.x + reachMm / spacing.x, box.highX);
    around.highY = high(centre.y + reachMm / spacing.y, box.highY);
    around.highZ = high(centre.z + reachMm / spacing.z, box.highZ);
  }

  private static int low(double at, int least) {
    return (int) Math.max(least, Math.floor(at));
  }

  private static int high(double at, int most) {
    return (int) Math.min(most, Math.floor(at));
  }

  private boolean overlaps(Vec3 ofA, Vec3 ofB, int u, int v, int w) {
    between.set(
        (centre.x - u - 0.5) * ofB.x, (centre.y - v - 0.5) * ofB.y, (centre.z - w - 0.5) * ofB.z);
    for (int a = 0; a < 3; a++) {
      if (separates(ofA, ofB, UNITS[a]) || separates(ofA, ofB, axes[a])) {
        return false;
      }
      for (int b = 0; b < 3; b++) {
        if (separates(ofA, ofB, UNITS[b].cross(axes[a], direction))) {
          return false;
        }
      }
    }
    return true;
  }

  private boolean separates(Vec3 ofA, Vec3 ofB, Vec3 along) {
    double reach = 0;
    for (int c = 0; c < 3; c++) {
      reach += Math.abs(along.get(c)) * ofB.get(c) / 2;
      reach += Math.abs(along.dot(axes[c])) * ofA.get(c) / 2;
    }
    double length = along.length();
    return length > LEAST_LENGTH && Math.abs(along.dot(between)) - reach > -TOUCHING_MM * length;
  }
}
