package org.palpate.elastic;

import java.util.Arrays;
import org.palpate.elastic.lattice.LatticeLayout;
import org.palpate.geometry.Vec3;

/**
 * The answer of the material at one point: its displacement under the force for which the field was
 * solved, and its compliance. It gives the force at which the spring to the device and the material
 * balance.
 *
 * <p>Haptic thread; allocates nothing after construction.
 */
final class LocalAnswer {
  /** The displacement, mm, and then the three columns of the compliance, mm/N. */
  private final double[] mm = new double[DeformationField.STRIDE];

  private final double[] baseNewton = new double[3];
  private final double[] b = new double[3];

  /** Starts a new point without displacement and compliance. */
  void clear(double[] base) {
    Arrays.fill(mm, 0);
    System.arraycopy(base, 0, baseNewton, 0, 3);
  }

  /** Adds the values of a node with a weight. */
  void add(double weight, float[] values, int from, LatticeLayout layout) {
    for (int n = 0; n < mm.length; n++) {
      mm[n] += weight * values[from + n] * layout.edgeMm(n % 3);
    }
  }

  /**
   * Writes the displacement of the point, mm.
   *
   * @param changeNewton the change of the force since the field was solved
   */
  void displacementMm(double[] changeNewton, Vec3 dest) {
    dest.set(along(0, changeNewton), along(1, changeNewton), along(2, changeNewton));
  }

  private double along(int row, double[] change) {
    return mm[row] + change[0] * mm[3 + row] + change[1] * mm[6 + row] + change[2] * mm[9 + row];
  }

  /**
   * Writes the force at which spring and material balance in all three directions.
   *
   * @param reachMm the vector from the material point at rest to the end of the spring, mm
   * @param dest receives the force on the material, N
   */
  void balance(Vec3 reachMm, double newtonPerMm, Vec3 dest) {
    double k = newtonPerMm;
    for (int row = 0; row < 3; row++) {
      b[row] = k * (reachMm.get(row) - mm[row]) - baseNewton[row];
    }
    double m00 = 1 + k * mm[3];
    double m10 = k * mm[4];
    double m20 = k * mm[5];
    double m01 = k * mm[6];
    double m11 = 1 + k * mm[7];
    double m21 = k * mm[8];
    double m02 = k * mm[9];
    double m12 = k * mm[10];
    double m22 = 1 + k * mm[11];
    double c0 = m11 * m22 - m12 * m21;
    double c1 = m12 * m20 - m10 * m22;
    double c2 = m10 * m21 - m11 * m20;
    double inverse = 1 / (m00 * c0 + m01 * c1 + m02 * c2);
    double x = c0 * b[0] + (m02 * m21 - m01 * m22) * b[1] + (m01 * m12 - m02 * m11) * b[2];
    double y = c1 * b[0] + (m00 * m22 - m02 * m20) * b[1] + (m02 * m10 - m00 * m12) * b[2];
    double z = c2 * b[0] + (m01 * m20 - m00 * m21) * b[1] + (m00 * m11 - m01 * m10) * b[2];
    dest.set(baseNewton[0] + inverse * x, baseNewton[1] + inverse * y, baseNewton[2] + inverse * z);
  }
}
