package org.palpate.benchmarks.elastic;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.elastic.ElasticBody;
import org.palpate.elastic.ElasticBodyVariants;
import org.palpate.elastic.lattice.LatticeLayout;

class TetrahedronJudgeTest {
  private static double[][] cube() {
    double[][] corners = new double[8][3];
    for (int n = 0; n < 8; n++) {
      corners[n] = new double[] {n & 1, n >> 1 & 1, n >> 2};
    }
    return corners;
  }

  private static TetrahedronJudge judged(double[][] corners) {
    TetrahedronJudge judge = new TetrahedronJudge();
    judge.judge(corners);
    return judge;
  }

  @Test
  void allSixOfACubeArePositive() {
    assertEquals(0, judged(cube()).notPositive());
    assertEquals(6, judged(cube()).judged());
  }

  @Test
  void allSixOfAMirroredCubeAreNot() {
    double[][] corners = cube();
    for (double[] corner : corners) {
      corner[1] = -corner[1];
    }
    assertEquals(6, judged(corners).notPositive());
  }

  @Test
  void aCornerThatIsPushedThroughFoldsThoseThatHoldIt() {
    double[][] corners = cube();
    corners[1] = new double[] {-0.5, 0, 0};
    assertEquals(2, judged(corners).notPositive());
  }

  /** Rounding would decide neither of these two. */
  @Test
  void decidesFlatAndNearlyFlatOnesExactly() {
    double[][] corners = cube();
    corners[1] = new double[] {0, 0, 0};
    assertEquals(2, judged(corners).notPositive());
    corners = new double[8][];
    for (int n = 0; n < 8; n++) {
      double x = n & 1;
      double y = n >> 1 & 1;
      double z = n >> 2;
      // The third edge is a tenth of the first and three tenths of the second, but for rounding.
      corners[n] = new double[] {x + 0.1 * z, y + 0.3 * z, 0.7 * x + 0.9 * y + 0.34 * z};
    }
    TetrahedronJudge judge = judged(corners);
    assertEquals(6, judge.exactDecisions());
  }

  @Test
  void doublesSufficeForACubeAndItsMirrorImage() {
    assertEquals(0, judged(cube()).exactDecisions());
    double[][] corners = cube();
    for (double[] corner : corners) {
      corner[2] = -corner[2];
    }
    assertEquals(0, judged(corners).exactDecisions());
  }

  /** All corners lie near one plane, so that rounding alone gives a tetrahedron its sign. */
  @Test
  void agreesWithDeterminantsOfDecimalFractionsWhereRoundingDecides() {
    SplittableRandom random = new SplittableRandom(20_261_129);
    TetrahedronJudge judge = new TetrahedronJudge();
    long expected = 0;
    for (int cell = 0; cell < 3_000; cell++) {
      double[][] corners = cube();
      for (double[] corner : corners) {
        corner[0] += random.nextDouble(0.2);
        corner[1] += random.nextDouble(0.2);
        corner[2] = 0.1 * corner[0] + 0.3 * corner[1] + random.nextInt(-1, 2) * 0x1p-54;
      }
      expected += naiveNotPositive(corners);
      judge.judge(corners);
    }
    assertEquals(expected, judge.notPositive());
    assertEquals(6 * 3_000, judge.judged());
    assertTrue(judge.exactDecisions() > 10_000, "exact: " + judge.exactDecisions());
    assertTrue(expected > 5_000 && expected < 13_000, "not positive: " + expected);
  }

  @Test
  void agreesWithDeterminantsOfDecimalFractionsForCornersAnywhere() {
    SplittableRandom random = new SplittableRandom(20_261_130);
    TetrahedronJudge judge = new TetrahedronJudge();
    long expected = 0;
    for (int cell = 0; cell < 2_000; cell++) {
      double[][] corners = cube();
      double spread = random.nextDouble(1.5);
      for (double[] corner : corners) {
        for (int axis = 0; axis < 3; axis++) {
          corner[axis] += random.nextDouble(-spread, spread + 1e-9);
        }
      }
      expected += naiveNotPositive(corners);
      judge.judge(corners);
    }
    assertEquals(expected, judge.notPositive());
    assertTrue(expected > 1_000 && expected < 9_000, "not positive: " + expected);
  }

  /**
   * Counts the tetrahedra that are not positive. A tetrahedron goes from corner 0 to corner 7 along
   * the axes in one order; an odd order is the mirror image of an even one.
   */
  private static long naiveNotPositive(double[][] corners) {
    int[][] orders = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    long count = 0;
    for (int n = 0; n < orders.length; n++) {
      int[] order = orders[n];
      double[] first = corners[1 << order[0]];
      double[] second = corners[1 << order[0] | 1 << order[1]];
      int sign = determinant(corners[0], first, second, corners[7]).signum();
      count += (n < 3 ? sign : -sign) > 0 ? 0 : 1;
    }
    return count;
  }

  /** Returns the determinant of three points seen from a fourth, term by term. */
  private static BigDecimal determinant(double[] from, double[] p, double[] q, double[] r) {
    int[][] permutations = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    BigDecimal sum = BigDecimal.ZERO;
    for (int n = 0; n < permutations.length; n++) {
      int[] axes = permutations[n];
      BigDecimal product =
          difference(p, from, axes[0])
              .multiply(difference(q, from, axes[1]))
              .multiply(difference(r, from, axes[2]));
      sum = n < 3 ? sum.add(product) : sum.subtract(product);
    }
    return sum;
  }

  private static BigDecimal difference(double[] a, double[] b, int axis) {
    return new BigDecimal(a[axis]).subtract(new BigDecimal(b[axis]));
  }

  /**
   * A block that is pressed hard bulges and stays unfolded; corners in a wrong order would fold.
   */
  @Test
  void judgesEveryCellOfAPressedBody() {
    ElasticSession session = PressStudy.above(Softness.USUAL);
    session.moveTo(session.hand().x, session.hand().y, 38, 200);
    ElasticBody body = session.body();
    LatticeLayout layout = ElasticBodyVariants.layout(body);
    long cells = (long) layout.cells(0) * layout.cells(1) * layout.cells(2);
    TetrahedronJudge judge = new TetrahedronJudge();
    judge.judge(body);
    assertEquals(6 * cells, judge.judged());
    assertEquals(0, judge.notPositive());
    double moved = 0;
    for (int z = 0; z <= layout.cells(2); z++) {
      for (int y = 0; y <= layout.cells(1); y++) {
        for (int x = 0; x <= layout.cells(0); x++) {
          int node = layout.node(x, y, z);
          moved = Math.max(moved, Math.abs(ElasticBodyVariants.nodePosition(body, node, 2) - z));
        }
      }
    }
    assertTrue(moved > 0.05, "the hand presses: " + moved + " of a cell");
  }

  @Test
  void judgesTheCellsOfAWindowInsteadOfThoseUnderIt() {
    ElasticSession session =
        new ElasticSession(SoftScene.block(), Softness.USUAL.withCells(8, 8), true);
    session.hand().set(48.3, 48.4, 52);
    session.moveTo(48.3, 48.4, 44, 200);
    LatticeLayout layout = ElasticBodyVariants.layout(session.body());
    LatticeLayout window = ElasticBodyVariants.windowLayout(session.body()).orElseThrow();
    long cells = (long) layout.cells(0) * layout.cells(1) * layout.cells(2);
    long inWindow = (long) window.cells(0) * window.cells(1) * window.cells(2);
    TetrahedronJudge judge = new TetrahedronJudge();
    judge.judge(session.body());
    assertEquals(6 * (cells - inWindow / 8 + inWindow), judge.judged());
    assertEquals(0, judge.notPositive());
    assertEquals(1, judge.windows());
    int middle = window.node(window.cells(0) / 2, window.cells(1) / 2, window.cells(2) / 2);
    double at = ElasticBodyVariants.windowPosition(session.body(), middle, 2);
    assertTrue(at < window.nodeIndex(2, middle) - 0.1, "displaced to " + at);
  }
}
