package org.palpate.accuracy;

import java.math.BigDecimal;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;

/**
 * Computes the free points nearest to a device exactly. It tests every empty voxel of the grid and
 * of a rim of one voxel around it in unlimited decimal fractions, without rounding.
 */
final class ExactNearest {
  private final BitCube bits;
  private final Vec3 device;
  private final BigDecimal[][] squaresMm;
  private BigDecimal leastMm2;

  /**
   * Finds the points nearest to {@code device}, grid coordinates, in voxels of {@code spacingMm}.
   */
  ExactNearest(BitCube bits, Vec3 spacingMm, Vec3 device) {
    this.bits = bits;
    this.device = device;
    int[] sizes = {bits.sizeX(), bits.sizeY(), bits.sizeZ()};
    squaresMm = new BigDecimal[3][];
    for (int axis = 0; axis < 3; axis++) {
      squaresMm[axis] = new BigDecimal[sizes[axis] + 2];
      for (int cell = -1; cell <= sizes[axis]; cell++) {
        BigDecimal mm =
            difference(clamp(device.get(axis), cell), device.get(axis))
                .multiply(new BigDecimal(spacingMm.get(axis)));
        squaresMm[axis][cell + 1] = mm.multiply(mm);
      }
    }
    forEachFree(
        (i, j, k) -> {
          BigDecimal square = square(i, j, k);
          leastMm2 = leastMm2 == null || square.compareTo(leastMm2) < 0 ? square : leastMm2;
        });
  }

  /** Whether one of the nearest free points, which may be several, is within some voxels of p. */
  boolean isWithin(Vec3 p, double voxels) {
    BigDecimal most = new BigDecimal(voxels).pow(2);
    boolean[] found = new boolean[1];
    forEachFree(
        (i, j, k) ->
            found[0] |=
                square(i, j, k).compareTo(leastMm2) == 0
                    && squareTo(p, i, j, k).compareTo(most) <= 0);
    return found[0];
  }

  /** An action on a voxel. */
  private interface Visitor {
    void visit(int i, int j, int k);
  }

  private void forEachFree(Visitor visitor) {
    for (int k = -1; k <= bits.sizeZ(); k++) {
      for (int j = -1; j <= bits.sizeY(); j++) {
        for (int i = -1; i <= bits.sizeX(); i++) {
          if (!bits.get(i, j, k)) {
            visitor.visit(i, j, k);
          }
        }
      }
    }
  }

  private BigDecimal square(int i, int j, int k) {
    return squaresMm[0][i + 1].add(squaresMm[1][j + 1]).add(squaresMm[2][k + 1]);
  }

  /** Returns the squared distance from p to the point of the voxel nearest to the device. */
  private BigDecimal squareTo(Vec3 p, int i, int j, int k) {
    BigDecimal x = difference(clamp(device.x, i), p.x);
    BigDecimal y = difference(clamp(device.y, j), p.y);
    BigDecimal z = difference(clamp(device.z, k), p.z);
    return x.multiply(x).add(y.multiply(y)).add(z.multiply(z));
  }

  /** Returns the device's own coordinate or an integer, so the result is exact. */
  private static double clamp(double at, int cell) {
    return Math.max(cell, Math.min(cell + 1.0, at));
  }

  private static BigDecimal difference(double a, double b) {
    return new BigDecimal(a).subtract(new BigDecimal(b));
  }
}
