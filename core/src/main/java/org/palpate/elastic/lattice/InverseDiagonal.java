package org.palpate.elastic.lattice;

import java.util.Arrays;

/**
 * The reciprocals of the diagonal of a stiffness: the same for the three entries of a node, and
 * zero for a fixed node.
 *
 * <p>Each cell counts with the largest entry of its diagonal. So the diagonal is the same for every
 * rotation, and {@link #largestEigenvalue} bounds its product with the stiffness for all rotations
 * and moduli. One thread.
 */
final class InverseDiagonal {
  private static final int POWER_STEPS = 60;

  /** Covers what the power iteration lacks. */
  private static final double BOUND_FACTOR = 1.05;

  private final ActiveCells cells;
  private final float largestEntry;
  private final float largestEigenvalue;
  private final float[] inverse;
  private final float[] sums;

  InverseDiagonal(ActiveCells cells, float[] element) {
    this.cells = cells;
    float largest = 0;
    for (int n = 0; n < HexahedronStiffness.SIZE; n++) {
      largest = Math.max(largest, element[n * HexahedronStiffness.SIZE + n]);
    }
    largestEntry = largest;
    largestEigenvalue = (float) (BOUND_FACTOR * powerIteration(element) / largest);
    sums = new float[cells.layout().nodeCount()];
    inverse = new float[3 * sums.length];
  }

  private static double powerIteration(float[] element) {
    int size = HexahedronStiffness.SIZE;
    double[] from = new double[size];
    double[] to = new double[size];
    for (int n = 0; n < size; n++) {
      from[n] = StrictMath.sin(1 + 1.7 * n);
    }
    double norm = 0;
    for (int step = 0; step < POWER_STEPS; step++) {
      norm = 0;
      for (int row = 0; row < size; row++) {
        to[row] = 0;
        for (int column = 0; column < size; column++) {
          to[row] += element[size * row + column] * from[column];
        }
        norm += to[row] * to[row];
      }
      norm = Math.sqrt(norm);
      for (int n = 0; n < size; n++) {
        from[n] = to[n] / norm;
      }
    }
    return norm;
  }

  /** Returns a bound of the eigenvalues of this times the stiffness. */
  float largestEigenvalue() {
    return largestEigenvalue;
  }

  /** Takes the moduli of the listed cells, and the springs that hold nodes, N/mm. */
  void update(float[] modulus, float[] hold) {
    Arrays.fill(sums, 0);
    for (int cell = 0; cell < cells.count(); cell++) {
      int first = cells.firstNode(cell);
      for (int corner = 0; corner < LatticeLayout.CORNERS; corner++) {
        sums[first + cells.layout().cornerOffset(corner)] += modulus[cell];
      }
    }
    for (int node = 0; node < sums.length; node++) {
      boolean stands = cells.isFixed(node) || sums[node] == 0;
      inverse[node] = stands ? 0 : 1 / (sums[node] * largestEntry + hold[node]);
    }
    System.arraycopy(inverse, 0, inverse, sums.length, sums.length);
    System.arraycopy(inverse, 0, inverse, 2 * sums.length, sums.length);
  }

  /**
   * Sets {@code dest} to {@code keep * dest + factor * D * (a - b)}, where D is this diagonal. All
   * arrays have one index, so that the compiler makes vector code.
   */
  void relax(float keep, float factor, float[] a, float[] b, float[] dest) {
    for (int n = 0; n < inverse.length; n++) {
      dest[n] = keep * dest[n] + factor * inverse[n] * (a[n] - b[n]);
    }
  }
}
