package org.palpate.elastic;

import java.util.Arrays;
import org.palpate.elastic.lattice.ConjugateGradients;
import org.palpate.elastic.lattice.LatticeLayout;
import org.palpate.elastic.lattice.LatticeMatter;
import org.palpate.elastic.lattice.StiffnessOperator;
import org.palpate.elastic.lattice.Vectors;

/**
 * The displacement of a lattice under a force, and its answers to a unit force along each axis at
 * the same place. Each solution starts from the last one.
 *
 * <p>One thread, that of the updates; allocates nothing after construction.
 */
class LatticeSolution {
  /** The number of the displacement among the solutions; those before it are the answers. */
  static final int DISPLACEMENT = 3;

  /** The residual at which an answer is good enough, over its unit load. */
  private static final double ANSWER_RESIDUAL = 2e-2;

  /** A smaller load counts as this large, N. */
  private static final double LEAST_LOAD_NEWTON = 1e-4;

  private static final int DISPLACEMENT_STEPS = 60;
  private static final int ANSWER_STEPS = 20;

  private final LatticeLayout layout;
  private final StiffnessOperator stiffness;
  private final ConjugateGradients solver;
  private final ContactPatch patch;
  private final CrushStiffening stiffening;
  private final FoldGuard guard;
  private final float[][] solutions = new float[DISPLACEMENT + 1][];

  /** The changes of the solutions by the last update. */
  private final float[][] changes = new float[DISPLACEMENT + 1][];

  private final float[] before;
  private final float[] load;
  private final float[] residual;

  /**
   * Creates a solution at rest.
   *
   * @param solver solves for the stiffness of the matter
   * @param radiusMm the radius over which the force is spread
   */
  LatticeSolution(LatticeMatter matter, ConjugateGradients solver, double radiusMm) {
    layout = matter.cells().layout();
    stiffness = matter.stiffness();
    this.solver = solver;
    patch = new ContactPatch(matter, radiusMm);
    stiffening = new CrushStiffening(matter);
    guard = new FoldGuard(matter.cells());
    int size = 3 * layout.nodeCount();
    load = new float[size];
    residual = new float[size];
    before = new float[size];
    for (int n = 0; n < solutions.length; n++) {
      solutions[n] = new float[size];
      changes[n] = new float[size];
    }
  }

  /** Returns where the force acts. */
  final ContactPatch patch() {
    return patch;
  }

  /** Returns the displacement, three numbers for each node, mm. */
  final float[] displacement() {
    return solutions[DISPLACEMENT];
  }

  /**
   * Returns a solution: the answer to a force along an axis, mm/N, or the displacement, mm.
   *
   * @param n the axis, or {@link #DISPLACEMENT}
   */
  final float[] solution(int n) {
    return solutions[n];
  }

  /** Returns the change of a solution by the last update. */
  final float[] change(int n) {
    return changes[n];
  }

  /** Forgets the answers. */
  final void clearAnswers() {
    for (int axis = 0; axis < DISPLACEMENT; axis++) {
      Arrays.fill(solutions[axis], 0);
    }
  }

  /**
   * Takes folds out of the displacement.
   *
   * @param proved a displacement that is proved
   * @return whether there were any
   */
  final boolean unfold(float[] proved) {
    return guard.unfold(displacement(), proved);
  }

  /**
   * Solves for the displacement and the answers. Before that it stiffens the cells that the last
   * {@link #unfold} found crushed, and turns all cells with the displacement.
   *
   * @param forceNewton the force along each axis
   * @param goal the residual of the displacement at which to stop, over its load
   * @return the residual of the displacement, over its load
   */
  final double solve(double[] forceNewton, double goal) {
    stiffening.update(guard.determinants());
    solver.rotate(displacement());
    double left = solveDisplacement(forceNewton, goal);
    for (int axis = 0; axis < DISPLACEMENT; axis++) {
      solveAnswer(axis);
    }
    return left;
  }

  private double solveDisplacement(double[] forceNewton, double goal) {
    Arrays.fill(load, 0);
    for (int axis = 0; axis < 3; axis++) {
      patch.addForce(axis, forceNewton[axis], load);
    }
    double size = Math.max(LEAST_LOAD_NEWTON, Vectors.norm(load));
    addHold(DISPLACEMENT, load);
    stiffness.force(displacement(), residual);
    subtractFromLoad();
    solve(DISPLACEMENT, goal * size, DISPLACEMENT_STEPS);
    return solver.residualNewton() / size;
  }

  private void solveAnswer(int axis) {
    Arrays.fill(load, 0);
    patch.addForce(axis, 1, load);
    double size = Vectors.norm(load);
    addHold(axis, load);
    stiffness.multiply(solutions[axis], residual);
    subtractFromLoad();
    if (Vectors.norm(residual) > size) { // The contact has gone elsewhere.
      startAnew(axis, solutions[axis]);
      stiffness.multiply(solutions[axis], residual);
      subtractFromLoad();
    }
    double goal = ANSWER_RESIDUAL * Math.max(LEAST_LOAD_NEWTON, size);
    solve(axis, goal, ANSWER_STEPS);
  }

  /** Writes an answer from which to start if the last one is of no use. */
  void startAnew(int axis, float[] dest) {
    Arrays.fill(dest, 0);
  }

  /** Adds the forces of springs that hold nodes elsewhere than at rest. */
  void addHold(int n, float[] dest) {}

  /** Solves until the residual is small. Tries the last change first, as a slide often goes on. */
  private void solve(int n, double goalNewton, int mostSteps) {
    float[] solution = solutions[n];
    float[] change = changes[n];
    System.arraycopy(solution, 0, before, 0, before.length);
    solver.descend(change, residual, solution);
    solver.solve(residual, solution, goalNewton, mostSteps);
    for (int i = 0; i < change.length; i++) {
      change[i] = solution[i] - before[i];
    }
  }

  private void subtractFromLoad() {
    for (int n = 0; n < residual.length; n++) {
      residual[n] = load[n] - residual[n];
    }
  }

  /** Writes the solutions as the values of a field, in cells. */
  final void write(float[] values) {
    int nodes = layout.nodeCount();
    for (int axis = 0; axis < 3; axis++) {
      float cellsPerMm = (float) (1 / layout.edgeMm(axis));
      for (int node = 0; node < nodes; node++) {
        int from = axis * nodes + node;
        int to = DeformationField.STRIDE * node + axis;
        values[to] = solutions[DISPLACEMENT][from] * cellsPerMm;
        values[to + 3] = solutions[0][from] * cellsPerMm;
        values[to + 6] = solutions[1][from] * cellsPerMm;
        values[to + 9] = solutions[2][from] * cellsPerMm;
      }
    }
  }

  /**
   * Makes nearly flat cells stiffer, cells of air included, so that the material resists when a
   * cell is crushed or a gap closes. The modulus in use approaches its goal over several updates.
   *
   * <p>One thread; allocates nothing.
   */
  private static final class CrushStiffening {
    /** The determinant below which a cell becomes stiffer. */
    private static final double CRUSHED = 0.4;

    private static final double LEAST_DETERMINANT = 0.02;
    private static final double PART_OF_STIFFEST = 0.2;
    private static final double MOST_FACTOR = 10;

    /** Smaller relative changes are left out. */
    private static final double LEAST_CHANGE = 0.01;

    private final LatticeMatter matter;

    CrushStiffening(LatticeMatter matter) {
      this.matter = matter;
    }

    /**
     * Updates the moduli in use.
     *
     * @param determinants the least determinant of each listed cell, 1 at rest
     */
    void update(float[] determinants) {
      float[] modulus = matter.stiffness().modulus();
      float stiffest = 0;
      for (int cell = 0; cell < modulus.length; cell++) {
        stiffest = Math.max(stiffest, matter.restModulus(cell));
      }
      boolean changed = false;
      for (int cell = 0; cell < modulus.length; cell++) {
        float next = next(modulus[cell], matter.restModulus(cell), stiffest, determinants[cell]);
        if (Math.abs(next - modulus[cell]) > LEAST_CHANGE * modulus[cell]) {
          modulus[cell] = next;
          changed = true;
        }
      }
      if (changed) {
        matter.stiffness().changed();
      }
    }

    private static float next(float now, float rest, float stiffest, float determinant) {
      double lack = Math.max(0, CRUSHED / Math.max(LEAST_DETERMINANT, determinant) - 1);
      double goal = rest + stiffest * PART_OF_STIFFEST * lack * lack;
      return (float) Math.sqrt(now * Math.min(goal, MOST_FACTOR * stiffest));
    }
  }
}
