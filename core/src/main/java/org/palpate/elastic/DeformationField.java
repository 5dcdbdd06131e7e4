package org.palpate.elastic;

import org.palpate.elastic.lattice.LatticeLayout;
import org.palpate.geometry.Vec3;

/**
 * A deformation with its answers to a change of the force: each node is displaced by u plus the sum
 * over the axes j of a_j r_j, where a is the change of the force since the field was solved. {@link
 * ForceRoom} holds the changes for which no tetrahedron is folded.
 *
 * <p>While a contact slides, the field is blended with the one before. Both belong to a place on
 * the slide. The part of the newer one grows from 0 at the earlier place to 1 at the later one.
 *
 * <p>One thread writes it and hands it over by {@link FieldExchange}.
 */
final class DeformationField {
  /** The floats of a node: u, then r_x, r_y and r_z, three each. */
  static final int STRIDE = 12;

  /** Displacements in cells, and answers in cells per N. */
  final float[] values;

  /** The values of the field before, for the same force as {@link #values}. */
  final float[] earlier;

  /** The place of the contact for which the field was solved, material coordinates. */
  final Vec3 place = new Vec3();

  /** The place of the contact of the field before. */
  final Vec3 earlierPlace = new Vec3();

  /**
   * The number of equal intervals of the slide between which the proof looks at the blended field;
   * 0 if the field is not blended.
   */
  int slideIntervals;

  /** The force on the material for which u was solved, N. */
  final double[] baseNewton = new double[3];

  /** The number of the update that computed it, from 0. */
  long update;

  /** The proved changes of the force; at first only none. */
  final ForceRoom room = new ForceRoom();

  /** Creates a field without displacement and answers. */
  DeformationField(LatticeLayout layout) {
    values = new float[STRIDE * layout.nodeCount()];
    earlier = new float[values.length];
  }

  /** Copies another field of the same lattice. */
  void set(DeformationField other) {
    System.arraycopy(other.values, 0, values, 0, values.length);
    place.set(other.place);
    earlierPlace.set(other.earlierPlace);
    slideIntervals = other.slideIntervals;
    if (slideIntervals > 0) {
      System.arraycopy(other.earlier, 0, earlier, 0, earlier.length);
    }
    System.arraycopy(other.baseNewton, 0, baseNewton, 0, baseNewton.length);
    room.set(other.room);
  }

  /**
   * Takes the values and the place of the field before. Its displacement changes by its answers to
   * the force of this one; so call it after {@link #baseNewton} is set.
   */
  void takeEarlier(DeformationField before) {
    earlierPlace.set(before.place);
    double x = baseNewton[0] - before.baseNewton[0];
    double y = baseNewton[1] - before.baseNewton[1];
    double z = baseNewton[2] - before.baseNewton[2];
    System.arraycopy(before.values, 0, earlier, 0, earlier.length);
    for (int at = 0; at < earlier.length; at += STRIDE) {
      for (int axis = at; axis < at + 3; axis++) {
        earlier[axis] +=
            (float) (x * earlier[axis + 3] + y * earlier[axis + 6] + z * earlier[axis + 9]);
      }
    }
  }

  /** Returns the part of the newer field at a material point, 0 to 1. */
  double part(Vec3 material, LatticeLayout layout) {
    if (slideIntervals == 0) {
      return 1;
    }
    double along = 0;
    double squared = 0;
    for (int axis = 0; axis < 3; axis++) {
      double mmPerVoxel = layout.edgeMm(axis) / layout.voxelsPerCell(axis);
      double slide = mmPerVoxel * (place.get(axis) - earlierPlace.get(axis));
      along += slide * mmPerVoxel * (material.get(axis) - earlierPlace.get(axis));
      squared += slide * slide;
    }
    return Math.max(0, Math.min(1, along / squared));
  }

  /**
   * Returns the displacement of a node along an axis for a change of the force, cells.
   *
   * @param part the part of the newer field, 0 to 1
   */
  double displacement(int node, int axis, double[] changeNewton, double part) {
    int at = STRIDE * node + axis;
    double newer = displacement(values, at, changeNewton);
    return part == 1 ? newer : part * newer + (1 - part) * displacement(earlier, at, changeNewton);
  }

  private static double displacement(float[] of, int at, double[] changeNewton) {
    return of[at]
        + changeNewton[0] * of[at + 3]
        + changeNewton[1] * of[at + 6]
        + changeNewton[2] * of[at + 9];
  }
}
