package org.palpate.elastic;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.elastic.lattice.ControlLattice;
import org.palpate.elastic.lattice.LatticeLayout;
import org.palpate.geometry.GridMetric;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

/** The judge of deformations counts the folds that are planted into a lattice. */
class TetrahedraJudgeTest {
  private final ControlLattice lattice =
      ElasticTouch.softCube(new BitCube(16, 16, 16), 2, new GridMetric(1, 1, 1), 4);
  private final LatticeLayout layout = lattice.layout();
  private final DeformationField field = new DeformationField(DeformationField.Layout.of(lattice));
  private final DeformationMap map = new DeformationMap(DeformationField.Layout.of(lattice), field);

  private void displace(int node, int axis, double cells) {
    field.whole.values[DeformationField.STRIDE * node + axis] = (float) cells;
  }

  private int middleNode() {
    return layout.node(layout.cells(0) / 2, layout.cells(1) / 2, layout.cells(2) / 2);
  }

  private long folded() {
    map.use(field);
    return TetrahedraJudge.folded(lattice, map);
  }

  @Test
  void aLatticeAtRestHasNoFold() {
    assertEquals(0, folded());
  }

  /** Six tetrahedra share the edge from a node to the next one along x; the others stay thick. */
  @Test
  void aNodeThatPassesTheNextOneFoldsTheSixTetrahedraAroundTheirEdge() {
    int node = middleNode();
    displace(node, 0, 0.9);
    assertEquals(0, folded(), "it stays before the next node");
    displace(node, 0, 1);
    assertEquals(6, folded(), "flat ones are not positive");
    displace(node, 0, 1.1);
    assertEquals(6, folded());
    displace(node, 0, 100);
    assertEquals(6, folded());
    displace(node, 0, 0);
    assertEquals(0, folded());
  }

  @Test
  void allAxesAreJudgedAlike() {
    int node = middleNode();
    for (double far : new double[] {1, 1.5, 100, -1, -100}) {
      long[] counts = new long[3];
      for (int axis = 0; axis < 3; axis++) {
        displace(node, axis, far);
        counts[axis] = folded();
        displace(node, axis, 0);
      }
      assertTrue(counts[0] > 0, "displaced by " + far);
      assertEquals(counts[0], counts[1], "displaced by " + far);
      assertEquals(counts[0], counts[2], "displaced by " + far);
    }
  }

  /** Compares with volumes in doubles, far from zero, summed by another formula. */
  @Test
  void agreesWithSignedVolumesOfRandomDisplacements() {
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    long all = 0;
    for (int round = 0; round < 20; round++) {
      double size = 0.2 + 0.06 * round;
      for (int node = 0; node < layout.nodeCount(); node++) {
        for (int axis = 0; axis < 3; axis++) {
          displace(node, axis, size * random.nextDouble(-1, 1));
        }
      }
      long folded = folded();
      assertEquals(naiveFolded(), folded, "seed " + Seeds.seed() + " round " + round);
      all += folded;
    }
    assertTrue(all > 300, "folded: " + all);
  }

  private long naiveFolded() {
    int[][] orders = {{1, 2, 4}, {2, 4, 1}, {4, 1, 2}, {1, 4, 2}, {4, 2, 1}, {2, 1, 4}};
    long folded = 0;
    for (int z = 0; z < layout.cells(2); z++) {
      for (int y = 0; y < layout.cells(1); y++) {
        for (int x = 0; x < layout.cells(0); x++) {
          for (int n = 0; n < 6; n++) {
            double[] a = at(x, y, z, 0);
            double[] b = at(x, y, z, orders[n][0]);
            double[] c = at(x, y, z, orders[n][0] + orders[n][1]);
            double[] d = at(x, y, z, 7);
            double volume = volume(a, b, c, d);
            folded += (n < 3 ? volume : -volume) > 0 ? 0 : 1;
          }
        }
      }
    }
    return folded;
  }

  private double[] at(int x, int y, int z, int corner) {
    int node = layout.node(x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2));
    return new double[] {
      map.nodePosition(node, 0), map.nodePosition(node, 1), map.nodePosition(node, 2)
    };
  }

  /** Returns six times the signed volume: (b - a) x (c - a) . (d - a). */
  private static double volume(double[] a, double[] b, double[] c, double[] d) {
    double sum = 0;
    for (int n = 0; n < 3; n++) {
      int u = (n + 1) % 3;
      int v = (n + 2) % 3;
      double cross = (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]);
      sum += cross * (d[n] - a[n]);
    }
    return sum;
  }
}
