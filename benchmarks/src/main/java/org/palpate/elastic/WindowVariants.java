package org.palpate.elastic;

import java.util.function.Function;
import org.palpate.elastic.lattice.ConjugateGradients;
import org.palpate.elastic.lattice.ControlLattice;
import org.palpate.elastic.lattice.LatticeLayout;
import org.palpate.elastic.lattice.Vectors;
import org.palpate.elastic.lattice.WindowLattice;

/** Opens the window of a lattice to studies. One thread. */
public final class WindowVariants {
  private static final double RESIDUAL = 1e-5;
  private static final int MOST_STEPS = 400;

  private WindowVariants() {}

  /**
   * Solves the window of a lattice at rest for a load.
   *
   * @param displacement that of the whole lattice under the load, mm
   * @param at where to place the window, cells of the lattice
   * @param load returns the load on the nodes of a layout, N
   * @return the work of the load, twice; N mm
   */
  public static double compliance(
      ControlLattice lattice,
      float[] displacement,
      double[] at,
      Function<LatticeLayout, float[]> load) {
    WindowLattice window = lattice.window().orElseThrow();
    WindowNodes nodes = new WindowNodes(lattice.layout(), window);
    window.moveTo(at);
    int[] firstCell = {window.firstCell(0), window.firstCell(1), window.firstCell(2)};
    float[] force = load.apply(window.layout());
    float[] solution = new float[force.length];
    ConjugateGradients solver = window.newSolver();
    solver.rotate(solution);
    nodes.interpolate(displacement, nodes.firstNode(firstCell), solution);
    float[] residual = new float[force.length];
    window.matter().stiffness().multiply(solution, residual);
    int count = window.layout().nodeCount();
    for (int n = 0; n < residual.length; n++) {
      boolean isFixed = window.matter().cells().isFixed(n % count);
      residual[n] = isFixed ? 0 : force[n] - residual[n];
    }
    double goal = RESIDUAL * Vectors.norm(force);
    solver.solve(residual, solution, goal, MOST_STEPS);
    return Vectors.dot(force, solution);
  }
}
