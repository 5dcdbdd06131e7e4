package org.palpate.elastic;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.palpate.testing.Seeds;

class KuhnTetrahedraTest {
  private static final int[] CELLS = {3, 1, 5};

  /** Coordinates are multiples of 1/64, so that sums and products have no rounding. */
  private static final int PARTS = 64;

  private final int[] cell = new int[3];
  private final int[] order = new int[3];
  private final double[] along = new double[3];
  private final double[] weights = new double[4];

  private boolean find(double x, double y, double z) {
    boolean found = KuhnTetrahedra.find(new double[] {x, y, z}, CELLS, cell, order, along);
    KuhnTetrahedra.weigh(along, weights);
    return found;
  }

  /** Returns the weighted mean of the four nodes on the path along the edges. */
  private double[] weighed() {
    double[] sum = new double[3];
    int[] node = cell.clone();
    for (int n = 0; n < 4; n++) {
      if (n > 0) {
        node[order[n - 1]]++;
      }
      for (int axis = 0; axis < 3; axis++) {
        sum[axis] += weights[n] * node[axis];
      }
    }
    return sum;
  }

  @Test
  void theWeightedNodesGiveThePointExactly() {
    Random random = new Random(Seeds.seed());
    for (int n = 0; n < 2_000; n++) {
      double[] at = new double[3];
      for (int axis = 0; axis < 3; axis++) {
        at[axis] = (double) random.nextInt(CELLS[axis] * PARTS + 1) / PARTS;
      }
      assertTrue(find(at[0], at[1], at[2]));
      assertArrayEquals(at, weighed());
      double sum = 0;
      for (double weight : weights) {
        assertTrue(weight >= 0, "the point lies in the tetrahedron");
        sum += weight;
      }
      assertEquals(1, sum);
      for (int axis = 0; axis < 3; axis++) {
        assertTrue(cell[axis] >= 0 && cell[axis] < CELLS[axis]);
      }
    }
  }

  @Test
  void theOrderFollowsTheAxesFromTheFarthestToTheNearest() {
    assertTrue(find(0.25, 0.75, 0.5));
    assertArrayEquals(new int[] {1, 2, 0}, order);
    assertArrayEquals(new double[] {0.75, 0.5, 0.25}, along);
  }

  @Test
  void aPointOutsideTheLatticeLeavesEverythingAsItWas() {
    find(2.5, 0.5, 4.25);
    double[] before = weighed();
    assertFalse(find(Math.nextUp(3.0), 0.5, 4.5));
    assertFalse(find(2.5, -Double.MIN_VALUE, 4.5));
    assertFalse(find(2.5, 0.5, Double.NaN));
    assertArrayEquals(before, weighed());
  }
}
