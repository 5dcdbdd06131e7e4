package org.palpate.elastic.lattice;

import java.util.List;

/**
 * The matter in the listed cells of a lattice, and the stiffness that follows from it. A cell has
 * the mean modulus of its voxels, in which air counts with 1e-8 of the stiffest segment, and their
 * second moments.
 *
 * <p>Moduli follow edits of the voxels, see {@link #refill}. One thread, the one that solves;
 * allocates nothing after construction.
 */
public final class LatticeMatter {
  /** Small enough that a plate of two voxels bends nearly as freely as without air. */
  private static final double AIR_PER_SOLID = 1e-8;

  /**
   * The stiffness of the springs that hold a part without support, over that of a cell of the
   * stiffest segment.
   */
  private static final double HOLD_PER_CELL = 10;

  private final List<ElasticSegment> segments;
  private final ActiveCells cells;
  private final double airModulus;
  private final float[] restModulus;
  private final float[] solidModulus;
  private final CellMatter matter;
  private final float[] counted = new float[5];
  private final StiffnessOperator stiffness;
  private final boolean[] free;
  private final float springNewtonPerMm;
  private FreeParts parts;
  private int freeParts;

  /** Whether matter came into an empty cell, or all matter left one, since the last search. */
  private boolean partsMayDiffer;

  /**
   * Counts the voxels of all cells.
   *
   * @param segments those that deform
   * @param poisson Poisson's ratio of all segments
   */
  LatticeMatter(ActiveCells cells, List<ElasticSegment> segments, double poisson) {
    this.cells = cells;
    this.segments = segments;
    double stiffest = stiffest(segments);
    airModulus = AIR_PER_SOLID * stiffest;
    restModulus = new float[cells.count()];
    solidModulus = new float[cells.count()];
    stiffness = new StiffnessOperator(cells, poisson);
    matter = new CellMatter(cells.layout());
    free = new boolean[cells.layout().nodeCount()];
    springNewtonPerMm = (float) (HOLD_PER_CELL * stiffest * cells.layout().longestEdgeMm());
    for (int n = 0; n < cells.count(); n++) {
      refill(n);
    }
    System.arraycopy(restModulus, 0, stiffness.modulus(), 0, restModulus.length);
    stiffness.changed();
    parts = new FreeParts(cells, solidModulus);
    partsMayDiffer = false;
  }

  private static double stiffest(List<ElasticSegment> segments) {
    double most = 0;
    for (ElasticSegment segment : segments) {
      most = Math.max(most, segment.material().youngNewtonPerMm2());
    }
    return most;
  }

  /**
   * Counts the voxels of a cell anew after an edit. The modulus in use approaches the new one in
   * the next updates.
   *
   * @param listed its place in the list of cells
   */
  public void refill(int listed) {
    matter.begin(cells.cell(listed));
    count();
    setSolid(listed, counted[0]);
    restModulus[listed] = counted[1];
    for (int axis = 0; axis < 3; axis++) {
      stiffness.moment(axis)[listed] = counted[2 + axis];
    }
  }

  /**
   * Returns the stiffness of the matter in a cell anywhere; a new object.
   *
   * @param x the first voxel of the cell along x
   * @param y the same along y
   * @param z the same along z
   */
  CellStiffness stiffnessAt(int x, int y, int z) {
    matter.begin(x, y, z);
    count();
    return new CellStiffness(counted[0], counted[1], counted[2], counted[3], counted[4]);
  }

  /** Counts the voxels of the cell that was begun, in the order of {@link CellStiffness}. */
  private void count() {
    for (int n = 0; n < segments.size(); n++) {
      ElasticSegment segment = segments.get(n);
      matter.add(segment.bits(), segment.material().youngNewtonPerMm2());
    }
    double solid = matter.modulus();
    double air = Math.max(0, 1 - matter.share()) * airModulus;
    counted[0] = (float) solid;
    counted[1] = (float) (solid + air);
    for (int axis = 0; axis < 3; axis++) {
      counted[2 + axis] = (float) ((solid * matter.moment(axis) + air) / (solid + air));
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

  /** Lets {@link #holdFreeParts} search again, and hold parts that never had support too. */
  void holdEveryFreePart() {
    parts = FreeParts.ofAll(cells, solidModulus);
    partsMayDiffer = true;
  }

  /** Lets the next {@link #holdFreeParts} search again, because other nodes are fixed. */
  void supportsDiffer() {
    partsMayDiffer = true;
  }

  /** Returns the number of parts that {@link #holdFreeParts} holds. */
  int freeParts() {
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
    LatticeLayout layout = cells.layout();
    double sum = 0;
    for (int corner = 0; corner < LatticeLayout.CORNERS; corner++) {
      int cell = layout.cellOrNone(x - (corner & 1), y - (corner >> 1 & 1), z - (corner >> 2));
      int listed = cell < 0 ? -1 : cells.indexOf(cell);
      sum += listed < 0 ? 0 : solidModulus[listed];
    }
    return sum;
  }

  /** {@return the cells that can deform} */
  public ActiveCells cells() {
    return cells;
  }

  /** {@return the stiffness} */
  public StiffnessOperator stiffness() {
    return stiffness;
  }
}
