package org.palpate.elastic.lattice;

import java.util.Arrays;

/**
 * The stiffness of a lattice as an operator on vectors of its nodes, without an assembled matrix.
 * Each listed cell has a modulus and a rotation. The entries of fixed nodes come out as zero.
 *
 * <p>Cells are handled in tiles that stay in the cache, see {@link CellModes}. Corners are copied
 * in runs of {@link CellSlots}.
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

  private final CellSlots slots;

  /** By slot, zero where a slot has no cell: the modulus, the moments and the rotations. */
  private final float[] slotModulus;

  private final float[][] slotMoment = new float[3][];
  private final float[][] slotRotation = new float[9][];

  /** The forces so far at one corner of the slots of a tile. */
  private final float[] sums = new float[CellModes.TILE];

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
    slots = new CellSlots(cells, CellModes.TILE);
    slotModulus = new float[slots.count()];
    for (int axis = 0; axis < 3; axis++) {
      slotMoment[axis] = new float[slots.count()];
    }
    for (int entry = 0; entry < 9; entry++) {
      slotRotation[entry] = new float[slots.count()];
    }
    spreadRotations();
    spreadMoments();
  }

  private void spreadMoments() {
    for (int axis = 0; axis < 3; axis++) {
      slots.spread(moment[axis], slotMoment[axis]);
    }
  }

  private void spreadRotations() {
    for (int entry = 0; entry < 9; entry++) {
      slots.spread(rotations.entries[entry], slotRotation[entry]);
    }
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
   * cell; to change before {@link #changed} or {@link #rotate}}
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

  /** Takes moduli, moments and springs over after a change. */
  public void changed() {
    slots.spread(modulus, slotModulus);
    spreadMoments();
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
   * Finds the rotations of the cells from displacements, and takes over their moments, which edits
   * change.
   *
   * @param displacement three numbers for each node, mm
   */
  public void rotate(float[] displacement) {
    rotations.update(displacement);
    spreadRotations();
    spreadMoments();
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
    for (int first = 0; first < slots.count(); first += CellModes.TILE) {
      int count = Math.min(CellModes.TILE, slots.count() - first);
      readCells(first, count);
      int end = run;
      for (; end < slots.runs() && slots.begin(end) < first + count; end++) {
        gather(from, end, first);
      }
      tile.multiply(count, fromRest);
      scatter(run, end, first, dest);
      run = end;
    }
    if (holds) {
      addSprings(from, dest);
    }
    clearFixed(dest);
  }

  /** Adds the stiffness of the springs of {@link #hold} times a displacement. */
  void addSprings(float[] from, float[] dest) {
    for (int axis = 0; axis < 3; axis++) {
      int at = axis * nodes;
      for (int node = 0; node < nodes; node++) {
        dest[at + node] += hold[node] * from[at + node];
      }
    }
  }

  private void readCells(int first, int count) {
    System.arraycopy(slotModulus, first, tile.modulus, 0, count);
    for (int axis = 0; axis < 3; axis++) {
      System.arraycopy(slotMoment[axis], first, tile.moment[axis], 0, count);
    }
    for (int entry = 0; entry < 9; entry++) {
      System.arraycopy(slotRotation[entry], first, tile.rotation[entry], 0, count);
    }
  }

  /** Copies the corners of a run into the tile that begins with a slot. */
  private void gather(float[] from, int run, int tileBegin) {
    int begin = slots.begin(run) - tileBegin;
    int count = slots.begin(run + 1) - slots.begin(run);
    for (int axis = 0; axis < 3; axis++) {
      for (int corner = 0; corner < LatticeLayout.CORNERS; corner++) {
        int at = axis * nodes + slots.node(run) + cells.layout().cornerOffset(corner);
        System.arraycopy(from, at, tile.values[axis][corner], begin, count);
      }
    }
  }

  /**
   * Adds the forces of the runs of a tile, one corner after the other. All slots of a tile have
   * different nodes at a corner. So the forces so far at these nodes are copied, summed for the
   * whole tile in one loop, which becomes vector code, and copied back.
   */
  private void scatter(int firstRun, int endRun, int tileBegin, float[] dest) {
    int count = slots.begin(endRun) - tileBegin;
    for (int axis = 0; axis < 3; axis++) {
      for (int corner = 0; corner < LatticeLayout.CORNERS; corner++) {
        int at = axis * nodes + cells.layout().cornerOffset(corner);
        for (int run = firstRun; run < endRun; run++) {
          int begin = slots.begin(run);
          int size = slots.begin(run + 1) - begin;
          System.arraycopy(dest, at + slots.node(run), sums, begin - tileBegin, size);
        }
        add(tile.values[axis][corner], count, sums);
        for (int run = firstRun; run < endRun; run++) {
          int begin = slots.begin(run);
          int size = slots.begin(run + 1) - begin;
          System.arraycopy(sums, begin - tileBegin, dest, at + slots.node(run), size);
        }
      }
    }
  }

  private static void add(float[] from, int count, float[] dest) {
    for (int n = 0; n < count; n++) {
      dest[n] += from[n];
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
