package org.palpate.elastic.lattice;

/** Approximates the inverse of a stiffness by a symmetric positive operator. One thread. */
interface Preconditioner {
  /** Writes the approximate solution for a residual into {@code dest}. */
  void solve(float[] residual, float[] dest);
}
