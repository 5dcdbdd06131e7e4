package org.palpate.elastic;

import java.util.Optional;
import org.palpate.elastic.lattice.ControlLattice;
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
 * <p>Around the contact it may have a window with shorter cells, see {@link Window}.
 *
 * <p>One thread writes it and hands it over by {@link FieldExchange}.
 */
final class DeformationField {
  /** The floats of a node: u, then r_x, r_y and r_z, three each. */
  static final int STRIDE = 12;

  /** The values of the nodes of the lattice. */
  final NodeValues whole;

  /** The window around the contact; null if the lattice never has one. */
  final Window window;

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
  DeformationField(Layout layout) {
    whole = new NodeValues(layout.whole().nodeCount());
    window = layout.window().map(Window::new).orElse(null);
  }

  /** Copies another field of the same lattice. */
  void set(DeformationField other) {
    place.set(other.place);
    earlierPlace.set(other.earlierPlace);
    slideIntervals = other.slideIntervals;
    whole.set(other.whole, slideIntervals > 0);
    if (window != null) {
      window.set(other.window, slideIntervals > 0);
    }
    System.arraycopy(other.baseNewton, 0, baseNewton, 0, baseNewton.length);
    room.set(other.room);
  }

  /** Whether the cells of the window take the place of those of the lattice. */
  boolean hasWindow() {
    return window != null && window.present;
  }

  /**
   * Takes the values and the place of the field before. Its displacement changes by its answers to
   * the force of this one. Call it after {@link #baseNewton} and the place of the window are set.
   */
  void takeEarlier(DeformationField before) {
    earlierPlace.set(before.place);
    double x = baseNewton[0] - before.baseNewton[0];
    double y = baseNewton[1] - before.baseNewton[1];
    double z = baseNewton[2] - before.baseNewton[2];
    float[] earlier = whole.earlier;
    System.arraycopy(before.whole.values, 0, earlier, 0, earlier.length);
    for (int at = 0; at < earlier.length; at += STRIDE) {
      for (int axis = at; axis < at + 3; axis++) {
        earlier[axis] +=
            (float) (x * earlier[axis + 3] + y * earlier[axis + 6] + z * earlier[axis + 9]);
      }
    }
    if (hasWindow()) {
      WindowNodes.round(earlier);
      window.takeEarlier(before.window, earlier, x, y, z);
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
   * The nodes of the fields of a lattice.
   *
   * @param whole those of the lattice
   * @param window those of the window around the contact, if there is one
   */
  record Layout(LatticeLayout whole, Optional<WindowNodes> window) {
    static Layout of(ControlLattice lattice) {
      return new Layout(
          lattice.layout(),
          lattice.window().map(window -> new WindowNodes(lattice.layout(), window)));
    }

    /** Returns the layout of the shortest cells, whose place may change. */
    LatticeLayout finest() {
      return window.map(WindowNodes::layout).orElse(whole);
    }
  }

  /**
   * The values of the nodes of a lattice or window in a {@link DeformationField}, twelve for each:
   * the displacement, and the answers to a force along each axis.
   */
  static final class NodeValues {
    /** Displacements in cells, and answers in cells per N. */
    final float[] values;

    /** The values of the field before, for the same force as {@link #values}. */
    final float[] earlier;

    /** Creates values without displacement and answers. */
    NodeValues(int nodes) {
      values = new float[DeformationField.STRIDE * nodes];
      earlier = new float[values.length];
    }

    /**
     * Copies other values of the same lattice.
     *
     * @param blended whether those of the field before matter
     */
    void set(NodeValues other, boolean blended) {
      System.arraycopy(other.values, 0, values, 0, values.length);
      if (blended) {
        System.arraycopy(other.earlier, 0, earlier, 0, earlier.length);
      }
    }

    /**
     * Returns the displacement of a node along an axis for a change of the force, cells.
     *
     * @param part the part of the newer field, 0 to 1
     */
    double displacement(int node, int axis, double[] changeNewton, double part) {
      int at = DeformationField.STRIDE * node + axis;
      double newer = displacement(values, at, changeNewton);
      return part == 1
          ? newer
          : part * newer + (1 - part) * displacement(earlier, at, changeNewton);
    }

    private static double displacement(float[] of, int at, double[] changeNewton) {
      return of[at]
          + changeNewton[0] * of[at + 3]
          + changeNewton[1] * of[at + 6]
          + changeNewton[2] * of[at + 9];
    }
  }

  /**
   * The part of a {@link DeformationField} around the contact that has shorter cells. Its sides are
   * displaced exactly as the cells around them, so that both are one continuous map.
   *
   * <p>One thread, as the field.
   */
  static final class Window {
    private final WindowNodes nodes;

    /** The values of its nodes, in its own cells. */
    final NodeValues values;

    /** The first cell of the whole lattice in the window, along each axis. */
    final int[] firstCell = new int[3];

    private final double[] change = new double[3];

    /**
     * Whether the field has the window; otherwise the cells of the whole lattice count there too.
     */
    boolean present;

    Window(WindowNodes nodes) {
      this.nodes = nodes;
      values = new NodeValues(nodes.layout().nodeCount());
    }

    /** Returns the nodes. */
    WindowNodes nodes() {
      return nodes;
    }

    /**
     * Copies another window.
     *
     * @param blended whether the values of the field before matter
     */
    void set(Window other, boolean blended) {
      present = other.present;
      System.arraycopy(other.firstCell, 0, firstCell, 0, 3);
      if (present) {
        values.set(other.values, blended);
      }
    }

    /** Whether a cell of the whole lattice lies in the window. */
    boolean covers(int x, int y, int z) {
      return covers(0, x) && covers(1, y) && covers(2, z);
    }

    private boolean covers(int axis, int cell) {
      return cell >= firstCell[axis] && cell < firstCell[axis] + nodes.wholeCells(axis);
    }

    /** Takes the values of its sides from those of the whole lattice, see {@link WindowNodes}. */
    void takeSides(float[] whole) {
      int first = nodes.firstNode(firstCell);
      for (int node = 0; node < nodes.layout().nodeCount(); node++) {
        if (nodes.isOnRim(node)) {
          nodes.interpolateNode(whole, first, node, values.values);
        }
      }
    }

    /**
     * Takes the values of the field before. Where the window of that field had no node inside, they
     * are those of the whole lattice.
     *
     * @param before the window of the field before; may be absent there
     * @param wholeEarlier the values of the field before on the whole lattice, for the force of
     *     this field
     * @param x the force of this field along x less that of the field before, N
     * @param y the same along y
     * @param z the same along z
     */
    void takeEarlier(Window before, float[] wholeEarlier, double x, double y, double z) {
      change[0] = x;
      change[1] = y;
      change[2] = z;
      int first = nodes.firstNode(firstCell);
      for (int node = 0; node < nodes.layout().nodeCount(); node++) {
        int from = before.present && !nodes.isOnRim(node) ? innerNode(before, node) : -1;
        if (from < 0) {
          nodes.interpolateNode(wholeEarlier, first, node, values.earlier);
        } else {
          takeNode(before, from, node);
        }
      }
    }

    /** Returns the number that a node has in another window, negative if it is not inside that. */
    private int innerNode(Window other, int node) {
      int x = inOther(other, 0, node);
      int y = inOther(other, 1, node);
      int z = inOther(other, 2, node);
      boolean inside = x > 0 && y > 0 && z > 0;
      if (!inside
          || x >= nodes.layout().cells(0)
          || y >= nodes.layout().cells(1)
          || z >= nodes.layout().cells(2)) {
        return -1;
      }
      return nodes.layout().node(x, y, z);
    }

    private int inOther(Window other, int axis, int node) {
      int ahead = firstCell[axis] - other.firstCell[axis];
      return nodes.layout().nodeIndex(axis, node) + nodes.factor() * ahead;
    }

    private void takeNode(Window before, int from, int node) {
      for (int axis = 0; axis < 3; axis++) {
        int to = DeformationField.STRIDE * node + axis;
        int at = DeformationField.STRIDE * from + axis;
        values.earlier[to] = (float) before.values.displacement(from, axis, change, 1);
        for (int answer = 3; answer < DeformationField.STRIDE; answer += 3) {
          values.earlier[to + answer] = before.values.values[at + answer];
        }
      }
    }
  }
}
