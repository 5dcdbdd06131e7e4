package org.palpate.elastic.lattice;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.palpate.testing.Seeds;

class StiffnessOperatorTest {
  private static final double POISSON = 0.35;
  private final Random random = new Random(Seeds.seed());

  private static LatticeLayout layout(int x, int y, int z) {
    return new LatticeLayout(
        new int[3], new int[] {4, 4, 2}, new int[] {x, y, z}, new double[] {4, 4.4, 5});
  }

  private StiffnessOperator operator(LatticeLayout layout, boolean fixesFloor) {
    boolean[] fixed = new boolean[layout.nodeCount()];
    for (int node = 0; node < fixed.length; node++) {
      fixed[node] = fixesFloor && layout.nodeIndex(2, node) == 0;
    }
    StiffnessOperator made = new StiffnessOperator(new ActiveCells(layout, fixed), POISSON);
    for (int n = 0; n < made.modulus().length; n++) {
      made.modulus()[n] = (float) Math.pow(10, -3 + 3 * random.nextDouble());
      for (int axis = 0; axis < 3; axis++) {
        made.moment(axis)[n] = random.nextBoolean() ? 1 : 0.02f + 0.98f * random.nextFloat();
      }
    }
    made.changed();
    return made;
  }

  private float[] randomVector(LatticeLayout layout, double size) {
    float[] vector = new float[3 * layout.nodeCount()];
    for (int n = 0; n < vector.length; n++) {
      vector[n] = (float) (size * (2 * random.nextDouble() - 1));
    }
    return vector;
  }

  /** Returns the displacement by which the lattice turns and moves as a whole. */
  private static float[] rigidMotion(LatticeLayout layout, double angle) {
    double c = Math.cos(angle);
    double s = Math.sin(angle);
    int nodes = layout.nodeCount();
    float[] u = new float[3 * nodes];
    for (int node = 0; node < nodes; node++) {
      double x = layout.nodeIndex(0, node) * layout.edgeMm(0);
      double y = layout.nodeIndex(1, node) * layout.edgeMm(1);
      double z = layout.nodeIndex(2, node) * layout.edgeMm(2);
      double y1 = c * y - s * z;
      double z1 = s * y + c * z;
      u[node] = (float) (c * x - s * y1 - x + 3);
      u[nodes + node] = (float) (s * x + c * y1 - y - 2);
      u[2 * nodes + node] = (float) (z1 - z + 1);
    }
    return u;
  }

  @Test
  void multipliesLikeTheAssembledMatrix() {
    for (int n = 0; n < 5; n++) {
      LatticeLayout layout = layout(3, 2, 4);
      StiffnessOperator operator = operator(layout, n % 2 == 0);
      float[] shape = randomVector(layout, 0.8);
      operator.rotate(shape);
      DenseStiffness dense = new DenseStiffness(operator, POISSON, shape);
      float[] x = randomVector(layout, 1);
      float[] y = new float[x.length];
      operator.multiply(x, y);
      double[] expected = dense.multiply(x);
      double largest = 0;
      for (double value : expected) {
        largest = Math.max(largest, Math.abs(value));
      }
      for (int i = 0; i < y.length; i++) {
        assertEquals(expected[i], y[i], 2e-6 * largest, "entry " + i);
      }
    }
  }

  @Test
  void rigidMotionsGiveNoForce() {
    LatticeLayout layout = layout(4, 3, 3);
    StiffnessOperator operator = operator(layout, false);
    for (double angle : new double[] {0, 0.3, 1.2, 2.5, 3.1}) {
      float[] u = rigidMotion(layout, angle);
      float[] force = new float[u.length];
      operator.rotate(u);
      operator.force(u, force);
      // A strain of 1e-5 of the stiffest cell would give this force on a face of it.
      double bound = 1e-5 * 1 * 4.4 * 5;
      for (float f : force) {
        assertTrue(Math.abs(f) < bound, angle + ": " + f);
      }
    }
  }

  @Test
  void theEnergyIsSymmetricAndNotNegative() {
    LatticeLayout layout = layout(3, 3, 3);
    StiffnessOperator operator = operator(layout, true);
    operator.rotate(randomVector(layout, 0.8));
    for (int n = 0; n < 20; n++) {
      float[] x = randomVector(layout, 1);
      float[] y = randomVector(layout, 1);
      for (int node = 0; node < layout.nodeCount(); node++) {
        if (operator.cells().isFixed(node)) {
          for (int axis = 0; axis < 3; axis++) {
            x[axis * layout.nodeCount() + node] = y[axis * layout.nodeCount() + node] = 0;
          }
        }
      }
      float[] kx = new float[x.length];
      float[] ky = new float[x.length];
      operator.multiply(x, kx);
      operator.multiply(y, ky);
      double own = Vectors.dot(x, kx);
      assertTrue(own > 0, "energy " + own);
      assertEquals(Vectors.dot(y, kx), Vectors.dot(x, ky), 1e-5 * own);
    }
  }

  /** The patch test: a strain that is the same everywhere gives no force on inner nodes. */
  @Test
  void aConstantStrainBalancesInside() {
    LatticeLayout layout = layout(4, 4, 4);
    StiffnessOperator operator = operator(layout, false);
    java.util.Arrays.fill(operator.modulus(), 1);
    operator.changed();
    double[] strain = new double[9];
    for (int n = 0; n < 9; n++) {
      strain[n] = 0.02 * (2 * random.nextDouble() - 1);
    }
    int nodes = layout.nodeCount();
    float[] u = new float[3 * nodes];
    for (int node = 0; node < nodes; node++) {
      for (int row = 0; row < 3; row++) {
        double sum = 0;
        for (int axis = 0; axis < 3; axis++) {
          sum += strain[3 * row + axis] * layout.nodeIndex(axis, node) * layout.edgeMm(axis);
        }
        u[row * nodes + node] = (float) sum;
      }
    }
    float[] force = new float[u.length];
    operator.force(u, force);
    double outer = 0;
    double inner = 0;
    for (int node = 0; node < nodes; node++) {
      boolean inside = true;
      for (int axis = 0; axis < 3; axis++) {
        int index = layout.nodeIndex(axis, node);
        inside &= index > 0 && index < layout.cells(axis);
      }
      for (int row = 0; row < 3; row++) {
        double size = Math.abs(force[row * nodes + node]);
        outer = inside ? outer : Math.max(outer, size);
        inner = inside ? Math.max(inner, size) : inner;
      }
    }
    assertTrue(outer > 0.01 && inner < 1e-5 * outer, "inside " + inner + " rim " + outer);
  }

  @Test
  void conjugateGradientsSolveLikeElimination() {
    for (int n = 0; n < 4; n++) {
      LatticeLayout layout = layout(4, 4, 4);
      StiffnessOperator operator = operator(layout, true);
      float[] shape = randomVector(layout, 0.5);
      ConjugateGradients solver =
          new ConjugateGradients(operator, new MultigridPreconditioner(operator, POISSON));
      solver.rotate(shape);
      float[] load = randomVector(layout, 1);
      for (int i = 0; i < load.length; i++) {
        load[i] = operator.cells().isFixed(i % layout.nodeCount()) ? 0 : load[i];
      }
      double[] expected = new DenseStiffness(operator, POISSON, shape).solve(load);
      float[] found = new float[load.length];
      int steps = solver.solve(load.clone(), found, 1e-5 * Vectors.norm(load), 200);
      double size = 0;
      double error = 0;
      for (int i = 0; i < found.length; i++) {
        size += expected[i] * expected[i];
        error += (found[i] - expected[i]) * (found[i] - expected[i]);
      }
      assertTrue(steps < 120, "steps " + steps);
      assertTrue(Math.sqrt(error / size) < 2e-3, "relative error " + Math.sqrt(error / size));
    }
  }

  @Test
  void aStepAlongADirectionLeavesNoForceAlongIt() {
    LatticeLayout layout = layout(4, 4, 4);
    StiffnessOperator operator = operator(layout, true);
    ConjugateGradients solver =
        new ConjugateGradients(operator, new MultigridPreconditioner(operator, POISSON));
    float[] direction = randomVector(layout, 1);
    float[] residual = randomVector(layout, 1);
    float[] before = residual.clone();
    float[] found = new float[residual.length];
    solver.descend(direction, residual, found);
    double along = Vectors.dot(direction, before);
    assertEquals(0, Vectors.dot(direction, residual), 1e-4 * Math.abs(along));
    float[] force = new float[residual.length];
    operator.multiply(found, force);
    Vectors.add(1, residual, force);
    Vectors.add(-1, before, force);
    assertEquals(0, Vectors.norm(force), 1e-4 * Vectors.norm(before));
  }

  @Test
  void aStepAlongNoDirectionChangesNothing() {
    LatticeLayout layout = layout(4, 4, 4);
    StiffnessOperator operator = operator(layout, true);
    ConjugateGradients solver =
        new ConjugateGradients(operator, new MultigridPreconditioner(operator, POISSON));
    float[] residual = randomVector(layout, 1);
    float[] before = residual.clone();
    float[] found = new float[residual.length];
    solver.descend(new float[residual.length], residual, found);
    assertArrayEquals(before, residual);
    assertArrayEquals(new float[residual.length], found);
  }

  @Test
  void theMultigridCycleIsSymmetric() {
    LatticeLayout layout = layout(4, 4, 4);
    StiffnessOperator operator = operator(layout, true);
    MultigridPreconditioner multigrid = new MultigridPreconditioner(operator, POISSON);
    multigrid.refresh(new float[3 * layout.nodeCount()]);
    float[] x = randomVector(layout, 1);
    float[] y = randomVector(layout, 1);
    for (int i = 0; i < x.length; i++) {
      if (operator.cells().isFixed(i % layout.nodeCount())) {
        x[i] = y[i] = 0;
      }
    }
    float[] mx = new float[x.length];
    float[] my = new float[x.length];
    multigrid.solve(x, mx);
    multigrid.solve(y, my);
    double own = Vectors.dot(x, mx);
    assertTrue(own > 0);
    assertEquals(Vectors.dot(y, mx), Vectors.dot(x, my), 1e-4 * own);
  }
}
