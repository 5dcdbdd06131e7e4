package org.palpate.elastic.lattice;

import java.util.Arrays;

/**
 * The stiffness of a lattice as an operator on vectors of its nodes, without an assembled matrix.
 * Each listed cell has a modulus and a rotation. The entries of fixed nodes come out as zero.
 *
 * <p>Cells are handled in tiles that stay in the first-level cache. The loops over a tile, with
 * four columns at a time, are those that the compiler of JDK 17 turns into vector code.
 *
 * <p>Reference: Müller, Dorsey, McMillan, Jagnow, Cutler 2002, "Stable real-time deformations". One
 * thread; allocates nothing after construction.
 */
public final class StiffnessOperator {
  private static final int TILE = 128;
  private static final int SIZE = HexahedronStiffness.SIZE;

  private final ActiveCells cells;
  private final int nodes;
  private final float[] element;
  private final float[] modulus;
  private final CellRotations rotations;
  private final InverseDiagonal diagonal;
  private final float[] x = new float[TILE];
  private final float[] y = new float[TILE];
  private final float[] z = new float[TILE];
  private final float[][] in = new float[SIZE][TILE];
  private final float[][] out = new float[SIZE][TILE];
  private final float[][] r = new float[9][TILE];

  /**
   * Creates an operator of cells at rest whose moduli are zero.
   *
   * @param poisson Poisson's ratio of all cells
   */
  StiffnessOperator(ActiveCells cells, double poisson) {
    this.cells = cells;
    nodes = cells.layout().nodeCount();
    element = HexahedronStiffness.of(poisson, cells.layout());
    modulus = new float[cells.count()];
    rotations = new CellRotations(cells);
    diagonal = new InverseDiagonal(cells, element);
  }

  /** Returns the cells. */
  public ActiveCells cells() {
    return cells;
  }

  /** Returns Young's modulus of each listed cell, N/mm^2, to change before {@link #changed}. */
  public float[] modulus() {
    return modulus;
  }

  /** Takes the moduli over after a change. */
  public void changed() {
    diagonal.update(modulus);
  }

  InverseDiagonal diagonal() {
    return diagonal;
  }

  /** Takes the rotations of the cells from displacements, mm. */
  public void rotate(float[] displacement) {
    rotations.update(displacement);
  }

  /** Writes the stiffness times a displacement into {@code dest}, N. */
  public void multiply(float[] displacement, float[] dest) {
    apply(displacement, dest, false);
  }

  /**
   * Writes the elastic forces at a displacement into {@code dest}, N: none if nothing is strained.
   */
  public void force(float[] displacement, float[] dest) {
    apply(displacement, dest, true);
  }

  private void apply(float[] from, float[] dest, boolean fromRest) {
    Arrays.fill(dest, 0);
    for (int first = 0; first < cells.count(); first += TILE) {
      int count = Math.min(TILE, cells.count() - first);
      for (int entry = 0; entry < 9; entry++) {
        System.arraycopy(rotations.entries[entry], first, r[entry], 0, count);
      }
      gatherTile(from, first, count, fromRest);
      multiplyTile(count);
      scatterTile(dest, first, count);
    }
    clearFixed(dest);
  }

  /** Writes the corners of a tile, turned back by the rotation of each cell. */
  private void gatherTile(float[] from, int first, int count, boolean fromRest) {
    LatticeLayout layout = cells.layout();
    for (int corner = 0; corner < LatticeLayout.CORNERS; corner++) {
      gather(from, first, count, layout.cornerOffset(corner));
      float restX = fromRest ? (float) ((corner & 1) * layout.edgeMm(0)) : 0;
      float restY = fromRest ? (float) ((corner >> 1 & 1) * layout.edgeMm(1)) : 0;
      float restZ = fromRest ? (float) ((corner >> 2) * layout.edgeMm(2)) : 0;
      if (fromRest) {
        add(restX, count, x);
        add(restY, count, y);
        add(restZ, count, z);
      }
      turn(r[0], r[3], r[6], x, y, z, count, in[3 * corner]);
      turn(r[1], r[4], r[7], x, y, z, count, in[3 * corner + 1]);
      turn(r[2], r[5], r[8], x, y, z, count, in[3 * corner + 2]);
      if (fromRest) {
        add(-restX, count, in[3 * corner]);
        add(-restY, count, in[3 * corner + 1]);
        add(-restZ, count, in[3 * corner + 2]);
      }
    }
  }

  private void gather(float[] from, int first, int count, int offset) {
    for (int t = 0; t < count; t++) {
      int node = cells.firstNode(first + t) + offset;
      x[t] = from[node];
      y[t] = from[nodes + node];
      z[t] = from[2 * nodes + node];
    }
  }

  private static void add(float what, int count, float[] dest) {
    for (int t = 0; t < count; t++) {
      dest[t] += what;
    }
  }

  private static void turn(
      float[] a, float[] b, float[] c, float[] x, float[] y, float[] z, int count, float[] dest) {
    for (int t = 0; t < count; t++) {
      dest[t] = a[t] * x[t] + b[t] * y[t] + c[t] * z[t];
    }
  }

  private void multiplyTile(int count) {
    for (int row = 0; row < SIZE; row++) {
      for (int column = 0; column < SIZE; column += 4) {
        multiply(row, column, count);
      }
    }
  }

  private void multiply(int row, int column, int count) {
    float[] a = in[column];
    float[] b = in[column + 1];
    float[] c = in[column + 2];
    float[] d = in[column + 3];
    int at = SIZE * row + column;
    float k0 = element[at];
    float k1 = element[at + 1];
    float k2 = element[at + 2];
    float k3 = element[at + 3];
    float[] dest = out[row];
    if (column == 0) {
      for (int t = 0; t < count; t++) {
        dest[t] = k0 * a[t] + k1 * b[t] + k2 * c[t] + k3 * d[t];
      }
    } else {
      for (int t = 0; t < count; t++) {
        dest[t] += k0 * a[t] + k1 * b[t] + k2 * c[t] + k3 * d[t];
      }
    }
  }

  /** Adds the forces of a tile, turned by the rotation of each cell. */
  private void scatterTile(float[] dest, int first, int count) {
    for (int corner = 0; corner < LatticeLayout.CORNERS; corner++) {
      float[] fx = out[3 * corner];
      float[] fy = out[3 * corner + 1];
      float[] fz = out[3 * corner + 2];
      turn(r[0], r[1], r[2], fx, fy, fz, count, x);
      turn(r[3], r[4], r[5], fx, fy, fz, count, y);
      turn(r[6], r[7], r[8], fx, fy, fz, count, z);
      scatter(first, count, cells.layout().cornerOffset(corner), dest);
    }
  }

  private void scatter(int first, int count, int offset, float[] dest) {
    for (int t = 0; t < count; t++) {
      int node = cells.firstNode(first + t) + offset;
      float e = modulus[first + t];
      dest[node] += e * x[t];
      dest[nodes + node] += e * y[t];
      dest[2 * nodes + node] += e * z[t];
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
