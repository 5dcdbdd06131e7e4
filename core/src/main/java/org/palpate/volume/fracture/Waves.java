package org.palpate.volume.fracture;

import org.palpate.geometry.Vec3;

/**
 * A smooth random displacement: a sum of sine waves of random directions and wavelengths for each
 * of its components. Millimetres. Immutable; any thread.
 */
final class Waves {
  private static final int WAVES = 10;
  private static final double FULL_TURN = 2 * Math.PI;

  /** Wave numbers along x, y, z, phase and amplitude of each wave of each component. */
  private final double[][][] waves = new double[3][WAVES][5];

  /**
   * Draws waves.
   *
   * @param rmsMm root mean square of each component
   * @param shortestMm the shortest wavelength
   * @param longestMm the longest wavelength; long waves are higher than short ones
   */
  Waves(Uniform random, double rmsMm, double shortestMm, double longestMm) {
    for (double[][] component : waves) {
      double sumOfSquares = 0;
      for (double[] wave : component) {
        double length = random.next(shortestMm, longestMm);
        Vec3 k = random.direction();
        k.mul(FULL_TURN / length, k);
        double height = Math.sqrt(length);
        wave[0] = k.x;
        wave[1] = k.y;
        wave[2] = k.z;
        wave[3] = random.next(0, FULL_TURN);
        wave[4] = height;
        sumOfSquares += height * height / 2;
      }
      for (double[] wave : component) {
        wave[4] *= rmsMm / Math.sqrt(sumOfSquares);
      }
    }
  }

  /** Adds the displacement at a position to it, mm. */
  void displace(Vec3 position) {
    double x = position.x;
    double y = position.y;
    double z = position.z;
    position.set(x + at(0, x, y, z), y + at(1, x, y, z), z + at(2, x, y, z));
  }

  private double at(int component, double x, double y, double z) {
    double sum = 0;
    for (double[] w : waves[component]) {
      sum += w[4] * StrictMath.sin(w[0] * x + w[1] * y + w[2] * z + w[3]);
    }
    return sum;
  }
}
