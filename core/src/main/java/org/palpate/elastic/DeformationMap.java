package org.palpate.elastic;

import java.util.Arrays;
import org.palpate.elastic.lattice.LatticeLayout;
import org.palpate.geometry.Vec3;

/**
 * The map from material coordinates to present ones, both grid coordinates: affine on the Kuhn
 * tetrahedra of each cell, the identity outside the lattice. Where the field has a window, its
 * cells take the place of those of the lattice. The force on the material may change from frame to
 * frame, within the {@link ForceRoom} of the field.
 *
 * <p>One thread; allocates nothing after construction.
 */
final class DeformationMap {
  private static final int MOST_STEPS = 400;

  /** A point this far outside a tetrahedron still counts as inside; in parts of its height. */
  private static final double INSIDE = -1e-12;

  private final Region whole;

  /** The window; null if the lattice never has one. */
  private final Region window;

  /** The lattice or the window: the one that has the tetrahedron in use. */
  private Region region;

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
  private final int[] crossing = new int[3];
  private final Vec3 beside = new Vec3();
  private final Vec3 high = new Vec3();
  private final Vec3 low = new Vec3();
  private final double[] gradient = new double[9];

  DeformationMap(DeformationField.Layout layout, DeformationField field) {
    whole = new Region(layout.whole());
    window = layout.window().map(nodes -> new Region(nodes.layout())).orElse(null);
    use(field);
  }

  /** Uses another field, with the force for which it was solved. */
  void use(DeformationField next) {
    field = next;
    whole.nodes = next.whole;
    region = whole;
    if (next.hasWindow()) {
      window.nodes = next.window.values;
      window.moveTo(whole, next.window.firstCell);
    }
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
    part = field.part(material, whole.layout);
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

  /** Returns the displacement of a node of the lattice along an axis, cells. */
  double displacement(int node, int axis) {
    return field.whole.displacement(node, axis, change, part);
  }

  /**
   * Returns the displacement of a node of the window along an axis, in cells of the window. The
   * field must have one.
   */
  double windowDisplacement(int node, int axis) {
    return field.window.values.displacement(node, axis, change, part);
  }

  /** Returns the present position of a node along an axis, in cells from the lattice's origin. */
  double nodePosition(int node, int axis) {
    return whole.layout.nodeIndex(axis, node) + displacement(node, axis);
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
        material.x + x * region.voxels[0],
        material.y + y * region.voxels[1],
        material.z + z * region.voxels[2]);
  }

  private double displacement(int axis) {
    double sum = 0;
    for (int n = 0; n < 4; n++) {
      sum += weights[n] * region.nodes.displacement(nodes[n], axis, change, part);
    }
    return sum;
  }

  /** Selects the tetrahedron of a material point. Returns false outside the lattice. */
  private boolean select(Vec3 material) {
    return (field.hasWindow() && select(window, material)) || select(whole, material);
  }

  private boolean select(Region next, Vec3 material) {
    region = next;
    locate(material);
    return KuhnTetrahedra.find(at, region.cells, cell, order, along);
  }

  /** Converts a position to cells of the region in use. */
  private void locate(Vec3 position) {
    for (int axis = 0; axis < 3; axis++) {
      at[axis] = region.toCells(axis, position.get(axis));
    }
  }

  private void findNodes() {
    LatticeLayout layout = region.layout;
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
    locate(present);
    for (int step = 0; step < MOST_STEPS; step++) {
      load();
      findAlong();
      Region before = region;
      if (!stepBeyond()) {
        break;
      }
      if (region != before) {
        locate(present);
      }
    }
    return material(dest);
  }

  private boolean isInside(Vec3 present) {
    for (int axis = 0; axis < 3; axis++) {
      double position = whole.toCells(axis, present.get(axis));
      if (!(position > 0 && position < whole.cells[axis])) {
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
        corners[3 * n + axis] = region.nodePosition(nodes[n], axis, change, part);
      }
    }
    for (int n = 0; n < 3; n++) {
      for (int axis = 0; axis < 3; axis++) {
        edges[3 * axis + n] = corners[3 * n + 3 + axis] - corners[3 * n + axis];
      }
    }
  }

  /** Finds where along the edges the position lies. */
  private void findAlong() {
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
    if (next < 0 || next >= region.cells[axis]) {
      return region == window && cross(whole, axis, by);
    }
    if (region == whole && field.hasWindow() && isCovered(axis, by)) {
      return cross(window, axis, by);
    }
    cell[axis] = next;
    order[0] = first;
    order[1] = second;
    order[2] = third;
    return true;
  }

  /** Whether the cell beyond a face of this one lies in the window. */
  private boolean isCovered(int axis, int by) {
    cell[axis] += by;
    boolean covered = field.window.covers(cell[0], cell[1], cell[2]);
    cell[axis] -= by;
    return covered;
  }

  /**
   * Goes through the side of the window to the tetrahedron beyond it, at the position along the
   * edges, clamped to the present cell.
   *
   * @return false if there is no cell beyond
   */
  private boolean cross(Region next, int axis, int by) {
    material(beside);
    double side = region.toGrid(axis, cell[axis] + Math.max(0, by));
    for (int n = 0; n < 3; n++) {
      int first = n == axis && by < 0 ? 1 : 0;
      double inCells = next.toCells(n, n == axis ? side : beside.get(n));
      double wholes = n == axis ? Math.rint(inCells) - first : Math.floor(inCells);
      double within = Math.max(0, Math.min(next.cells[n] - 1.0, wholes));
      if (n == axis && within != wholes) {
        return false;
      }
      crossing[n] = (int) within;
      at[n] = inCells - within;
    }
    System.arraycopy(crossing, 0, cell, 0, 3);
    region = next;
    KuhnTetrahedra.sort(at[0], at[1], at[2], order, along);
    return true;
  }

  private Vec3 material(Vec3 dest) {
    for (int n = 0; n < 3; n++) {
      int axis = order[n];
      double cells = cell[axis] + Math.max(0, Math.min(1, along[n]));
      dest.set(axis, region.toGrid(axis, cells));
    }
    return dest;
  }

  /**
   * Writes the product of the transposed gradient of the map and a vector, divided by a bound of
   * the largest squared stretch. The gradient comes from differences over a cell at the point, so
   * that it is continuous. The gradients of neighbouring tetrahedra would differ by a jump.
   *
   * @param vectorMm along the axes of the grid, mm; {@code dest} may be the same
   */
  void pullBack(Vec3 material, Vec3 vectorMm, Vec3 dest) {
    select(material);
    Region around = region;
    for (int axis = 0; axis < 3; axis++) {
      double half = 0.5 * around.voxels[axis];
      beside.set(material);
      beside.set(axis, material.get(axis) + half);
      forward(beside, high);
      beside.set(axis, material.get(axis) - half);
      forward(beside, low);
      for (int row = 0; row < 3; row++) {
        double cells = (high.get(row) - low.get(row)) / around.voxels[row];
        gradient[3 * axis + row] = cells * around.layout.edgeMm(row) / around.layout.edgeMm(axis);
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
        dest.add(part * weights[n], region.nodes.values, from, region.layout);
        if (part < 1) {
          dest.add((1 - part) * weights[n], region.nodes.earlier, from, region.layout);
        }
      }
    }
  }

  /**
   * A lattice or a window in a {@link DeformationMap}, and its place in the grid. Haptic thread, as
   * the map.
   */
  private static final class Region {
    /** The numbering of nodes and the edges of cells; its place may be another one. */
    final LatticeLayout layout;

    /** The number of cells along each axis. */
    final int[] cells = new int[3];

    /** The voxels of a cell along each axis. */
    final double[] voxels = new double[3];

    /** The values of the nodes of the field in use. */
    DeformationField.NodeValues nodes;

    /** The grid coordinates of the first node. */
    private final double[] origin = new double[3];

    /** Makes a region in the present place of its layout. */
    Region(LatticeLayout layout) {
      this.layout = layout;
      for (int axis = 0; axis < 3; axis++) {
        cells[axis] = layout.cells(axis);
        voxels[axis] = layout.voxelsPerCell(axis);
        origin[axis] = layout.originVoxel(axis);
      }
    }

    /** Moves the region, so that it begins at a cell of another one. */
    void moveTo(Region whole, int[] firstCell) {
      for (int axis = 0; axis < 3; axis++) {
        origin[axis] = whole.toGrid(axis, firstCell[axis]);
      }
    }

    /** Returns the present position of a node along an axis, in cells from the first one. */
    double nodePosition(int node, int axis, double[] changeNewton, double part) {
      return layout.nodeIndex(axis, node) + nodes.displacement(node, axis, changeNewton, part);
    }

    /** Returns a grid coordinate in cells from the first node. */
    double toCells(int axis, double grid) {
      return (grid - origin[axis]) / voxels[axis];
    }

    /** Returns the grid coordinate of a distance in cells from the first node. */
    double toGrid(int axis, double inCells) {
      return origin[axis] + inCells * voxels[axis];
    }
  }
}
