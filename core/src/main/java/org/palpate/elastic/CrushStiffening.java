package org.palpate.elastic;

import org.palpate.elastic.lattice.ControlLattice;

/**
 * Makes nearly flat cells stiffer, cells of air included, so that the material resists when a cell
 * is crushed or a gap closes. The modulus in use approaches its goal over several updates.
 *
 * <p>One thread; allocates nothing.
 */
final class CrushStiffening {
  /** The determinant below which a cell becomes stiffer. */
  private static final double CRUSHED = 0.4;

  private static final double LEAST_DETERMINANT = 0.02;
  private static final double PART_OF_STIFFEST = 0.2;
  private static final double MOST_FACTOR = 10;

  /** Smaller relative changes are left out. */
  private static final double LEAST_CHANGE = 0.01;

  private final ControlLattice lattice;

  CrushStiffening(ControlLattice lattice) {
    this.lattice = lattice;
  }

  /**
   * Updates the moduli in use.
   *
   * @param determinants the least determinant of each listed cell, 1 at rest
   */
  void update(float[] determinants) {
    float[] modulus = lattice.stiffness().modulus();
    float stiffest = 0;
    for (int cell = 0; cell < modulus.length; cell++) {
      stiffest = Math.max(stiffest, lattice.restModulus(cell));
    }
    boolean changed = false;
    for (int cell = 0; cell < modulus.length; cell++) {
      float next = next(modulus[cell], lattice.restModulus(cell), stiffest, determinants[cell]);
      if (Math.abs(next - modulus[cell]) > LEAST_CHANGE * modulus[cell]) {
        modulus[cell] = next;
        changed = true;
      }
    }
    if (changed) {
      lattice.stiffness().changed();
    }
  }

  private static float next(float now, float rest, float stiffest, float determinant) {
    double lack = Math.max(0, CRUSHED / Math.max(LEAST_DETERMINANT, determinant) - 1);
    double goal = rest + stiffest * PART_OF_STIFFEST * lack * lack;
    return (float) Math.sqrt(now * Math.min(goal, MOST_FACTOR * stiffest));
  }
}
