package org.palpate.benchmarks.elastic;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

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
}
