package org.palpate.elastic;

import java.util.Arrays;
import org.palpate.elastic.lattice.LatticeLayout;
import org.palpate.geometry.Vec3;

/**
 * The map from material coordinates to present ones, both grid coordinates: affine on the Kuhn
 * tetrahedra of each cell, the identity outside the lattice. The force on the material may change
 * from frame to frame, within the {@link ForceRoom} of the field.
 *
 * <p>One thread; allocates nothing after construction.
 */
final class DeformationMap {
  private static final int MOST_STEPS = 400;

  /** A point this far outside a tetrahedron still counts as inside; in parts of its height. */
  private static final double INSIDE = -1e-12;

  private final LatticeLayout layout;
  private final int[] cells;
  private DeformationField field;
  private final double[] change = new double[3];

  /** The part of the newer field where the field is blended with the one before. */
  private double part = 1;

  /** The tetrahedron in use: its cell and the order of its axes. */
  private final int[] cell = new int[3];

  private final int[] order = {0, 1, 2};

  /** Its corners along the path from corner 0 to corner 7, and its edges by columns; in cells. */
  private final double[] corners = new double[12];

  private final double[] edges = new double[9];

  /**
   * The position along the edges: 1 &gt;= first &gt;= second &gt;= third &gt;= 0 if it is inside.
   */
  private final double[] along = new double[3];

  private final double[] at = new double[3];
  private final int[] nodes = new int[4];
  private final double[] weights = new double[4];
  private final Vec3 beside = new Vec3();
  private final Vec3 high = new Vec3();
  private final Vec3 low = new Vec3();
  private final double[] gradient = new double[9];

  DeformationMap(LatticeLayout layout, DeformationField field) {
    this.layout = layout;
    cells = new int[] {layout.cells(0), layout.cells(1), layout.cells(2)};
    this.field = field;
  }

  /** Uses another field, with the force for which it was solved. */
  void use(DeformationField next) {
    field = next;
    part = 1;
    Arrays.fill(change, 0);
  }

  /**
   * Blends the field with the one before, in proportion to where a sliding contact is between the
   * contacts for which the two were computed.
   *
   * @param material the contact
   */
  void slideTo(Vec3 material) {
    part = field.part(material, layout);
  }

  /** Returns the field in use. */
  DeformationField field() {
    return field;
  }

  /**
   * Sets the force on the material, N, clipped to the forces that are proved to fold no
   * tetrahedron.
   *
   * @return whether it was clipped
   */
  boolean setForce(double x, double y, double z) {
    change[0] = x - field.baseNewton[0];
    change[1] = y - field.baseNewton[1];
    change[2] = z - field.baseNewton[2];
    return field.room.clip(change);
  }

  /** Writes the force on the material after clipping, N. */
  void force(Vec3 dest) {
    dest.set(
        field.baseNewton[0] + change[0],
        field.baseNewton[1] + change[1],
        field.baseNewton[2] + change[2]);
  }

  /** Returns the displacement of a node along an axis, cells. */
  double displacement(int node, int axis) {
    return field.displacement(node, axis, change, part);
  }

  /** Returns the present position of a node along an axis, in cells from the lattice's origin. */
  double nodePosition(int node, int axis) {
    return layout.nodeIndex(axis, node) + displacement(node, axis);
  }

  /** Returns the present position of a material point; {@code dest} may be {@code material}. */
  Vec3 forward(Vec3 material, Vec3 dest) {
    if (!select(material)) {
      return dest.set(material);
    }
    weigh();
    double x = displacement(0);
    double y = displacement(1);
    double z = displacement(2);
    return dest.set(
        material.x + x * layout.voxelsPerCell(0),
        material.y + y * layout.voxelsPerCell(1),
        material.z + z * layout.voxelsPerCell(2));
  }

  private double displacement(int axis) {
    double sum = 0;
    for (int n = 0; n < 4; n++) {
      sum += weights[n] * displacement(nodes[n], axis);
    }
    return sum;
  }

  /** Selects the tetrahedron of a material point. Returns false outside the lattice. */
  private boolean select(Vec3 material) {
    for (int axis = 0; axis < 3; axis++) {
      at[axis] = toCells(axis, material.get(axis));
    }
    return KuhnTetrahedra.find(at, cells, cell, order, along);
  }

  private double toCells(int axis, double grid) {
    return (grid - layout.originVoxel(axis)) / layout.voxelsPerCell(axis);
  }

  private void findNodes() {
    nodes[0] = layout.node(cell[0], cell[1], cell[2]);
    nodes[1] = nodes[0] + layout.cornerOffset(1 << order[0]);
    nodes[2] = nodes[0] + layout.cornerOffset(1 << order[0] | 1 << order[1]);
    nodes[3] = nodes[0] + layout.cornerOffset(7);
  }

  private void weigh() {
    findNodes();
    KuhnTetrahedra.weigh(along, weights);
  }

  /**
   * Returns the material point at a present position. The search goes from tetrahedron to
   * tetrahedron, each time through the face that the position lies beyond.
   *
   * @param near a material point at which to begin
   * @param dest may be {@code near} but not {@code present}
   */
  Vec3 inverse(Vec3 present, Vec3 near, Vec3 dest) {
    if (!isInside(present) || !(select(near) || select(present))) {
      return dest.set(present);
    }
    for (int axis = 0; axis < 3; axis++) {
      at[axis] = toCells(axis, present.get(axis));
    }
    for (int step = 0; step < MOST_STEPS; step++) {
      load();
      locate();
      if (!stepBeyond()) {
        break;
      }
    }
    return material(dest);
  }

  private boolean isInside(Vec3 present) {
    for (int axis = 0; axis < 3; axis++) {
      double position = toCells(axis, present.get(axis));
      if (!(position > 0 && position < layout.cells(axis))) {
        return false;
      }
    }
    return true;
  }

  /** Reads the present corners of the tetrahedron. */
  private void load() {
    findNodes();
    for (int n = 0; n < 4; n++) {
      for (int axis = 0; axis < 3; axis++) {
        corners[3 * n + axis] = nodePosition(nodes[n], axis);
      }
    }
    for (int n = 0; n < 3; n++) {
      for (int axis = 0; axis < 3; axis++) {
        edges[3 * axis + n] = corners[3 * n + 3 + axis] - corners[3 * n + axis];
      }
    }
  }

  /** Finds where along the edges the position lies. */
  private void locate() {
    double[] e = edges;
    double dx = at[0] - corners[0];
    double dy = at[1] - corners[1];
    double dz = at[2] - corners[2];
    double c0 = e[4] * e[8] - e[5] * e[7];
    double c1 = e[5] * e[6] - e[3] * e[8];
    double c2 = e[3] * e[7] - e[4] * e[6];
    double inverse = 1 / (e[0] * c0 + e[1] * c1 + e[2] * c2);
    double x1 = e[2] * e[7] - e[1] * e[8];
    double y1 = e[0] * e[8] - e[2] * e[6];
    double z1 = e[1] * e[6] - e[0] * e[7];
    double x2 = e[1] * e[5] - e[2] * e[4];
    double y2 = e[2] * e[3] - e[0] * e[5];
    double z2 = e[0] * e[4] - e[1] * e[3];
    along[0] = inverse * (c0 * dx + x1 * dy + x2 * dz);
    along[1] = inverse * (c1 * dx + y1 * dy + y2 * dz);
    along[2] = inverse * (c2 * dx + z1 * dy + z2 * dz);
  }

  /**
   * Goes to the neighbour beyond the face that the position lies beyond most.
   *
   * @return false if the position lies inside, or if there is no neighbour in the lattice
   */
  private boolean stepBeyond() {
    double a = 1 - along[0];
    double b = along[0] - along[1];
    double c = along[1] - along[2];
    double d = along[2];
    double least = Math.min(Math.min(a, b), Math.min(c, d));
    if (least >= INSIDE) {
      return false;
    }
    if (least == b) {
      KuhnTetrahedra.swap(0, order);
    } else if (least == c) {
      KuhnTetrahedra.swap(1, order);
    } else if (least == a) {
      return shift(order[0], 1, order[1], order[2], order[0]);
    } else {
      return shift(order[2], -1, order[2], order[0], order[1]);
    }
    return true;
  }

  /** Goes to the next cell along an axis, if there is one, with a new order of axes. */
  private boolean shift(int axis, int by, int first, int second, int third) {
    int next = cell[axis] + by;
    if (next < 0 || next >= layout.cells(axis)) {
      return false;
    }
    cell[axis] = next;
    order[0] = first;
    order[1] = second;
    order[2] = third;
    return true;
  }

  private Vec3 material(Vec3 dest) {
    for (int n = 0; n < 3; n++) {
      int axis = order[n];
      double cells = cell[axis] + Math.max(0, Math.min(1, along[n]));
      dest.set(axis, layout.originVoxel(axis) + cells * layout.voxelsPerCell(axis));
    }
    return dest;
  }

  /**
   * Writes the product of the transposed gradient of the map and a vector, divided by a bound of
   * the largest squared stretch. The gradient comes from differences over a cell, so that it is
   * continuous. The gradients of neighbouring tetrahedra would differ by a jump.
   *
   * @param vectorMm along the axes of the grid, mm; {@code dest} may be the same
   */
  void pullBack(Vec3 material, Vec3 vectorMm, Vec3 dest) {
    for (int axis = 0; axis < 3; axis++) {
      double half = 0.5 * layout.voxelsPerCell(axis);
      beside.set(material);
      beside.set(axis, material.get(axis) + half);
      forward(beside, high);
      beside.set(axis, material.get(axis) - half);
      forward(beside, low);
      for (int row = 0; row < 3; row++) {
        double cells = (high.get(row) - low.get(row)) / layout.voxelsPerCell(row);
        gradient[3 * axis + row] = cells * layout.edgeMm(row) / layout.edgeMm(axis);
      }
    }
    double factor = 1 / stretchBound();
    double x = column(0, vectorMm);
    double y = column(1, vectorMm);
    double z = column(2, vectorMm);
    dest.set(factor * x, factor * y, factor * z);
  }

  private double column(int axis, Vec3 vector) {
    int at0 = 3 * axis;
    return gradient[at0] * vector.x + gradient[at0 + 1] * vector.y + gradient[at0 + 2] * vector.z;
  }

  /** Returns a bound of the largest squared stretch, at least 1: the largest sum of a row. */
  private double stretchBound() {
    double most = 1;
    for (int a = 0; a < 3; a++) {
      double sum = 0;
      for (int b = 0; b < 3; b++) {
        double dot = 0;
        for (int row = 0; row < 3; row++) {
          dot += gradient[3 * a + row] * gradient[3 * b + row];
        }
        sum += Math.abs(dot);
      }
      most = Math.max(most, sum);
    }
    return most;
  }

  /** Writes the displacement of the point of an answer of this field for the present force, mm. */
  void displacementMm(LocalAnswer at, Vec3 dest) {
    at.displacementMm(change, dest);
  }

  /** Writes the answer of the field at a material point: none outside the lattice. */
  void answer(Vec3 material, LocalAnswer dest) {
    dest.clear(field.baseNewton);
    if (select(material)) {
      weigh();
      for (int n = 0; n < 4; n++) {
        int from = DeformationField.STRIDE * nodes[n];
        dest.add(part * weights[n], field.values, from, layout);
        if (part < 1) {
          dest.add((1 - part) * weights[n], field.earlier, from, layout);
        }
      }
    }
  }
}
