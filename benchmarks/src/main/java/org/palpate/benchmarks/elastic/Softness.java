package org.palpate.benchmarks.elastic;

/**
 * The material, the coupling and the lattice of a session.
 *
 * @param youngPascal Young's modulus, Pa
 * @param newtonPerMm stiffness of the coupling
 * @param cellMm edge of a cell
 * @param radiusMm radius of the contact
 * @param residual the force that an update may leave unbalanced, over its load
 * @param smooth whether the solver is {@code smooth}; else {@code guarded}
 */
record Softness(
    double youngPascal,
    double newtonPerMm,
    double cellMm,
    double radiusMm,
    double residual,
    boolean smooth) {
  /** Soft tissue in cells of 8 mm, with the solver {@code guarded}. */
  static final Softness USUAL = new Softness(20e3, 0.5, 8, 16, 1e-3, false);

  Softness withYoung(double pascal) {
    return new Softness(pascal, newtonPerMm, cellMm, radiusMm, residual, smooth);
  }

  Softness withStiffness(double k) {
    return new Softness(youngPascal, k, cellMm, radiusMm, residual, smooth);
  }

  /** Returns a copy on another lattice with a contact of another radius. */
  Softness withCells(double edgeMm, double contactMm) {
    return new Softness(youngPascal, newtonPerMm, edgeMm, contactMm, residual, smooth);
  }

  Softness withResidual(double goal) {
    return new Softness(youngPascal, newtonPerMm, cellMm, radiusMm, goal, smooth);
  }

  Softness withSmooth() {
    return new Softness(youngPascal, newtonPerMm, cellMm, radiusMm, residual, true);
  }

  /** Returns the name of the solver. */
  String solver() {
    return smooth ? "smooth" : "guarded";
  }
}
