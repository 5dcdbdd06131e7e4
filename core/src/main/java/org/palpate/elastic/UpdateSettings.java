package org.palpate.elastic;

import org.palpate.elastic.lattice.LatticeLayout;

/**
 * Settings of the updates of an elastic body.
 *
 * @param contactRadiusMm radius of the patch over which the force is spread, mm
 * @param residual the largest unbalanced force that a displacement may leave, as a fraction of its
 *     load
 */
record UpdateSettings(double contactRadiusMm, double residual) {
  /**
   * The usual radius over the longest edge of a cell. With a smaller one, the hand would feel the
   * cells.
   */
  private static final double RADIUS_EDGES = 2;

  private static final double USUAL_RESIDUAL = 1e-3;

  /** Returns the usual settings on a lattice. */
  static UpdateSettings usual(LatticeLayout layout) {
    return new UpdateSettings(RADIUS_EDGES * layout.longestEdgeMm(), USUAL_RESIDUAL);
  }
}
