package org.palpate.elastic.lattice;

import java.util.Arrays;

/**
 * The stiffness of a lattice as an operator on vectors of its nodes, without an assembled matrix.
 * Each listed cell has a modulus and a rotation. The entries of fixed nodes come out as zero.
 *
 * <p>Cells are handled in tiles that stay in the first-level cache, see {@link CellModes}. Corners
 * are copied in runs of cells that follow one another along x.
 *
 * <p>Reference: Müller, Dorsey, McMillan, Jagnow, Cutler 2002, "Stable real-time deformations". One
 * thread; allocates nothing after construction.
 */
public final class StiffnessOperator {
  private final ActiveCells cells;
  private final int nodes;
  private final float[] modulus;
  private final float[][] moment = new float[3][];

  /** The stiffness of a spring between each node and its place at rest, N/mm. */
  private final float[] hold;

  private boolean holds;
  private final CellRotations rotations;
  private final InverseDiagonal diagonal;
  private final CellModes tile;

  /** The first cells of the runs, and the number of cells at the end. */
  private final int[] runs;

  /**
   * Creates an operator of cells at rest whose moduli are zero.
   *
   * @param poisson Poisson's ratio of all cells
   */
  StiffnessOperator(ActiveCells cells, double poisson) {
    this.cells = cells;
    nodes = cells.layout().nodeCount();
    modulus = new float[cells.count()];
    for (int axis = 0; axis < 3; axis++) {
      moment[axis] = new float[cells.count()];
      Arrays.fill(moment[axis], 1);
    }
    hold = new float[nodes];
    rotations = new CellRotations(cells);
    diagonal = new InverseDiagonal(cells, HexahedronStiffness.of(poisson, cells.layout()));
    tile = new CellModes(poisson, cells.layout());
    runs = runs(cells);
  }

  /** Finds runs: cells of one tile whose nodes follow one another. */
  private static int[] runs(ActiveCells cells) {
    int[] begins = new int[cells.count() + 1];
    int count = 0;
    for (int n = 0; n < cells.count(); n++) {
      if (n % CellModes.TILE == 0 || cells.firstNode(n) != cells.firstNode(n - 1) + 1) {
        begins[count++] = n;
      }
    }
    begins[count] = cells.count();
    return Arrays.copyOf(begins, count + 1);
  }

  /** {@return the cells} */
  public ActiveCells cells() {
    return cells;
  }

  /** {@return Young's modulus of each listed cell, N/mm^2, to change before {@link #changed}} */
  public float[] modulus() {
    return modulus;
  }

  /**
   * {@return the second moment of the matter of each listed cell along an axis, over that of a full
   * cell}
   *
   * @param axis 0 for x, 1 for y, 2 for z
   */
  public float[] moment(int axis) {
    return moment[axis];
  }

  /**
   * Returns the stiffness of a spring that holds each node at its place at rest, N/mm, to change
   * before {@link #changed}. Zero for most.
   */
  float[] hold() {
    return hold;
  }

  /** Takes moduli and springs over after a change. */
  public void changed() {
    diagonal.update(modulus, hold);
    holds = false;
    for (float spring : hold) {
      holds |= spring > 0;
    }
  }

  InverseDiagonal diagonal() {
    return diagonal;
  }

  /**
   * Takes the rotations of the cells from displacements.
   *
   * @param displacement three numbers for each node, mm
   */
  public void rotate(float[] displacement) {
    rotations.update(displacement);
  }

  /**
   * Writes the stiffness times a displacement.
   *
   * @param displacement three numbers for each node, mm
   * @param dest receives three numbers for each node, N; another array
   */
  public void multiply(float[] displacement, float[] dest) {
    apply(displacement, dest, false);
  }

  /**
   * Writes the elastic forces at a displacement: none if nothing is strained.
   *
   * @param displacement three numbers for each node, mm
   * @param dest receives three numbers for each node, N; another array
   */
  public void force(float[] displacement, float[] dest) {
    apply(displacement, dest, true);
  }

  private void apply(float[] from, float[] dest, boolean fromRest) {
    Arrays.fill(dest, 0);
    int run = 0;
    for (int first = 0; first < cells.count(); first += CellModes.TILE) {
      int count = Math.min(CellModes.TILE, cells.count() - first);
      System.arraycopy(modulus, first, tile.modulus, 0, count);
      for (int axis = 0; axis < 3; axis++) {
        System.arraycopy(moment[axis], first, tile.moment[axis], 0, count);
      }
      for (int entry = 0; entry < 9; entry++) {
        System.arraycopy(rotations.entries[entry], first, tile.rotation[entry], 0, count);
      }
      int end = run;
      for (; runs[end] < first + count; end++) {
        gather(from, runs[end], runs[end + 1], first);
      }
      tile.multiply(count, fromRest);
      for (; run < end; run++) {
        scatter(runs[run], runs[run + 1], first, dest);
      }
    }
    if (holds) {
      addSprings(from, dest);
    }
    clearFixed(dest);
  }

  private void addSprings(float[] from, float[] dest) {
    for (int axis = 0; axis < 3; axis++) {
      int at = axis * nodes;
      for (int node = 0; node < nodes; node++) {
        dest[at + node] += hold[node] * from[at + node];
      }
    }
  }

  /** Copies the corners of a run of cells into the tile that begins with a cell. */
  private void gather(float[] from, int begin, int end, int tileBegin) {
    int node = cells.firstNode(begin);
    for (int axis = 0; axis < 3; axis++) {
      for (int corner = 0; corner < LatticeLayout.CORNERS; corner++) {
        int at = axis * nodes + node + cells.layout().cornerOffset(corner);
        System.arraycopy(from, at, tile.values[axis][corner], begin - tileBegin, end - begin);
      }
    }
  }

  /** Adds the forces of a run of cells. */
  private void scatter(int begin, int end, int tileBegin, float[] dest) {
    int node = cells.firstNode(begin);
    for (int axis = 0; axis < 3; axis++) {
      for (int corner = 0; corner < LatticeLayout.CORNERS; corner++) {
        int at = axis * nodes + node + cells.layout().cornerOffset(corner);
        add(tile.values[axis][corner], begin - tileBegin, end - begin, dest, at);
      }
    }
  }

  private static void add(float[] from, int first, int count, float[] dest, int at) {
    for (int n = 0; n < count; n++) {
      dest[at + n] += from[first + n];
    }
  }

  private void clearFixed(float[] dest) {
    for (int node = 0; node < nodes; node++) {
      if (cells.isFixed(node)) {
        dest[node] = 0;
        dest[nodes + node] = 0;
        dest[2 * nodes + node] = 0;
      }
    }
  }
}
