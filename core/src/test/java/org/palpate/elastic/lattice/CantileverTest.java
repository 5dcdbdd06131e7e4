package org.palpate.elastic.lattice;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Compares the bending of a beam with Timoshenko's formula. */
class CantileverTest {
  private static final double LENGTH_MM = 96;
  private static final double THICK_MM = 16;
  private static final double NEWTON = 1e-3;

  /** The deflection of the tip, mm, for a modulus of 1 N/mm^2; clamped where x is 0. */
  private static double deflection(int through, double poisson) {
    return deflection(through, poisson, 1);
  }

  /** The same for a layer that fills a part of the height of each cell. */
  private static double deflection(int through, double poisson, double part) {
    double edge = THICK_MM / through;
    int[] cells = {6 * through, through, through};
    LatticeLayout layout =
        new LatticeLayout(new int[3], new int[] {1, 1, 1}, cells, new double[] {edge, edge, edge});
    boolean[] fixed = new boolean[layout.nodeCount()];
    for (int node = 0; node < fixed.length; node++) {
      fixed[node] = layout.nodeIndex(0, node) == 0;
    }
    StiffnessOperator stiffness = new StiffnessOperator(new ActiveCells(layout, fixed), poisson);
    java.util.Arrays.fill(stiffness.modulus(), (float) part);
    java.util.Arrays.fill(stiffness.moment(2), (float) (part * part));
    stiffness.changed();
    float[] load = new float[3 * layout.nodeCount()];
    double sum = 0;
    for (int k = 0; k <= through; k++) {
      for (int j = 0; j <= through; j++) {
        double weight = (j % through == 0 ? 0.5 : 1) * (k % through == 0 ? 0.5 : 1);
        sum += weight;
        load[2 * layout.nodeCount() + layout.node(cells[0], j, k)] = (float) weight;
      }
    }
    for (int n = 0; n < load.length; n++) {
      load[n] *= (float) (NEWTON / sum);
    }
    MultigridPreconditioner multigrid = new MultigridPreconditioner(stiffness, poisson);
    float[] u = new float[load.length];
    multigrid.refresh(u);
    new ConjugateGradients(stiffness, multigrid)
        .solve(load.clone(), u, 1e-5 * Vectors.norm(load), 2000);
    return Vectors.dot(load, u) / NEWTON;
  }

  private static double timoshenko(double poisson) {
    return timoshenko(poisson, 1);
  }

  private static double timoshenko(double poisson, double part) {
    double height = part * THICK_MM;
    double inertia = THICK_MM * Math.pow(height, 3) / 12;
    double shear = 1 / (2 * (1 + poisson));
    double factor = 10 * (1 + poisson) / (12 + 11 * poisson);
    return NEWTON * Math.pow(LENGTH_MM, 3) / (3 * inertia)
        + NEWTON * LENGTH_MM / (factor * shear * THICK_MM * height);
  }

  @ParameterizedTest
  @CsvSource({"0.5, 0.3", "0.25, 0.3", "0.125, 0.3", "0.25, 0"})
  void aLayerThinnerThanItsCellsBendsLikeAPlate(double part, double poisson) {
    double ratio = deflection(1, poisson, part) / timoshenko(poisson, part);
    System.out.printf("layer of %.3f of a cell, %.2f: %.4f%n", part, poisson, ratio);
    assertEquals(1, ratio, 0.2);
  }

  @ParameterizedTest
  @CsvSource({"1, 0.3", "2, 0.3", "4, 0.3", "1, 0.0", "2, 0.0"})
  void bendsWithinThreePercentOfTheFormula(int cellsThrough, double poisson) {
    double found = deflection(cellsThrough, poisson);
    System.out.printf(
        "cantilever %d %.2f: %.4f%n", cellsThrough, poisson, found / timoshenko(poisson));
    assertEquals(1, found / timoshenko(poisson), 0.03);
  }
}
