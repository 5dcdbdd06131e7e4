package org.palpate.proxy.smooth;

import java.util.SplittableRandom;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;

/** Smooth solids of voxels: turned ellipsoids, and cavities of that form in a block. */
final class Quadrics {
  static final int EDGE = 44;

  private final GridMetric metric;
  private final Vec3 semiAxesMm;
  private final boolean isCavity;
  private final Quaternion turn = new Quaternion();
  private final Vec3 local = new Vec3();

  Quadrics(GridMetric metric, Vec3 semiAxesMm, boolean isCavity) {
    this.metric = metric;
    this.semiAxesMm = semiAxesMm;
    this.isCavity = isCavity;
    turn.setRotationVector(new Vec3(0.4, -0.7, 0.5));
  }

  /** Returns the voxels whose centres lie in the solid. */
  BitCube bits() {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    Vec3 centre = new Vec3();
    for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
      int i = n % EDGE;
      int j = n / EDGE % EDGE;
      int k = n / (EDGE * EDGE);
      if (level(centre.set(i + 0.5, j + 0.5, k + 0.5)) < 1 != isCavity) {
        bits.set(i, j, k);
      }
    }
    return bits;
  }

  /** Returns 1 on the ellipsoid, and less inside. */
  private double level(Vec3 grid) {
    double half = EDGE / 2.0;
    local.set(
        (grid.x - half) * metric.spacingX(),
        (grid.y - half) * metric.spacingY(),
        (grid.z - half) * metric.spacingZ());
    turn.rotate(local, local);
    double x = local.x / semiAxesMm.x;
    double y = local.y / semiAxesMm.y;
    double z = local.z / semiAxesMm.z;
    return Math.sqrt(x * x + y * y + z * z);
  }

  /**
   * Returns a position at about a height above the ellipsoid, on the side of empty space.
   *
   * @param mm the height, mm; negative in the solid
   */
  Vec3 position(SplittableRandom random, double mm) {
    Vec3 direction = new Vec3();
    do {
      direction.set(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
    } while (direction.length() > 1 || direction.length() < 0.1);
    direction.mul(1 / direction.length(), direction);
    double low = 0;
    double high = 60;
    Vec3 grid = new Vec3();
    for (int n = 0; n < 50; n++) {
      double middle = 0.5 * (low + high);
      if (level(along(direction, middle, grid)) < 1) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return along(direction, low + (isCavity ? -mm : mm), grid);
  }

  private Vec3 along(Vec3 direction, double mm, Vec3 dest) {
    double half = EDGE / 2.0;
    return dest.set(
        half + mm * direction.x / metric.spacingX(),
        half + mm * direction.y / metric.spacingY(),
        half + mm * direction.z / metric.spacingZ());
  }
}
