package org.palpate.elastic.lattice;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.palpate.testing.Seeds;

/** The plain reference interpolates each fine node from the coarse nodes around it. */
class NodeTransferTest {
  private final Random random = new Random(Seeds.seed());
  private final LatticeLayout layout =
      new LatticeLayout(
          new int[3], new int[] {1, 1, 1}, new int[] {6, 4, 8}, new double[] {1, 1, 1});
  private final ActiveCells fine = new ActiveCells(layout, fixed());
  private final ActiveCells coarse = fine.coarser();
  private final NodeTransfer transfer = new NodeTransfer(fine, coarse);
  private final int fineCount = layout.nodeCount();
  private final int coarseCount = coarse.layout().nodeCount();

  private boolean[] fixed() {
    boolean[] fixed = new boolean[layout.nodeCount()];
    for (int node = 0; node < fixed.length; node++) {
      fixed[node] = random.nextInt(4) == 0;
    }
    return fixed;
  }

  /** Returns the weight of a coarse node at a fine node, both free. */
  private double weight(int fineNode, int coarseNode) {
    double weight = fine.isFixed(fineNode) || coarse.isFixed(coarseNode) ? 0 : 1;
    for (int axis = 0; axis < 3; axis++) {
      int away = layout.nodeIndex(axis, fineNode) - 2 * coarse.layout().nodeIndex(axis, coarseNode);
      weight *= Math.max(0, 1 - 0.5 * Math.abs(away));
    }
    return weight;
  }

  private float[] vector(ActiveCells cells) {
    int nodes = cells.layout().nodeCount();
    float[] vector = new float[3 * nodes];
    for (int n = 0; n < vector.length; n++) {
      vector[n] = cells.isFixed(n % nodes) ? 0 : random.nextFloat() - 0.5f;
    }
    return vector;
  }

  @Test
  void restrictsAndProlongsAsTheWeightsSay() {
    float[] residual = vector(fine);
    float[] restricted = new float[3 * coarseCount];
    transfer.restrict(residual, restricted);
    float[] correction = vector(coarse);
    float[] before = vector(fine);
    float[] prolonged = before.clone();
    transfer.prolong(correction, prolonged);
    for (int axis = 0; axis < 3; axis++) {
      for (int c = 0; c < coarseCount; c++) {
        double sum = 0;
        for (int f = 0; f < fineCount; f++) {
          sum += weight(f, c) * residual[axis * fineCount + f];
        }
        assertEquals(sum, restricted[axis * coarseCount + c], 1e-5, "coarse node " + c);
      }
      for (int f = 0; f < fineCount; f++) {
        double sum = before[axis * fineCount + f];
        for (int c = 0; c < coarseCount; c++) {
          sum += weight(f, c) * correction[axis * coarseCount + c];
        }
        assertEquals(sum, prolonged[axis * fineCount + f], 1e-5, "fine node " + f);
      }
    }
  }
}
