package org.palpate.elastic;

import java.util.Arrays;
import org.palpate.elastic.lattice.LatticeLayout;
import org.palpate.elastic.lattice.Vectors;
import org.palpate.elastic.lattice.WindowLattice;
import org.palpate.geometry.Vec3;

/**
 * The solution in a window around the contact. Its sides are displaced as in the whole lattice,
 * which is solved before it. It starts from the solution of the whole lattice plus what the last
 * window added to that.
 *
 * <p>One thread, that of the updates; allocates nothing after construction.
 */
final class WindowSolution extends LatticeSolution {
  private final LatticeLayout whole;
  private final WindowLattice window;
  private final WindowNodes nodes;

  /** The solutions of the whole lattice, at the nodes of the window. */
  private final float[][] base = new float[DISPLACEMENT + 1][];

  /** The solutions of the window minus {@link #base}. */
  private final float[][] added = new float[DISPLACEMENT + 1][];

  private final double[] at = new double[3];
  private final int[] firstCell = new int[3];

  WindowSolution(LatticeLayout whole, WindowLattice window, WindowNodes nodes, double radiusMm) {
    super(window.matter(), window.newSolver(), radiusMm);
    this.whole = whole;
    this.window = window;
    this.nodes = nodes;
    for (int n = 0; n < base.length; n++) {
      base[n] = new float[displacement().length];
      added[n] = new float[displacement().length];
    }
  }

  /** Moves the window to the place of a load. */
  void place(Vec3 material) {
    for (int axis = 0; axis < 3; axis++) {
      at[axis] = (material.get(axis) - whole.originVoxel(axis)) / whole.voxelsPerCell(axis);
    }
    if (window.moveTo(at)) {
      for (int n = 0; n < added.length; n++) {
        window.shift(added[n]);
        window.shift(change(n));
      }
    }
    for (int axis = 0; axis < 3; axis++) {
      firstCell[axis] = window.firstCell(axis);
    }
    window.matter().holdFreeParts();
    patch().place(material);
  }

  /** Forgets what the window added: the next solution starts from that of the whole lattice. */
  void restart() {
    for (float[] each : added) {
      Arrays.fill(each, 0);
    }
  }

  /**
   * Solves for the displacement and the answers.
   *
   * @param of the solution on the whole lattice
   * @param forceNewton the force along each axis
   * @param changeNewton the change of the force since the last solution
   * @param goal the residual of the displacement at which to stop, over its load
   * @return the residual of the displacement, over its load
   */
  double solveInside(LatticeSolution of, double[] forceNewton, double[] changeNewton, double goal) {
    predict(forceNewton, changeNewton);
    for (int n = 0; n < base.length; n++) {
      nodes.interpolate(of.solution(n), nodes.firstNode(firstCell), base[n]);
      join(n, added[n]);
    }
    unfold(base[DISPLACEMENT]);
    double left = solve(forceNewton, goal);
    unfold(base[DISPLACEMENT]);
    for (int n = 0; n < base.length; n++) {
      for (int i = 0; i < base[n].length; i++) {
        added[n][i] = solution(n)[i] - base[n][i];
      }
    }
    return left;
  }

  /** Adds to what the window adds to the displacement: its answers to the change of the force. */
  private void predict(double[] forceNewton, double[] changeNewton) {
    boolean isLoaded = forceNewton[0] != 0 || forceNewton[1] != 0 || forceNewton[2] != 0;
    for (int axis = 0; axis < 3 && isLoaded; axis++) {
      Vectors.add((float) changeNewton[axis], added[axis], added[DISPLACEMENT]);
    }
    if (!isLoaded) {
      Arrays.fill(added[DISPLACEMENT], 0);
    }
  }

  /**
   * Sets a solution to that of the whole lattice and what the window adds, which is nothing on the
   * sides. What stands still is not displaced.
   */
  private void join(int n, float[] addition) {
    float[] dest = solution(n);
    int count = nodes.layout().nodeCount();
    for (int node = 0; node < count; node++) {
      boolean stands = window.matter().cells().isFixed(node);
      boolean onRim = nodes.isOnRim(node);
      for (int i = node; i < dest.length; i += count) {
        dest[i] = stands ? (onRim ? base[n][i] : 0) : base[n][i] + addition[i];
      }
    }
  }

  @Override
  void startAnew(int axis, float[] dest) {
    Arrays.fill(added[axis], 0);
    join(axis, added[axis]);
  }

  @Override
  void addHold(int n, float[] dest) {
    window.addHold(base[n], dest);
  }

  /** Writes the window of a field whose values on the whole lattice are written and rounded. */
  void write(DeformationField field) {
    DeformationField.Window to = field.window;
    System.arraycopy(firstCell, 0, to.firstCell, 0, 3);
    write(to.values.values);
    to.takeSides(field.whole.values);
  }
}
