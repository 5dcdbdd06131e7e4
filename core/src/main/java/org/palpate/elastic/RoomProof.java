package org.palpate.elastic;

import org.palpate.elastic.lattice.ActiveCells;
import org.palpate.elastic.lattice.ControlLattice;
import org.palpate.elastic.lattice.LatticeLayout;

/**
 * Proves that a field folds no tetrahedron, and how far its force may change before one could.
 *
 * <p>A tetrahedron with gradient F stays positive while the change of F is shorter than the least
 * singular value of F, which is at least 2 det F / |F|^2. Lengths are Frobenius norms. {@code
 * docs/guarantee.md} has the proof.
 *
 * <p>One thread; allocates nothing after construction.
 */
final class RoomProof {
  /** The least determinant of a field that counts as proved; far above any rounding. */
  static final double LEAST_DETERMINANT = 0.01;

  /** The largest sum of the squared edges of a tetrahedron for which rounding is negligible. */
  private static final double MOST_SQUARED_LENGTH = 1e4;

  /** The longest change of a cell by a force in the room for which rounding is negligible. */
  private static final double MOST_CHANGE_CELLS = 100;

  /**
   * Up to this distance of the edges of a tetrahedron from those at rest, its least singular value
   * is at least 1 minus the distance, and its determinant the cube of that, above {@link
   * #LEAST_DETERMINANT}.
   */
  private static final double MOST_DEVIATION = 0.7;

  /** The part of the least singular value that a change may take. */
  private static final double USED_PART = 0.9;

  /** The part of a cone after which the next one begins. */
  private static final double NEXT_CONE = 0.6;

  /** A shorter step along the axis is not worth a cone, N. */
  private static final double LEAST_STEP_NEWTON = 1e-3;

  /** The cones that may lie towards larger forces; the others lie towards smaller ones. */
  private static final int MOST_UPWARD = 10;

  /** The twelve edges of a cell, as pairs of corners. */
  private static final int[] EDGES = {
    0, 1, 2, 3, 4, 5, 6, 7, 0, 2, 1, 3, 4, 6, 5, 7, 0, 4, 1, 5, 2, 6, 3, 7
  };

  /** The cells of a lattice or a window, and their quick bounds. */
  private record Region(ActiveCells cells, CellBounds bounds) {
    Region(ActiveCells cells) {
      this(cells, new CellBounds(cells.layout()));
    }
  }

  private final Region whole;

  /** The cells of the window; null if the lattice never has one. */
  private final Region window;

  /** The cells of the lattice or of the window, of which one is being looked at. */
  private ActiveCells cells;

  private CellBounds bounds;

  /** The values of its nodes. */
  private DeformationField.NodeValues nodes;

  /** The cells that could fold within reach. The one with the shortest bound is the first. */
  private final int[] near;

  private int nearCount;

  /** For each of them a cone around no change in which it does not fold, N. */
  private final double[] ownAlong;

  private final double[] ownAcross;

  /** Whether its cone was measured; otherwise it comes from a bound that is far shorter. */
  private final boolean[] measured;

  private final double[] corners = new double[KuhnTetrahedra.ENTRIES];

  /** The change of the corners from the start of the slide to its end. */
  private final double[] slides = new double[KuhnTetrahedra.ENTRIES];

  private final double[] none = new double[3];
  private final double[] change = new double[3];

  /** Squares by 8 times the first corner of an edge plus the second. */
  private final double[] length2 = new double[64];

  private final double[] along2 = new double[64];
  private final double[] across2 = new double[64];
  private final double[] slide2 = new double[64];

  /** The cone that is being measured, N. */
  private double along;

  private double across;

  /** The cone of the cell that is being measured, N. */
  private double cellAlong;

  private double cellAcross;

  /** The longest change of the force that a cone may hold, N. */
  private double reach;

  RoomProof(ControlLattice lattice) {
    whole = new Region(lattice.cells());
    window = lattice.window().map(inside -> new Region(inside.matter().cells())).orElse(null);
    near = new int[whole.cells.count() + (window == null ? 0 : window.cells.count())];
    ownAlong = new double[near.length];
    ownAcross = new double[near.length];
    measured = new boolean[near.length];
  }

  /**
   * Proves a field and writes its {@link DeformationField#room} along the axis that the room has.
   * If the field cannot be proved for the whole slide, it is not blended.
   *
   * @param reachNewton the longest change of the force to prove; shorter if the answers are large
   * @param lowestNewton the lowest place of a cone along the axis, not positive
   * @return whether the field without a change is proved; if not, it must not be used
   */
  boolean prove(DeformationField field, double reachNewton, double lowestNewton) {
    if (field.slideIntervals > 0) {
      if (findNear(field, reachNewton) && addCone(field, 0) > 0) {
        addCones(field, lowestNewton);
        return true;
      }
      field.slideIntervals = 0;
    }
    if (!findNear(field, reachNewton)) {
      return false;
    }
    addCone(field, 0);
    addCones(field, lowestNewton);
    return true;
  }

  /** Adds the cones above and below the first one, which was measured last. */
  private void addCones(DeformationField field, double lowestNewton) {
    ForceRoom room = field.room;
    double first = along;
    double place = NEXT_CONE * first;
    for (int n = 0; n < MOST_UPWARD && place < reach; n++) {
      double size = addCone(field, place);
      if (size < LEAST_STEP_NEWTON) {
        break;
      }
      place += NEXT_CONE * size;
    }
    place = Math.max(lowestNewton, -NEXT_CONE * first);
    while (!room.isFull() && place < 0) {
      double size = addCone(field, place);
      if (size < LEAST_STEP_NEWTON || place == lowestNewton) {
        break;
      }
      place = Math.max(lowestNewton, place - NEXT_CONE * size);
    }
  }

  /** Adds the cone around a place of the axis, if it is proved, and returns its size along it. */
  private double addCone(DeformationField field, double place) {
    beginCone(field, place);
    double away = Math.abs(place);
    for (int n = 0; n < nearCount && along > 0; n++) {
      if (!isOwnConeEnough(n, away) && !measured[n]) {
        measureCell(field, near[n], none);
        setOwn(n, cellAlong, cellAcross, true);
      }
      if (!isOwnConeEnough(n, away)) {
        boolean proved = measureCell(field, near[n], change);
        along = proved ? Math.min(along, cellAlong) : 0;
        across = proved ? Math.min(across, cellAcross) : 0;
      }
    }
    if (along > 0 && across > 0) {
      field.room.add(place, along, across);
    }
    return along;
  }

  private void setOwn(int n, double alongNewton, double acrossNewton, boolean isMeasured) {
    ownAlong[n] = alongNewton;
    ownAcross[n] = acrossNewton;
    measured[n] = isMeasured;
  }

  /**
   * Whether the own cone of a cell holds the one that is being measured. It holds a cone of its own
   * shape around a place of the axis, shorter by the distance of the place. A cell that does not
   * answer along the axis has an infinite cone there, and still a finite one across.
   */
  private boolean isOwnConeEnough(int n, double away) {
    double part = 1 - away / ownAlong[n];
    return part * ownAlong[n] >= along && part * ownAcross[n] >= across;
  }

  private void beginCone(DeformationField field, double place) {
    double[] axis = field.room.axis();
    for (int n = 0; n < 3; n++) {
      change[n] = place * axis[n];
    }
    along = reach - Math.abs(place);
    across = along;
  }

  /**
   * Checks every cell without a change of the force, and lists those that could fold within reach.
   * Shortens the reach if the answers are large.
   *
   * @return whether every cell is proved where the proof looks at the slide
   */
  private boolean findNear(DeformationField field, double reachNewton) {
    nearCount = 0;
    reach = reachNewton;
    boolean blended = field.slideIntervals > 0;
    whole.bounds.read(field.whole, blended);
    if (field.hasWindow()) {
      window.bounds.read(field.window.values, blended);
    }
    int count = field.hasWindow() ? near.length : whole.cells.count();
    for (int cell = 0; cell < count; cell++) {
      int first = select(field, cell);
      if (cells == whole.cells && field.hasWindow() && isCovered(field.window, first)) {
        continue;
      }
      double room = leastRoom(field, first);
      double answers = bounds.squaredAnswers(first);
      if (Double.isNaN(room) || !Double.isFinite(answers)) {
        return false;
      }
      reach = Math.min(reach, MOST_CHANGE_CELLS / Math.sqrt(answers));
      double least = room / Math.sqrt(answers);
      if (!(least >= reach)) {
        addNear(cell, least);
      }
    }
    return true;
  }

  /**
   * Selects a cell: those of the lattice come first, then those of the window. Returns its first
   * node.
   */
  private int select(DeformationField field, int cell) {
    boolean inWindow = cell >= whole.cells.count();
    Region region = inWindow ? window : whole;
    cells = region.cells;
    bounds = region.bounds;
    nodes = inWindow ? field.window.values : field.whole;
    return cells.firstNode(inWindow ? cell - whole.cells.count() : cell);
  }

  private boolean isCovered(DeformationField.Window inField, int firstNode) {
    LatticeLayout layout = whole.cells.layout();
    return inField.covers(
        layout.nodeIndex(0, firstNode),
        layout.nodeIndex(1, firstNode),
        layout.nodeIndex(2, firstNode));
  }

  /**
   * Returns how much a cell may change on the whole slide, without a change of the force; not
   * positive if this bound is too coarse to tell, and NaN if the cell is not proved.
   */
  private double leastRoom(DeformationField field, int firstNode) {
    double deviation = Math.sqrt(bounds.squaredDeviation(firstNode));
    return deviation <= MOST_DEVIATION
        ? USED_PART * (1 - deviation)
        : leastMeasuredRoom(field, firstNode);
  }

  private double leastMeasuredRoom(DeformationField field, int firstNode) {
    readSlides(field, firstNode, none);
    double used = halfInterval(field) * Math.sqrt(mostSquared(slides));
    double least = Double.POSITIVE_INFINITY;
    for (int n = 0; n <= field.slideIntervals; n++) {
      readCorners(firstNode, none, part(field, n));
      double determinant = KuhnTetrahedra.leastDeterminant(corners);
      double squared = mostSquared(corners);
      if (!(determinant >= LEAST_DETERMINANT && squared <= MOST_SQUARED_LENGTH / 16)) {
        return Double.NaN;
      }
      least = Math.min(least, USED_PART * 2 * determinant / squared - used);
    }
    return least;
  }

  /** Returns the part of the newer field at an end of an interval of the slide. */
  private static double part(DeformationField field, int n) {
    return field.slideIntervals == 0 ? 1 : (double) n / field.slideIntervals;
  }

  /** Returns the longest distance on the slide from a place at which the proof looks. */
  private static double halfInterval(DeformationField field) {
    return field.slideIntervals == 0 ? 0 : 0.5 / field.slideIntervals;
  }

  /** Adds a cell to the list, in front if its cone may be the shortest. */
  private void addNear(int cell, double leastNewton) {
    boolean first = nearCount > 0 && leastNewton < ownAlong[0];
    if (first) {
      near[nearCount] = near[0];
      setOwn(nearCount, ownAlong[0], ownAcross[0], false);
    }
    int n = first ? 0 : nearCount;
    near[n] = cell;
    setOwn(n, leastNewton, leastNewton, false);
    nearCount++;
  }

  /**
   * Returns a bound of the sum over the squared edges of each tetrahedron of a cell. A tetrahedron
   * has one edge along each axis, so the sum over the longest edges along each axis is one.
   */
  private static double mostSquared(double[] at) {
    double sum = 0;
    for (int axis = 0; axis < 3; axis++) {
      double most = 0;
      for (int corner = 0; corner < LatticeLayout.CORNERS; corner++) {
        if ((corner >> axis & 1) == 0) {
          most = Math.max(most, squaredDistance(at, 3 * corner, 3 * (corner | 1 << axis)));
        }
      }
      sum += most;
    }
    return sum;
  }

  private static double squaredDistance(double[] at, int a, int b) {
    double x = at[b] - at[a];
    double y = at[b + 1] - at[a + 1];
    double z = at[b + 2] - at[a + 2];
    return x * x + y * y + z * z;
  }

  private void readCorners(int firstNode, double[] changeNewton, double part) {
    for (int corner = 0; corner < LatticeLayout.CORNERS; corner++) {
      int node = firstNode + cells.layout().cornerOffset(corner);
      for (int axis = 0; axis < 3; axis++) {
        corners[3 * corner + axis] =
            (corner >> axis & 1) + nodes.displacement(node, axis, changeNewton, part);
      }
    }
  }

  private void readSlides(DeformationField field, int firstNode, double[] changeNewton) {
    if (field.slideIntervals == 0) {
      return;
    }
    for (int corner = 0; corner < LatticeLayout.CORNERS; corner++) {
      int node = firstNode + cells.layout().cornerOffset(corner);
      for (int axis = 0; axis < 3; axis++) {
        slides[3 * corner + axis] =
            nodes.displacement(node, axis, changeNewton, 1)
                - nodes.displacement(node, axis, changeNewton, 0);
      }
    }
  }

  /**
   * Measures the cone of a cell around a change of the force. Returns false, with no cone, if the
   * cell is not proved there.
   */
  private boolean measureCell(DeformationField field, int cell, double[] changeNewton) {
    int first = select(field, cell);
    readSlides(field, first, changeNewton);
    measureAnswers(field, first);
    cellAlong = Double.POSITIVE_INFINITY;
    cellAcross = Double.POSITIVE_INFINITY;
    boolean proved = true;
    for (int n = 0; n <= field.slideIntervals && proved; n++) {
      readCorners(first, changeNewton, part(field, n));
      measureLengths();
      proved = measureTetrahedra(halfInterval(field));
    }
    if (!proved) {
      cellAlong = 0;
      cellAcross = 0;
    }
    return proved;
  }

  /** Measures how far each edge moves on the slide, and by unit forces along and across. */
  private void measureAnswers(DeformationField field, int firstNode) {
    for (int n = 0; n < EDGES.length; n += 2) {
      int a = EDGES[n];
      int b = EDGES[n + 1];
      int edge = 8 * a + b;
      int from = DeformationField.STRIDE * (firstNode + cells.layout().cornerOffset(a)) + 3;
      int to = DeformationField.STRIDE * (firstNode + cells.layout().cornerOffset(b)) + 3;
      along2[edge] = 0;
      across2[edge] = 0;
      addLonger(nodes.values, field.room.axis(), from, to, edge);
      if (field.slideIntervals > 0) {
        addLonger(nodes.earlier, field.room.axis(), from, to, edge);
        slide2[edge] = squaredDistance(slides, 3 * a, 3 * b);
      }
    }
  }

  /**
   * Raises the squared answers of an edge to those of a field, to forces along the axis of the room
   * and across it. Those across are a cross product, in which nothing cancels.
   */
  private void addLonger(float[] values, double[] e, int from, int to, int edge) {
    double newAlong2 = 0;
    double newAcross2 = 0;
    for (int axis = 0; axis < 3; axis++) {
      double x = (double) values[to + axis] - values[from + axis];
      double y = (double) values[to + axis + 3] - values[from + axis + 3];
      double z = (double) values[to + axis + 6] - values[from + axis + 6];
      double slope = e[0] * x + e[1] * y + e[2] * z;
      double crossX = e[1] * z - e[2] * y;
      double crossY = e[2] * x - e[0] * z;
      double crossZ = e[0] * y - e[1] * x;
      newAlong2 += slope * slope;
      newAcross2 += crossX * crossX + crossY * crossY + crossZ * crossZ;
    }
    along2[edge] = Math.max(along2[edge], newAlong2);
    across2[edge] = Math.max(across2[edge], newAcross2);
  }

  private void measureLengths() {
    for (int n = 0; n < EDGES.length; n += 2) {
      int a = EDGES[n];
      int b = EDGES[n + 1];
      length2[8 * a + b] = squaredDistance(corners, 3 * a, 3 * b);
    }
  }

  /**
   * Shortens the cone of a cell to what its tetrahedra allow.
   *
   * @param halfInterval the part of the slide on each side to which the cone must apply
   * @return whether they are proved there
   */
  private boolean measureTetrahedra(double halfInterval) {
    for (int[] order : KuhnTetrahedra.ORDERS) {
      double determinant = KuhnTetrahedra.determinant(corners, order);
      int b = 1 << order[0];
      int c = b | 1 << order[1];
      double squared = sum(length2, b, c);
      if (!(determinant >= LEAST_DETERMINANT && squared <= MOST_SQUARED_LENGTH)) {
        return false;
      }
      double room = USED_PART * 2 * determinant / squared;
      if (halfInterval > 0) {
        room -= halfInterval * Math.sqrt(sum(slide2, b, c));
      }
      if (!(room > 0)) {
        return false;
      }
      cellAlong = Math.min(cellAlong, room / Math.sqrt(sum(along2, b, c)));
      cellAcross = Math.min(cellAcross, room / Math.sqrt(sum(across2, b, c)));
    }
    return true;
  }

  /** Returns the sum over the edges 0 to b, b to c and c to 7. */
  private static double sum(double[] squares, int b, int c) {
    return squares[b] + squares[8 * b + c] + squares[8 * c + 7];
  }
}
