package org.palpate.carve;

import java.util.List;
import org.palpate.volume.BitCube;

/**
 * The rate at which a tool cuts, and what it must not cut.
 *
 * @param rateMm3PerNewtonSecond the volume that a force of 1 N removes in a second, mm^3, at least
 *     0
 * @param leastNewtons for each segment the force below which it is a hard wall, N; if empty, any
 *     force cuts
 * @param kept a cube over the grid of the segments whose solid voxels nothing removes, or null; not
 *     copied
 */
public record CarveSettings(
    double rateMm3PerNewtonSecond, List<Double> leastNewtons, BitCube kept) {

  /**
   * Checks the rate.
   *
   * @throws IllegalArgumentException if it is negative or not finite
   */
  public CarveSettings {
    if (!(rateMm3PerNewtonSecond >= 0 && rateMm3PerNewtonSecond < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException(
          "the rate must not be negative: rateMm3PerNewtonSecond=" + rateMm3PerNewtonSecond);
    }
    leastNewtons = List.copyOf(leastNewtons);
  }

  /**
   * {@return settings by which any force cuts every voxel}
   *
   * @param mm3PerNewtonSecond volume removed per newton and second, mm^3/(N s), above 0
   */
  public static CarveSettings ofRate(double mm3PerNewtonSecond) {
    return new CarveSettings(mm3PerNewtonSecond, List.of(), null);
  }

  double leastNewton(int segment) {
    return leastNewtons.isEmpty() ? 0 : leastNewtons.get(segment);
  }

  boolean keeps(int i, int j, int k) {
    return kept != null && kept.get(i, j, k);
  }
}
