package org.palpate.elastic.lattice;

import java.util.Arrays;

/**
 * Approximates the inverse of a stiffness by a symmetric V-cycle over lattices with cells of
 * doubled edges. Chebyshev polynomials of the inverse diagonal smooth each level, and solve the
 * coarsest one roughly.
 *
 * <p>Reference: Briggs, Henson, McCormick 2000, "A Multigrid Tutorial". One thread; allocates
 * nothing after construction.
 */
final class MultigridPreconditioner {
  private static final int MOST_LEVELS = 4;
  private static final int SMOOTHING_DEGREE = 1;
  private static final int COARSEST_DEGREE = 8;

  /** The part of the spectrum that smoothing leaves to the coarser levels. */
  private static final float SMOOTHED_RANGE = 4;

  /** The range of eigenvalues that the coarsest level treats. */
  private static final float COARSEST_RANGE = 30;

  private static final int POWER_STEPS = 20;

  /** Covers what the power iteration lacks, and what rotations add. */
  private static final double EIGENVALUE_FACTOR = 1.15;

  private final Level[] levels;

  /** The eigenvalue up to which smoothing acts. */
  private float top;

  /** Between each level and the next. */
  private final NodeTransfer[] transfers;

  /** A lattice with its vectors. */
  private static final class Level {
    final StiffnessOperator stiffness;
    final float[] residual;
    final float[] solution;
    final float[] product;
    final float[] direction;
    final float[] displacement;

    /** By axis: the modulus of the upper halves of each cell. */
    final float[][] first = new float[3][];

    Level(StiffnessOperator stiffness) {
      this.stiffness = stiffness;
      int size = 3 * stiffness.cells().layout().nodeCount();
      residual = new float[size];
      solution = new float[size];
      product = new float[size];
      direction = new float[size];
      displacement = new float[size];
      for (int axis = 0; axis < 3; axis++) {
        first[axis] = new float[stiffness.cells().count()];
      }
    }

    /**
     * Finds the second moments from sums over the halves: a cell of parts a and b of the modulus in
     * its halves has a quarter of their own moments, and 3 a b of their distance.
     */
    void takeMoments() {
      float[] sum = stiffness.modulus();
      for (int axis = 0; axis < 3; axis++) {
        float[] moment = stiffness.moment(axis);
        for (int n = 0; n < sum.length; n++) {
          float upper = first[axis][n] / sum[n];
          moment[n] = 0.25f * moment[n] / sum[n] + 3 * upper * (1 - upper);
        }
      }
    }
  }

  /** Creates the levels; {@link #refresh} must come before the first solution. */
  MultigridPreconditioner(StiffnessOperator fine, double poisson) {
    Level[] all = new Level[MOST_LEVELS];
    all[0] = new Level(fine);
    int count = 1;
    ActiveCells cells = fine.cells();
    while (count < MOST_LEVELS && cells.layout().isEven()) {
      cells = cells.coarser();
      if (cells.count() == 0) {
        break;
      }
      all[count++] = new Level(new StiffnessOperator(cells, poisson));
    }
    levels = Arrays.copyOf(all, count);
    top = largestEigenvalue(levels[0]);
    transfers = new NodeTransfer[count - 1];
    for (int n = 0; n < transfers.length; n++) {
      transfers[n] = new NodeTransfer(levels[n].stiffness.cells(), levels[n + 1].stiffness.cells());
    }
  }

  /**
   * Estimates the largest eigenvalue of the inverse diagonal times the stiffness, which is about
   * the same on all levels. The bound of a single cell would be safe but far too large.
   */
  private static float largestEigenvalue(Level fine) {
    for (int n = 0; n < fine.solution.length; n++) {
      fine.solution[n] = (float) StrictMath.sin(1.7 * n);
    }
    InverseDiagonal diagonal = fine.stiffness.diagonal();
    double norm = 0;
    for (int step = 0; step < POWER_STEPS; step++) {
      fine.stiffness.multiply(fine.solution, fine.product);
      diagonal.relax(0, 1, fine.product, fine.residual, fine.solution); // The residual is zero.
      norm = Vectors.norm(fine.solution);
      for (int n = 0; n < fine.solution.length && norm > 0; n++) {
        fine.solution[n] /= (float) norm;
      }
    }
    double estimate = EIGENVALUE_FACTOR * norm;
    float bound = diagonal.largestEigenvalue();
    return estimate > 0 && estimate < bound ? (float) estimate : bound;
  }

  /** Takes over which nodes of the fine lattice are fixed; {@link #refresh} must follow. */
  void fixedNodesDiffer() {
    for (int n = 0; n < transfers.length; n++) {
      levels[n].stiffness.cells().fixAgain(levels[n + 1].stiffness.cells());
      transfers[n].takeFixedNodes();
    }
    top = largestEigenvalue(levels[0]);
  }

  /** Takes moduli and rotations over from the fine lattice, whose displacement this is, mm. */
  void refresh(float[] displacement) {
    float[] from = displacement;
    for (int n = 1; n < levels.length; n++) {
      Level coarse = levels[n];
      transfers[n - 1].inject(from, coarse.displacement);
      coarse.stiffness.rotate(coarse.displacement);
      average(levels[n - 1].stiffness, coarse);
      hold(levels[n - 1].stiffness, coarse.stiffness);
      coarse.stiffness.changed();
      from = coarse.displacement;
    }
  }

  /** Gives each coarse cell the mean modulus and the second moments of the eight cells in it. */
  private static void average(StiffnessOperator fine, Level coarse) {
    ActiveCells cells = coarse.stiffness.cells();
    float[] sum = coarse.stiffness.modulus();
    Arrays.fill(sum, 0);
    LatticeLayout small = fine.cells().layout();
    for (int axis = 0; axis < 3; axis++) {
      Arrays.fill(coarse.first[axis], 0);
      Arrays.fill(coarse.stiffness.moment(axis), 0);
    }
    for (int n = 0; n < fine.cells().count(); n++) {
      int cell = fine.cells().cell(n);
      int x = small.cellIndex(0, cell);
      int y = small.cellIndex(1, cell);
      int z = small.cellIndex(2, cell);
      int listed = cells.indexOf(cells.layout().cell(x / 2, y / 2, z / 2));
      if (listed >= 0) {
        float modulus = fine.modulus()[n] / LatticeLayout.CORNERS;
        sum[listed] += modulus;
        coarse.first[0][listed] += (x & 1) * modulus;
        coarse.first[1][listed] += (y & 1) * modulus;
        coarse.first[2][listed] += (z & 1) * modulus;
        for (int axis = 0; axis < 3; axis++) {
          coarse.stiffness.moment(axis)[listed] += fine.moment(axis)[n] * modulus;
        }
      }
    }
    coarse.takeMoments();
  }

  /** Gives each coarse node the springs of the eight fine nodes that it stands for. */
  private static void hold(StiffnessOperator fine, StiffnessOperator coarse) {
    LatticeLayout layout = coarse.cells().layout();
    for (int node = 0; node < layout.nodeCount(); node++) {
      float spring = fine.hold()[fine.cells().fineNode(layout, node)];
      coarse.hold()[node] = LatticeLayout.CORNERS * spring;
    }
  }

  /** Writes the approximate solution for a residual into {@code dest}. */
  void solve(float[] residual, float[] dest) {
    System.arraycopy(residual, 0, levels[0].residual, 0, residual.length);
    cycle(0);
    System.arraycopy(levels[0].solution, 0, dest, 0, dest.length);
  }

  private void cycle(int n) {
    Level level = levels[n];
    Arrays.fill(level.solution, 0);
    if (n == levels.length - 1) {
      smooth(level, COARSEST_DEGREE, COARSEST_RANGE, true);
      return;
    }
    smooth(level, SMOOTHING_DEGREE, SMOOTHED_RANGE, true);
    level.stiffness.multiply(level.solution, level.product);
    for (int i = 0; i < level.product.length; i++) {
      level.product[i] = level.residual[i] - level.product[i];
    }
    Level coarse = levels[n + 1];
    transfers[n].restrict(level.product, coarse.residual);
    cycle(n + 1);
    transfers[n].prolong(coarse.solution, level.solution);
    smooth(level, SMOOTHING_DEGREE, SMOOTHED_RANGE, false);
  }

  /**
   * Improves the solution by Chebyshev's iteration over the upper part of the spectrum.
   *
   * @param fromZero whether the solution is zero, which saves one product
   */
  private void smooth(Level level, int degree, float range, boolean fromZero) {
    InverseDiagonal diagonal = level.stiffness.diagonal();
    float low = top / range;
    float middle = (top + low) / 2;
    float half = (top - low) / 2;
    float sigma = middle / half;
    float rho = 1 / sigma;
    for (int k = 0; k < degree; k++) {
      float next = 1 / (2 * sigma - rho);
      float keep = k == 0 ? 0 : next * rho;
      float factor = k == 0 ? 1 / middle : 2 * next / half;
      if (k == 0 && fromZero) {
        Arrays.fill(level.product, 0);
      } else {
        level.stiffness.multiply(level.solution, level.product);
      }
      diagonal.relax(keep, factor, level.residual, level.product, level.direction);
      Vectors.add(1, level.direction, level.solution);
      rho = k == 0 ? rho : next;
    }
  }
}
