package org.palpate.elastic.lattice;

import java.util.ArrayList;
import java.util.List;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.IntBox;
import org.palpate.volume.BitCube;

/**
 * The lattice over elastic segments and some air around them. A cell has the mean modulus of its
 * voxels, in which air counts with 1e-8 of the stiffest segment, and their second moments.
 *
 * <p>Nodes are fixed on the rim of the lattice, far from elastic voxels, and where at least a fifth
 * of the voxels around them belongs to a segment that stands still.
 *
 * <p>Moduli follow edits of the voxels, see {@link #refill}; which nodes are fixed does not. One
 * thread, the one that solves; allocates nothing after construction.
 */
public final class ControlLattice {
  /** The layers of cells around the elastic segments that deform with them. */
  static final int AIR_CELLS = 2;

  /**
   * The number of cells along an axis is a multiple of this, so that there are coarser lattices. So
   * is the number of cells before the elastic segments: where they stand on a plane, that plane has
   * nodes on the coarser lattices too, which halves the iterations.
   */
  private static final int CELL_MULTIPLE = 4;

  /** Small enough that a plate of two voxels bends nearly as freely as without air. */
  private static final double AIR_PER_SOLID = 1e-8;

  /**
   * The stiffness of the springs that hold a part without support, over that of a cell of the
   * stiffest segment.
   */
  private static final double HOLD_PER_CELL = 10;

  /** The share of still voxels around a node that fixes it. */
  private static final double FIXING_SHARE = 0.2;

  private final LatticeLayout layout;
  private final List<ElasticSegment> segments;
  private final double airModulus;
  private final ActiveCells cells;
  private final float[] restModulus;
  private final float[] solidModulus;
  private final CellMatter matter;
  private final StiffnessOperator stiffness;
  private final MultigridPreconditioner preconditioner;
  private final FreeParts parts;
  private final boolean[] free;
  private final float springNewtonPerMm;
  private int freeParts;

  /** Whether matter came into an empty cell, or all matter left one, since the last search. */
  private boolean partsMayDiffer;

  /**
   * Creates a lattice.
   *
   * @param metric the spacing of the grid
   * @param segments those that deform, with one Poisson's ratio, at least one voxel in all
   * @param still the voxels of the segments that stand still
   * @param edgeMm the edge of a cell, mm; rounded to whole voxels
   * @throws IllegalArgumentException if there is no voxel, the ratios differ, or there would be too
   *     many cells
   */
  public ControlLattice(
      GridMetric metric, List<ElasticSegment> segments, List<BitCube> still, double edgeMm) {
    this.segments = List.copyOf(segments);
    double poisson = commonPoisson(segments);
    layout = LatticeLayout.around(bounds(segments), metric, edgeMm, CELL_MULTIPLE, CELL_MULTIPLE);
    airModulus = AIR_PER_SOLID * stiffest(segments);
    cells = new ActiveCells(layout, fixedNodes(still));
    restModulus = new float[cells.count()];
    solidModulus = new float[cells.count()];
    stiffness = new StiffnessOperator(cells, poisson);
    matter = new CellMatter(layout);
    for (int n = 0; n < cells.count(); n++) {
      refill(n);
    }
    System.arraycopy(restModulus, 0, stiffness.modulus(), 0, restModulus.length);
    stiffness.changed();
    preconditioner = new MultigridPreconditioner(stiffness, poisson);
    parts = new FreeParts(cells, solidModulus);
    free = new boolean[layout.nodeCount()];
    springNewtonPerMm = (float) (HOLD_PER_CELL * stiffest(this.segments) * layout.longestEdgeMm());
    partsMayDiffer = false;
  }

  private static double commonPoisson(List<ElasticSegment> segments) {
    double first = segments.isEmpty() ? 0 : segments.get(0).material().poisson();
    for (ElasticSegment segment : segments) {
      double other = segment.material().poisson();
      if (other != first) {
        throw new IllegalArgumentException(
            "elastic segments need one Poisson's ratio, but there are " + first + " and " + other);
      }
    }
    return first;
  }

  private static IntBox bounds(List<ElasticSegment> segments) {
    IntBox box = new IntBox();
    segments.forEach(segment -> box.include(segment.bits().bounds()));
    if (box.isEmpty()) {
      throw new IllegalArgumentException("no elastic segment has a voxel");
    }
    return box;
  }

  private static double stiffest(List<ElasticSegment> segments) {
    double most = 0;
    for (ElasticSegment segment : segments) {
      most = Math.max(most, segment.material().youngNewtonPerMm2());
    }
    return most;
  }

  private boolean[] fixedNodes(List<BitCube> still) {
    double[] stillShare = new double[layout.nodeCount()];
    boolean[] near = new boolean[layout.cellCount()];
    List<BitCube> elastic = new ArrayList<>();
    segments.forEach(segment -> elastic.add(segment.bits()));
    for (int cell = 0; cell < near.length; cell++) {
      near[cell] = share(elastic, cell) > 0;
      double share = share(still, cell) / LatticeLayout.CORNERS;
      for (int corner = 0; corner < LatticeLayout.CORNERS; corner++) {
        stillShare[layout.firstNode(cell) + layout.cornerOffset(corner)] += share;
      }
    }
    for (int layer = 0; layer < AIR_CELLS; layer++) {
      near = grown(near);
    }
    boolean[] fixed = farNodes(near);
    for (int node = 0; node < fixed.length; node++) {
      fixed[node] |= stillShare[node] >= FIXING_SHARE || isOnRim(node);
    }
    return fixed;
  }

  private boolean[] grown(boolean[] from) {
    boolean[] grown = new boolean[from.length];
    int[] neighbours = new int[LatticeLayout.MOST_NEIGHBOURS];
    for (int cell = 0; cell < from.length; cell++) {
      int count = from[cell] ? layout.neighbours(cell, neighbours) : 0;
      for (int n = 0; n < count; n++) {
        grown[neighbours[n]] = true;
      }
    }
    return grown;
  }

  /** Returns the nodes of all cells that are not near. */
  private boolean[] farNodes(boolean[] near) {
    boolean[] far = new boolean[layout.nodeCount()];
    for (int cell = 0; cell < near.length; cell++) {
      if (!near[cell]) {
        for (int corner = 0; corner < LatticeLayout.CORNERS; corner++) {
          far[layout.firstNode(cell) + layout.cornerOffset(corner)] = true;
        }
      }
    }
    return far;
  }

  private boolean isOnRim(int node) {
    for (int axis = 0; axis < 3; axis++) {
      int index = layout.nodeIndex(axis, node);
      if (index == 0 || index == layout.cells(axis)) {
        return true;
      }
    }
    return false;
  }

  /** Returns the share of a cell's voxels that any of the cubes holds, counted for each cube. */
  private double share(List<BitCube> cubes, int cell) {
    double share = 0;
    for (int n = 0; n < cubes.size(); n++) {
      share += share(cubes.get(n), cell);
    }
    return share;
  }

  private double share(BitCube bits, int cell) {
    int x = layout.firstVoxel(0, layout.cellIndex(0, cell));
    int y = layout.firstVoxel(1, layout.cellIndex(1, cell));
    int z = layout.firstVoxel(2, layout.cellIndex(2, cell));
    int count = 0;
    for (int k = z; k < z + layout.voxelsPerCell(2); k++) {
      for (int j = y; j < y + layout.voxelsPerCell(1); j++) {
        for (int i = x; i < x + layout.voxelsPerCell(0); i++) {
          count += bits.get(i, j, k) ? 1 : 0;
        }
      }
    }
    double all = (double) layout.voxelsPerCell(0) * layout.voxelsPerCell(1);
    return count / (all * layout.voxelsPerCell(2));
  }

  /**
   * Counts the voxels of a cell anew after an edit. The modulus in use follows with {@code
   * CrushStiffening}.
   *
   * @param listed its place in the list of cells
   */
  public void refill(int listed) {
    matter.begin(cells.cell(listed));
    for (int n = 0; n < segments.size(); n++) {
      ElasticSegment segment = segments.get(n);
      matter.add(segment.bits(), segment.material().youngNewtonPerMm2());
    }
    double solid = matter.modulus();
    double air = Math.max(0, 1 - matter.share()) * airModulus;
    setSolid(listed, (float) solid);
    restModulus[listed] = (float) (solid + air);
    for (int axis = 0; axis < 3; axis++) {
      double moment = (solid * matter.moment(axis) + air) / (solid + air);
      stiffness.moment(axis)[listed] = (float) moment;
    }
  }

  private void setSolid(int listed, float modulus) {
    partsMayDiffer |= modulus > 0 != solidModulus[listed] > 0;
    solidModulus[listed] = modulus;
  }

  /**
   * Holds the parts that edits have cut off from all support at their place at rest, so that they
   * do not drift in air. Call it after edits; it does nothing if no part can differ.
   */
  public void holdFreeParts() {
    if (!partsMayDiffer) {
      return;
    }
    partsMayDiffer = false;
    freeParts = parts.find(free);
    for (int node = 0; node < free.length; node++) {
      stiffness.hold()[node] = free[node] ? springNewtonPerMm : 0;
    }
    stiffness.changed();
  }

  /** {@return the number of parts that {@link #holdFreeParts} holds} */
  public int freeParts() {
    return freeParts;
  }

  /**
   * {@return the stiffness of the matter in a listed cell; a new object}
   *
   * @param listed the place of the cell in the list
   */
  public CellStiffness stiffnessOf(int listed) {
    return new CellStiffness(
        solidModulus[listed],
        restModulus[listed],
        stiffness.moment(0)[listed],
        stiffness.moment(1)[listed],
        stiffness.moment(2)[listed]);
  }

  /**
   * Sets the stiffness of the matter in a listed cell, instead of counting its voxels.
   *
   * @param listed the place of the cell in the list
   * @param matterOfCell the stiffness, as {@link #stiffnessOf} returned it
   */
  public void refill(int listed, CellStiffness matterOfCell) {
    setSolid(listed, matterOfCell.solidModulus());
    restModulus[listed] = matterOfCell.restModulus();
    stiffness.moment(0)[listed] = matterOfCell.momentX();
    stiffness.moment(1)[listed] = matterOfCell.momentY();
    stiffness.moment(2)[listed] = matterOfCell.momentZ();
  }

  /**
   * {@return the place in the list of the cell that holds a voxel, or a negative number}
   *
   * @param i the voxel's number along x; it may lie outside the grid
   * @param j its number along y
   * @param k its number along z
   */
  public int listedCell(int i, int j, int k) {
    int x = layout.cellOfVoxel(0, i);
    int y = layout.cellOfVoxel(1, j);
    int z = layout.cellOfVoxel(2, k);
    boolean inside = x >= 0 && x < layout.cells(0) && y >= 0 && y < layout.cells(1);
    return inside && z >= 0 && z < layout.cells(2) ? cells.indexOf(layout.cell(x, y, z)) : -1;
  }

  /**
   * {@return the modulus that a listed cell has if nothing crushes it, with its air, N/mm^2}
   *
   * @param listed the place of the cell in the list
   */
  public float restModulus(int listed) {
    return restModulus[listed];
  }

  /**
   * {@return the sum of the moduli, without their air, of the cells around a node, N/mm^2}
   *
   * @param x the index of the node along x
   * @param y its index along y
   * @param z its index along z
   */
  public double solidModulusAround(int x, int y, int z) {
    double sum = 0;
    for (int corner = 0; corner < LatticeLayout.CORNERS; corner++) {
      int i = x - (corner & 1);
      int j = y - (corner >> 1 & 1);
      int k = z - (corner >> 2);
      boolean inside = i >= 0 && j >= 0 && k >= 0 && i < layout.cells(0) && j < layout.cells(1);
      int listed = inside && k < layout.cells(2) ? cells.indexOf(layout.cell(i, j, k)) : -1;
      sum += listed < 0 ? 0 : solidModulus[listed];
    }
    return sum;
  }

  /** {@return the number of voxels of the segments that deform but cannot be touched} */
  public long untouchableVoxels() {
    long count = 0;
    for (ElasticSegment segment : segments) {
      count += segment.touchable() ? 0 : segment.bits().solidCount();
    }
    return count;
  }

  /** {@return the layout} */
  public LatticeLayout layout() {
    return layout;
  }

  /** {@return the cells that can deform} */
  public ActiveCells cells() {
    return cells;
  }

  /** {@return the stiffness} */
  public StiffnessOperator stiffness() {
    return stiffness;
  }

  /**
   * Turns the cells with a displacement, so that the stiffness is that of the present shape.
   *
   * @param displacement three numbers for each node, mm
   */
  public void rotate(float[] displacement) {
    stiffness.rotate(displacement);
    preconditioner.refresh(displacement);
  }

  /** {@return a solver; {@link #rotate} must come before its first solution} */
  public ConjugateGradients newSolver() {
    return new ConjugateGradients(stiffness, preconditioner);
  }
}
