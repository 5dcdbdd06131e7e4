package org.palpate.elastic.lattice;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.IntBox;
import org.palpate.volume.BitCube;

/**
 * The lattice over elastic segments and some air around them. {@link LatticeMatter} has the
 * stiffness of its cells.
 *
 * <p>Nodes are fixed on the rim of the lattice, far from elastic voxels, and where at least a fifth
 * of the voxels around them belongs to a segment that stands still.
 *
 * <p>Moduli follow edits of the voxels; which nodes are fixed does not. One thread, the one that
 * solves; allocates nothing after construction.
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

  /**
   * The usual radius of a contact over the longest edge of a cell, and the least in a window. With
   * a smaller one, the hand would feel the cells.
   */
  private static final double RADIUS_EDGES = 2;

  /** The most cells of a window along the edge of a cell. */
  private static final int MOST_FACTOR = 4;

  private final LatticeLayout layout;
  private final List<ElasticSegment> segments;
  private final ActiveCells cells;
  private final LatticeMatter matter;
  private final MultigridPreconditioner preconditioner;
  private final Optional<WindowLattice> window;
  private final double contactRadiusMm;

  /**
   * Creates a lattice without a window, for a contact of the usual radius.
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
    this(metric, segments, still, edgeMm, OptionalDouble.empty());
  }

  /**
   * Creates a lattice for a contact of any radius; otherwise as the other constructor.
   *
   * @param metric the spacing of the grid
   * @param segments those that deform, with one Poisson's ratio, at least one voxel in all
   * @param still the voxels of the segments that stand still
   * @param edgeMm the edge of a cell, mm; rounded to whole voxels, and in a lattice with a window
   *     to whole voxels of the window's cells
   * @param radiusMm the radius of the contact, mm. If it is less than two cells, a window with
   *     cells of half or a quarter of the edge follows the contact.
   * @throws IllegalArgumentException if there is no voxel, the ratios differ, there would be too
   *     many cells, or the radius is less than half a cell
   */
  public ControlLattice(
      GridMetric metric,
      List<ElasticSegment> segments,
      List<BitCube> still,
      double edgeMm,
      OptionalDouble radiusMm) {
    this.segments = List.copyOf(segments);
    double poisson = commonPoisson(segments);
    int factor = 1;
    LatticeLayout whole = layout(metric, edgeMm, factor);
    if (radiusMm.isPresent()) {
      double radius = radiusMm.getAsDouble();
      while (RADIUS_EDGES * whole.longestEdgeMm() > factor * radius) {
        factor *= 2;
        if (factor > MOST_FACTOR) {
          throw new IllegalArgumentException(
              "a contact of " + radius + " mm needs cells of at most twice its radius");
        }
        whole = layout(metric, edgeMm, factor);
      }
    }
    layout = whole;
    contactRadiusMm = radiusMm.orElse(RADIUS_EDGES * layout.longestEdgeMm());
    cells = new ActiveCells(layout, fixedNodes(still));
    matter = new LatticeMatter(cells, this.segments, poisson);
    preconditioner = new MultigridPreconditioner(matter.stiffness(), poisson);
    window =
        factor == 1
            ? Optional.empty()
            : Optional.of(
                new WindowLattice(
                    layout, factor, contactRadiusMm, this.segments, List.copyOf(still), poisson));
  }

  private LatticeLayout layout(GridMetric metric, double edgeMm, int divisor) {
    IntBox box = bounds(segments);
    return LatticeLayout.around(box, metric, edgeMm, CELL_MULTIPLE, CELL_MULTIPLE, divisor);
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

  private boolean[] fixedNodes(List<BitCube> still) {
    boolean[] near = new boolean[layout.cellCount()];
    List<BitCube> elastic = new ArrayList<>();
    segments.forEach(segment -> elastic.add(segment.bits()));
    for (int cell = 0; cell < near.length; cell++) {
      near[cell] = StillNodes.share(layout, elastic, cell) > 0;
    }
    for (int layer = 0; layer < AIR_CELLS; layer++) {
      near = grown(near);
    }
    boolean[] fixed = farNodes(near);
    for (int node = 0; node < fixed.length; node++) {
      fixed[node] |= layout.isOnRim(node);
    }
    new StillNodes(layout, still).fix(fixed);
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

  /** Receives cells that were counted anew. */
  public interface RefillSink {
    /**
     * Takes a cell.
     *
     * @param number its number, for {@link ControlLattice#refill(int, CellStiffness)}
     * @param stiffness the stiffness of its matter
     */
    void take(int number, CellStiffness stiffness);
  }

  /**
   * Counts the voxels of a cell anew after an edit, and those of short cells in it.
   *
   * @param edited its number by {@link #editedCell}
   */
  public void refill(int edited) {
    int listed = window.isPresent() ? cells.indexOf(edited) : edited;
    if (listed >= 0) {
      matter.refill(listed);
    }
    if (window.isPresent()) {
      window.get().refill(edited);
    }
  }

  /**
   * Counts the voxels of a cell anew after an edit, and those of short cells in it. Allocates.
   *
   * @param edited its number by {@link #editedCell}
   * @param sink receives them
   */
  public void refill(int edited, RefillSink sink) {
    int listed = window.isPresent() ? cells.indexOf(edited) : edited;
    if (listed >= 0) {
      matter.refill(listed);
      sink.take(listed, matter.stiffnessOf(listed));
    }
    if (window.isPresent()) {
      WindowLattice inWindow = window.get();
      inWindow.refill(edited);
      for (int part = 0; part < inWindow.parts(); part++) {
        int number = cells.count() + inWindow.parts() * edited + part;
        sink.take(number, inWindow.stiffnessAt(edited, part));
      }
    }
  }

  /**
   * Sets the stiffness of the matter in a cell, instead of counting its voxels.
   *
   * @param number the number with which a sink received it
   * @param stiffness the stiffness that the sink received
   */
  public void refill(int number, CellStiffness stiffness) {
    if (number < cells.count()) {
      matter.refill(number, stiffness);
    } else {
      int inWindow = number - cells.count();
      int parts = window.orElseThrow().parts();
      window.get().refill(inWindow / parts, inWindow % parts, stiffness);
    }
  }

  /** {@return the number of cells that a sink can receive} */
  public int refillCells() {
    return cells.count() + window.map(w -> w.parts() * layout.cellCount()).orElse(0);
  }

  /** {@return one more than the largest number of a cell by {@link #editedCell}} */
  public int editedCells() {
    return window.isPresent() ? layout.cellCount() : cells.count();
  }

  /**
   * {@return the number of the cell that holds a voxel, for {@link #refill(int)}, or a negative
   * number if edits there change nothing} Without a window it is the place in the list.
   *
   * @param i the voxel's number along x; it may lie outside the grid
   * @param j its number along y
   * @param k its number along z
   */
  public int editedCell(int i, int j, int k) {
    int cell = cellOfVoxel(i, j, k);
    return cell < 0 || window.isPresent() ? cell : cells.indexOf(cell);
  }

  private int cellOfVoxel(int i, int j, int k) {
    return layout.cellOrNone(
        layout.cellOfVoxel(0, i), layout.cellOfVoxel(1, j), layout.cellOfVoxel(2, k));
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

  /** {@return the matter in the cells} */
  public LatticeMatter matter() {
    return matter;
  }

  /** {@return the number of parts that edits have cut off from all support} */
  public int freeParts() {
    return matter.freeParts();
  }

  /** {@return the window around the contact, if its radius needs one} */
  public Optional<WindowLattice> window() {
    return window;
  }

  /** {@return the radius over which the force of a contact is spread, mm} */
  public double contactRadiusMm() {
    return contactRadiusMm;
  }

  /** {@return a solver; {@link ConjugateGradients#rotate} must come before its first solution} */
  public ConjugateGradients newSolver() {
    return new ConjugateGradients(matter.stiffness(), preconditioner);
  }
}
