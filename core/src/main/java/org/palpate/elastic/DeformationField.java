package org.palpate.elastic;

import org.palpate.elastic.lattice.LatticeLayout;

/**
 * A deformation with its answers to a change of the force: each node is displaced by u plus the sum
 * over the axes j of a_j r_j, where a is the change of the force since the field was solved. {@link
 * ForceRoom} holds the changes for which no tetrahedron is folded.
 *
 * <p>One thread writes it and hands it over by {@link FieldExchange}.
 */
final class DeformationField {
  /** The floats of a node: u, then r_x, r_y and r_z, three each. */
  static final int STRIDE = 12;

  /** Displacements in cells, and answers in cells per N. */
  final float[] values;

  /** The force on the material for which u was solved, N. */
  final double[] baseNewton = new double[3];

  /** The number of the update that computed it, from 0. */
  long update;

  /** The proved changes of the force; at first only none. */
  final ForceRoom room = new ForceRoom();

  /** Creates a field without displacement and answers. */
  DeformationField(LatticeLayout layout) {
    values = new float[STRIDE * layout.nodeCount()];
  }

  /** Copies another field of the same lattice. */
  void set(DeformationField other) {
    System.arraycopy(other.values, 0, values, 0, values.length);
    System.arraycopy(other.baseNewton, 0, baseNewton, 0, baseNewton.length);
    room.set(other.room);
  }

  /** Returns the displacement of a node along an axis for a change of the force, cells. */
  double displacement(int node, int axis, double[] changeNewton) {
    int at = STRIDE * node + axis;
    return values[at]
        + changeNewton[0] * values[at + 3]
        + changeNewton[1] * values[at + 6]
        + changeNewton[2] * values[at + 9];
  }
}
