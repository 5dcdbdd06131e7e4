package org.palpate.elastic.lattice;

/**
 * Solves a stiffness for a displacement by preconditioned conjugate gradients, from any start. One
 * thread; allocates nothing after construction.
 *
 * <p>Reference: Hestenes and Stiefel 1952.
 */
public final class ConjugateGradients {
  private final StiffnessOperator stiffness;
  private final MultigridPreconditioner preconditioner;
  private final float[] z;
  private final float[] p;
  private final float[] q;
  private double residualNorm;

  ConjugateGradients(StiffnessOperator stiffness, MultigridPreconditioner preconditioner) {
    this.stiffness = stiffness;
    this.preconditioner = preconditioner;
    int size = 3 * stiffness.cells().layout().nodeCount();
    z = new float[size];
    p = new float[size];
    q = new float[size];
  }

  /**
   * Turns the cells with a displacement, so that the stiffness is that of the present shape.
   *
   * @param displacement three numbers for each node, mm
   */
  public void rotate(float[] displacement) {
    stiffness.rotate(displacement);
    preconditioner.refresh(displacement);
  }

  /**
   * Adds to a displacement the solution for its residual.
   *
   * @param residual the force that is not balanced; holds what remains at the end, N
   * @param displacement changed in place, mm
   * @param goalNewton the length of the residual at which to stop, N
   * @param mostSteps the most iterations
   * @return the number of iterations
   */
  public int solve(float[] residual, float[] displacement, double goalNewton, int mostSteps) {
    residualNorm = Vectors.norm(residual);
    double last = 0;
    int step = 0;
    while (residualNorm > goalNewton && step < mostSteps) {
      preconditioner.solve(residual, z);
      double fresh = Vectors.dot(residual, z);
      float keep = step == 0 ? 0 : (float) (fresh / last);
      last = fresh;
      for (int n = 0; n < p.length; n++) {
        p[n] = z[n] + keep * p[n];
      }
      stiffness.multiply(p, q);
      double curvature = Vectors.dot(p, q);
      if (!(curvature > 0)) {
        break; // The residual is too small for floats to improve.
      }
      float length = (float) (fresh / curvature);
      Vectors.add(length, p, displacement);
      Vectors.add(-length, q, residual);
      residualNorm = Vectors.norm(residual);
      step++;
    }
    return step;
  }

  /**
   * Adds to a displacement the part of a direction that leaves the least energy.
   *
   * @param direction the direction, three numbers for each node, mm
   * @param residual the force that is not balanced; holds what remains, N
   * @param displacement changed in place, mm
   */
  public void descend(float[] direction, float[] residual, float[] displacement) {
    stiffness.multiply(direction, q);
    double curvature = Vectors.dot(direction, q);
    if (curvature > 0) {
      float part = (float) (Vectors.dot(direction, residual) / curvature);
      Vectors.add(part, direction, displacement);
      Vectors.add(-part, q, residual);
    }
  }

  /** {@return the length of the residual that the last solution left, N} */
  public double residualNewton() {
    return residualNorm;
  }
}
