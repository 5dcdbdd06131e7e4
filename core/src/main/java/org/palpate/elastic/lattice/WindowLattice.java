package org.palpate.elastic.lattice;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.palpate.volume.BitCube;

/**
 * A box of shorter cells inside a lattice, which moves with a contact. It covers whole cells of the
 * lattice. {@link LatticeMatter} has the stiffness of its cells.
 *
 * <p>Nodes on the rim of the box are fixed, and as in the lattice those at segments that stand
 * still. One thread, the one that solves; allocates nothing after construction.
 */
public final class WindowLattice {
  /** The least distance of a contact from a side inside the lattice, over the contact's radius. */
  private static final double REACH = 2;

  /**
   * The window stays while its middle is no farther from the contact than this along each axis, in
   * cells of the whole lattice.
   */
  private static final double NEAR_CELLS = 0.75;

  private final LatticeLayout whole;
  private final int factor;
  private final LatticeLayout layout;

  /** The segments with their present voxels. */
  private final List<ElasticSegment> segments;

  /** The segments with the voxels that were read last. */
  private final List<ElasticSegment> counted;

  private final StillNodes stillNodes;
  private final ActiveCells cells;
  private final LatticeMatter matter;
  private final MultigridPreconditioner preconditioner;
  private final boolean[] fixed;

  /** The first cell of the whole lattice in the window, along each axis. */
  private final int[] firstCell = new int[3];

  /** The last move, in cells of the whole lattice. */
  private final int[] move = new int[3];

  /** The modulus in use over that at rest, of each cell. */
  private final float[] crushed;

  private final float[] scratch;

  /** By cell of the whole lattice, the stiffness of its parts that was set; null for most. */
  private final CellStiffness[][] edited;

  /**
   * Creates a window at the first cells of a lattice.
   *
   * @param whole the lattice
   * @param factor the number of its cells along the edge of a cell of the lattice, 2 or 4
   * @param radiusMm the radius of the contact
   * @param segments those that deform
   * @param still the voxels of those that stand still
   * @param poisson Poisson's ratio of the segments
   */
  WindowLattice(
      LatticeLayout whole,
      int factor,
      double radiusMm,
      List<ElasticSegment> segments,
      List<BitCube> still,
      double poisson) {
    this.whole = whole;
    this.factor = factor;
    int[] size = new int[3];
    for (int axis = 0; axis < 3; axis++) {
      int toSide = (int) Math.ceil(REACH * radiusMm / whole.edgeMm(axis) + NEAR_CELLS);
      size[axis] = Math.min(2 * toSide, whole.cells(axis));
    }
    layout = whole.window(size, factor);
    this.segments = List.copyOf(segments);
    counted = copiesOf(segments);
    stillNodes = new StillNodes(layout, copies(still));
    edited = new CellStiffness[whole.cellCount()][];
    fixed = new boolean[layout.nodeCount()];
    fixRim();
    cells = new ActiveCells(layout, fixed.clone()); // Lists every cell, wherever the window is.
    matter = new LatticeMatter(cells, counted, poisson);
    matter.holdEveryFreePart();
    preconditioner = new MultigridPreconditioner(matter.stiffness(), poisson);
    crushed = new float[cells.count()];
    Arrays.fill(crushed, 1);
    scratch = new float[layout.nodeCount()];
    take();
  }

  /** Copies voxels, so that edits do not change which nodes are fixed. */
  private static List<BitCube> copies(List<BitCube> cubes) {
    List<BitCube> copies = new ArrayList<>();
    for (BitCube each : cubes) {
      copies.add(each.copy());
    }
    return copies;
  }

  private static List<ElasticSegment> copiesOf(List<ElasticSegment> segments) {
    List<ElasticSegment> copies = new ArrayList<>();
    for (ElasticSegment each : segments) {
      copies.add(each.copy());
    }
    return copies;
  }

  private void fixRim() {
    for (int node = 0; node < fixed.length; node++) {
      fixed[node] = layout.isOnRim(node);
    }
  }

  /**
   * Moves the window so that a contact stands in its middle, unless it stands near enough.
   *
   * @param at the contact, in cells of the whole lattice
   * @return whether it moved; then {@link #shift} carries vectors along
   */
  public boolean moveTo(double[] at) {
    boolean moved = false;
    for (int axis = 0; axis < 3; axis++) {
      int size = layout.cells(axis) / factor;
      double first = at[axis] - size / 2.0;
      int next = firstCell[axis];
      if (!(Math.abs(first - next) <= NEAR_CELLS)) {
        next = (int) Math.max(0, Math.min(whole.cells(axis) - size, Math.rint(first)));
      }
      move[axis] = next - firstCell[axis];
      firstCell[axis] = next;
      moved |= move[axis] != 0;
    }
    if (moved) {
      layout.moveTo(whole, firstCell);
      carryCrushed();
      for (int cell = 0; cell < cells.count(); cell++) {
        refillListed(cell);
      }
      take();
    }
    return moved;
  }

  /** Sets what depends on the place: the moduli in use, and the nodes that stand still. */
  private void take() {
    float[] modulus = matter.stiffness().modulus();
    for (int cell = 0; cell < modulus.length; cell++) {
      modulus[cell] = crushed[cell] * matter.restModulus(cell);
    }
    fixRim();
    stillNodes.fix(fixed);
    cells.fix(fixed);
    matter.supportsDiffer();
    matter.stiffness().changed();
    preconditioner.fixedNodesDiffer();
  }

  /** Carries along how much stiffer the cells are because they were crushed. */
  private void carryCrushed() {
    float[] modulus = matter.stiffness().modulus();
    // The rest moduli are still those of the place before.
    for (int cell = 0; cell < modulus.length; cell++) {
      scratch[cell] = modulus[cell] / matter.restModulus(cell);
    }
    for (int cell = 0; cell < crushed.length; cell++) {
      int from = from(cell, 0);
      crushed[cell] = from < 0 ? 1 : scratch[from];
    }
  }

  /**
   * Returns the number before the move of a cell or node, or a negative number if it lay outside.
   *
   * @param more how many more nodes than cells there are along an axis, 1 for a node and 0 for a
   *     cell
   */
  private int from(int number, int more) {
    int nx = layout.cells(0) + more;
    int ny = layout.cells(1) + more;
    int nz = layout.cells(2) + more;
    int x = number % nx + factor * move[0];
    int y = number / nx % ny + factor * move[1];
    int z = number / nx / ny + factor * move[2];
    boolean inside = x >= 0 && y >= 0 && z >= 0 && x < nx && y < ny && z < nz;
    return inside ? x + nx * (y + ny * z) : -1;
  }

  /**
   * Carries a vector along with the last move: each node takes the entries of the node that stood
   * in its place, and zero if there was none.
   *
   * @param vector three numbers for each node, in place
   */
  public void shift(float[] vector) {
    int nodes = scratch.length;
    for (int axis = 0; axis < 3; axis++) {
      System.arraycopy(vector, axis * nodes, scratch, 0, nodes);
      for (int node = 0; node < nodes; node++) {
        int from = from(node, 1);
        vector[axis * nodes + node] = from < 0 ? 0 : scratch[from];
      }
    }
  }

  /** Returns the number of short cells in a cell of the whole lattice. */
  int parts() {
    return factor * factor * factor;
  }

  /**
   * Counts the voxels anew in the cells that lie in a cell of the whole lattice. A move counts what
   * this has read, and nothing that was edited since. So the updates of a recorded session repeat
   * to the bit, though a replay may edit voxels before it computes an update that did not see the
   * edit.
   */
  void refill(int wholeCell) {
    readVoxels(wholeCell);
    for (int part = 0; part < parts(); part++) {
      int listed = listed(wholeCell, part);
      if (listed >= 0) {
        matter.refill(listed);
      }
    }
  }

  /** Reads the voxels of all segments in a cell of the whole lattice. */
  private void readVoxels(int wholeCell) {
    for (int n = 0; n < segments.size(); n++) {
      readVoxels(segments.get(n).bits(), wholeCell, counted.get(n).bits());
    }
  }

  private void readVoxels(BitCube from, int wholeCell, BitCube dest) {
    int x = firstVoxel(0, wholeCell, 0);
    int y = firstVoxel(1, wholeCell, 0);
    int z = firstVoxel(2, wholeCell, 0);
    for (int k = z; k < z + whole.voxelsPerCell(2); k++) {
      for (int j = y; j < y + whole.voxelsPerCell(1); j++) {
        for (int i = x; i < x + whole.voxelsPerCell(0); i++) {
          boolean solid = from.get(i, j, k);
          if (solid && !dest.get(i, j, k)) {
            dest.set(i, j, k);
          } else if (!solid && dest.get(i, j, k)) {
            dest.clear(i, j, k);
          }
        }
      }
    }
  }

  /**
   * Returns what the voxels that were read make in a part of a cell of the whole lattice; a new
   * object.
   */
  CellStiffness stiffnessAt(int wholeCell, int part) {
    return matter.stiffnessAt(
        firstVoxel(0, wholeCell, part),
        firstVoxel(1, wholeCell, part),
        firstVoxel(2, wholeCell, part));
  }

  /** Sets the stiffness of a part of a cell of the whole lattice, wherever the window goes. */
  void refill(int wholeCell, int part, CellStiffness stiffness) {
    if (edited[wholeCell] == null) {
      edited[wholeCell] = new CellStiffness[parts()];
    }
    edited[wholeCell][part] = stiffness;
    int listed = listed(wholeCell, part);
    if (listed >= 0) {
      matter.refill(listed, stiffness);
    }
  }

  private int firstVoxel(int axis, int wholeCell, int part) {
    int first = whole.firstVoxel(axis, whole.cellIndex(axis, wholeCell));
    return first + index(axis, part) * layout.voxelsPerCell(axis);
  }

  /** Returns the index of a part along an axis, in a cell of the whole lattice. */
  private int index(int axis, int part) {
    return switch (axis) {
      case 0 -> part % factor;
      case 1 -> part / factor % factor;
      default -> part / factor / factor;
    };
  }

  /** Returns the place in the list of a part of a cell of the whole lattice, or -1. */
  private int listed(int wholeCell, int part) {
    int cell =
        layout.cellOrNone(
            index(0, wholeCell, part), index(1, wholeCell, part), index(2, wholeCell, part));
    return cell < 0 ? -1 : cells.indexOf(cell);
  }

  private int index(int axis, int wholeCell, int part) {
    return factor * (whole.cellIndex(axis, wholeCell) - firstCell[axis]) + index(axis, part);
  }

  /** Fills a cell of the list by what was set for its place, or else by its voxels. */
  private void refillListed(int listed) {
    int cell = cells.cell(listed);
    int x = layout.cellIndex(0, cell);
    int y = layout.cellIndex(1, cell);
    int z = layout.cellIndex(2, cell);
    int wholeCell =
        whole.cell(firstCell[0] + x / factor, firstCell[1] + y / factor, firstCell[2] + z / factor);
    int part = x % factor + factor * (y % factor + factor * (z % factor));
    CellStiffness set = edited[wholeCell] == null ? null : edited[wholeCell][part];
    if (set == null) {
      matter.refill(listed);
    } else {
      matter.refill(listed, set);
    }
  }

  /**
   * Adds the forces of the springs that hold parts without support, so that they hold them at a
   * displacement instead of at rest.
   *
   * @param displacement three numbers for each node, mm
   * @param dest three numbers for each node, N; changed in place
   */
  public void addHold(float[] displacement, float[] dest) {
    matter.stiffness().addSprings(displacement, dest);
  }

  /**
   * {@return the first cell of the whole lattice in the window}
   *
   * @param axis 0 for x, 1 for y, 2 for z
   */
  public int firstCell(int axis) {
    return firstCell[axis];
  }

  /** {@return the number of cells along the edge of a cell of the whole lattice} */
  public int factor() {
    return factor;
  }

  /** {@return the layout; its place in the grid changes with the window} */
  public LatticeLayout layout() {
    return layout;
  }

  /** {@return the matter in the cells} */
  public LatticeMatter matter() {
    return matter;
  }

  /** {@return a solver; {@link ConjugateGradients#rotate} must come before its first solution} */
  public ConjugateGradients newSolver() {
    return new ConjugateGradients(matter.stiffness(), preconditioner);
  }
}
