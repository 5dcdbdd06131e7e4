package org.palpate.scene;

import java.util.Optional;
import org.palpate.elastic.KuhnTetrahedra;
import org.palpate.elastic.PublishedShape;
import org.palpate.elastic.lattice.LatticeLayout;
import org.palpate.geometry.Vec3;

/**
 * The displacement of everything that is drawn in one picture: a vector at each node of a lattice,
 * affine between them on the Kuhn tetrahedra of each cell, and none outside the lattice. A box in
 * the lattice may have shorter cells.
 *
 * <p>Immutable by convention: its array is read-only. Millimetres along the axes of the grid.
 */
public final class Deformation {
  /** A node that is displaced by less than this counts as one that stands still, mm. */
  private static final double STILL_MM = 1e-3;

  private static final int MOST_STEPS = 60;

  private final int[] nodes;
  private final Vec3 originMm;
  private final Vec3 cellMm;
  private final float[] displacementsMm;
  private final Optional<Deformation> window;
  private final Vec3 lowMm = new Vec3(Double.MAX_VALUE, Double.MAX_VALUE, Double.MAX_VALUE);
  private final Vec3 highMm = new Vec3(-Double.MAX_VALUE, -Double.MAX_VALUE, -Double.MAX_VALUE);
  private double longestMm;

  /**
   * Creates a deformation.
   *
   * @param nodes the number of nodes along each axis, at least 2
   * @param originMm the first node, grid mm
   * @param cellMm the edges of a cell, mm
   * @param displacementsMm x, y, z of each node's displacement, mm; the nodes along x follow one
   *     another. The array belongs to the deformation from now on.
   */
  public Deformation(int[] nodes, Vec3 originMm, Vec3 cellMm, float[] displacementsMm) {
    this(nodes, originMm, cellMm, displacementsMm, Optional.empty());
  }

  /**
   * Creates a deformation with shorter cells in a box.
   *
   * @param nodes the number of nodes along each axis, at least 2
   * @param originMm the first node, grid mm
   * @param cellMm the edges of a cell, mm
   * @param displacementsMm as of the other constructor
   * @param window what takes the place of the lattice in its box, without a window of its own
   */
  public Deformation(
      int[] nodes,
      Vec3 originMm,
      Vec3 cellMm,
      float[] displacementsMm,
      Optional<Deformation> window) {
    this.window = window;
    this.nodes = nodes.clone();
    this.originMm = originMm;
    this.cellMm = cellMm;
    this.displacementsMm = displacementsMm;
    for (int node = 0; node < displacementsMm.length / 3; node++) {
      include(node);
    }
    window.ifPresent(this::include);
  }

  private void include(Deformation inBox) {
    longestMm = Math.max(longestMm, inBox.longestMm);
    for (int axis = 0; axis < 3; axis++) {
      lowMm.set(axis, Math.min(lowMm.get(axis), inBox.lowMm.get(axis)));
      highMm.set(axis, Math.max(highMm.get(axis), inBox.highMm.get(axis)));
    }
  }

  /** Returns the present deformation of a shape. The reader of the shape calls it. */
  public static Deformation of(PublishedShape shape) {
    LatticeLayout layout = shape.layout();
    Vec3 origin = new Vec3();
    for (int axis = 0; axis < 3; axis++) {
      origin.set(axis, layout.originVoxel(axis));
    }
    float[] displacements = new float[3 * layout.nodeCount()];
    shape.displacementsMm(displacements);
    return of(
        layout, origin, displacements, shape.windowLayout().map(inBox -> window(shape, inBox)));
  }

  private static Deformation window(PublishedShape shape, LatticeLayout layout) {
    float[] displacements = new float[3 * layout.nodeCount()];
    shape.windowDisplacementsMm(displacements);
    return of(layout, shape.windowOrigin(new Vec3()), displacements, Optional.empty());
  }

  private static Deformation of(
      LatticeLayout layout, Vec3 originGrid, float[] displacements, Optional<Deformation> window) {
    int[] nodes = new int[3];
    Vec3 origin = new Vec3();
    Vec3 cell = new Vec3();
    for (int axis = 0; axis < 3; axis++) {
      nodes[axis] = layout.cells(axis) + 1;
      cell.set(axis, layout.edgeMm(axis));
      double voxelMm = layout.edgeMm(axis) / layout.voxelsPerCell(axis);
      origin.set(axis, originGrid.get(axis) * voxelMm);
    }
    return new Deformation(nodes, origin, cell, displacements, window);
  }

  private void include(int node) {
    double square = 0;
    for (int axis = 0; axis < 3; axis++) {
      double mm = displacementsMm[3 * node + axis];
      square += mm * mm;
    }
    longestMm = Math.max(longestMm, Math.sqrt(square));
    if (square < STILL_MM * STILL_MM) {
      return;
    }
    int rest = node;
    for (int axis = 0; axis < 3; axis++) {
      double edge = cellMm.get(axis);
      double at = originMm.get(axis) + rest % nodes[axis] * edge;
      rest /= nodes[axis];
      lowMm.set(axis, Math.min(lowMm.get(axis), at - edge));
      highMm.set(axis, Math.max(highMm.get(axis), at + edge));
    }
  }

  /** Returns the number of nodes along an axis. */
  public int nodes(int axis) {
    return nodes[axis];
  }

  /** Returns the first node, grid mm; read-only. */
  public Vec3 originMm() {
    return originMm;
  }

  /** Returns the edges of a cell, mm; read-only. */
  public Vec3 cellMm() {
    return cellMm;
  }

  /** Returns x, y, z of each node's displacement, mm, in the order of the constructor. */
  public float[] displacementsMm() {
    return displacementsMm;
  }

  /** Returns what takes the place of the lattice in a box. */
  public Optional<Deformation> window() {
    return window;
  }

  /** Returns the shortest edge of a cell along an axis, mm. */
  public double shortestCellMm(int axis) {
    return window.orElse(this).cellMm.get(axis);
  }

  /** Returns the length of the longest displacement, mm. */
  public double longestMm() {
    return longestMm;
  }

  /**
   * Writes where a present position was at rest, grid mm. Each step takes back half of the error
   * that is left, so that the search also converges where the material is stretched nearly four
   * times. It ends after 60 steps, with what is left of the error.
   *
   * @param dest another vector
   */
  public Vec3 atRest(Vec3 presentMm, Vec3 dest) {
    dest.set(presentMm);
    Vec3 displacement = new Vec3();
    double missedMm = Double.POSITIVE_INFINITY;
    for (int step = 0; step < MOST_STEPS && missedMm > STILL_MM; step++) {
      displacementMm(dest, displacement);
      displacement.add(dest, displacement);
      presentMm.sub(displacement, displacement);
      missedMm = displacement.length();
      dest.add(displacement.mul(0.5, displacement), dest);
    }
    return dest;
  }

  /** Writes the displacement of a position at rest: none outside the lattice. */
  private void displacementMm(Vec3 restMm, Vec3 dest) {
    if (window.isEmpty() || !window.get().findDisplacementMm(restMm, dest)) {
      findDisplacementMm(restMm, dest);
    }
  }

  /** Writes the displacement of a position by this lattice alone. Returns whether it is inside. */
  private boolean findDisplacementMm(Vec3 restMm, Vec3 dest) {
    double[] at = new double[3];
    int[] cells = new int[3];
    for (int axis = 0; axis < 3; axis++) {
      at[axis] = (restMm.get(axis) - originMm.get(axis)) / cellMm.get(axis);
      cells[axis] = nodes[axis] - 1;
    }
    int[] node = new int[3];
    int[] order = new int[3];
    double[] along = new double[3];
    dest.set(0, 0, 0);
    boolean inside = KuhnTetrahedra.find(at, cells, node, order, along);
    if (inside) {
      double[] weights = new double[4];
      KuhnTetrahedra.weigh(along, weights);
      addNode(weights[0], node, dest);
      for (int n = 0; n < 3; n++) {
        node[order[n]]++;
        addNode(weights[n + 1], node, dest);
      }
    }
    return inside;
  }

  private void addNode(double weight, int[] index, Vec3 dest) {
    int at = 3 * (index[0] + nodes[0] * (index[1] + nodes[1] * index[2]));
    dest.set(
        dest.x + weight * displacementsMm[at],
        dest.y + weight * displacementsMm[at + 1],
        dest.z + weight * displacementsMm[at + 2]);
  }

  /** Whether some of a box in grid mm may be displaced. */
  public boolean moves(Vec3 boxLowMm, Vec3 boxHighMm) {
    boolean meets = true;
    for (int axis = 0; axis < 3; axis++) {
      meets &= boxLowMm.get(axis) <= highMm.get(axis) && boxHighMm.get(axis) >= lowMm.get(axis);
    }
    return meets;
  }
}
