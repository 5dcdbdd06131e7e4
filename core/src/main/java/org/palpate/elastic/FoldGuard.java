package org.palpate.elastic;

import java.util.Arrays;
import org.palpate.elastic.lattice.ActiveCells;
import org.palpate.elastic.lattice.LatticeLayout;

/**
 * Takes folds out of an update: the nodes of each cell that is nearly flat or folded go back
 * towards the displacement that was proved last, until no such cell is left. It ends, because the
 * proved displacement has none.
 *
 * <p>One thread; allocates nothing after construction.
 */
final class FoldGuard {
  /** The least determinant that an update may have, twice what the proof asks for. */
  static final double LEAST_DETERMINANT = 2 * RoomProof.LEAST_DETERMINANT;

  private static final int MOST_PASSES = 60;

  /** Every so many passes the nodes go back all the way. */
  private static final int FULL_PASS = 8;

  private final ActiveCells cells;
  private final int nodes;
  private final float[] determinants;
  private final boolean[] marked;
  private final double[] corners = new double[KuhnTetrahedra.ENTRIES];

  FoldGuard(ActiveCells cells) {
    this.cells = cells;
    nodes = cells.layout().nodeCount();
    determinants = new float[cells.count()];
    Arrays.fill(determinants, 1);
    marked = new boolean[nodes];
  }

  /** Returns the least determinant of each listed cell as the last call found it, 1 at rest. */
  float[] determinants() {
    return determinants;
  }

  /**
   * Takes folds out of a displacement.
   *
   * @param displacement changed in place, mm
   * @param proved the displacement that was proved last, mm
   * @return whether any node went back
   */
  boolean unfold(float[] displacement, float[] proved) {
    int pass = 0;
    while (markFolded(displacement)) {
      pass++;
      if (pass > MOST_PASSES) {
        System.arraycopy(proved, 0, displacement, 0, proved.length);
        markFolded(displacement);
        break;
      }
      goBack(displacement, proved, pass % FULL_PASS == 0 ? 0 : 0.5f);
    }
    return pass > 0;
  }

  private boolean markFolded(float[] displacement) {
    Arrays.fill(marked, false);
    boolean any = false;
    for (int cell = 0; cell < determinants.length; cell++) {
      double determinant = leastDeterminant(displacement, cells.firstNode(cell));
      determinants[cell] = (float) determinant;
      if (!(determinant >= LEAST_DETERMINANT)) {
        any = true;
        for (int corner = 0; corner < LatticeLayout.CORNERS; corner++) {
          marked[cells.firstNode(cell) + cells.layout().cornerOffset(corner)] = true;
        }
      }
    }
    return any;
  }

  private double leastDeterminant(float[] displacement, int firstNode) {
    LatticeLayout layout = cells.layout();
    for (int corner = 0; corner < LatticeLayout.CORNERS; corner++) {
      int node = firstNode + layout.cornerOffset(corner);
      for (int axis = 0; axis < 3; axis++) {
        double cellsAway = displacement[axis * nodes + node] / layout.edgeMm(axis);
        corners[3 * corner + axis] = (corner >> axis & 1) + cellsAway;
      }
    }
    return KuhnTetrahedra.leastDeterminant(corners);
  }

  private void goBack(float[] displacement, float[] proved, float keep) {
    for (int node = 0; node < nodes; node++) {
      if (marked[node]) {
        for (int at = node; at < displacement.length; at += nodes) {
          displacement[at] = proved[at] + keep * (displacement[at] - proved[at]);
        }
      }
    }
  }
}
