package org.palpate.fracture.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.testing.Seeds;

class SymmetricEigenTest {
  private static final int SIZE = 6;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());

  @Test
  void theVectorsAreOrthonormalAndGiveTheMatrixBack() {
    for (int round = 0; round < 200; round++) {
      double[][] matrix = new double[SIZE][SIZE];
      int rank = random.nextInt(1, SIZE + 1); // of less than full rank, too
      for (int n = 0; n < rank; n++) {
        double[] row = random.doubles(SIZE, -1, 1).toArray();
        for (int p = 0; p < SIZE * SIZE; p++) {
          matrix[p / SIZE][p % SIZE] += row[p / SIZE] * row[p % SIZE];
        }
      }
      SymmetricEigen eigen = new SymmetricEigen(matrix);
      for (int p = 0; p < SIZE; p++) {
        for (int q = 0; q < SIZE; q++) {
          double back = 0;
          double dot = 0;
          for (int n = 0; n < SIZE; n++) {
            back += eigen.value(n) * eigen.component(n, p) * eigen.component(n, q);
            dot += eigen.component(p, n) * eigen.component(q, n);
          }
          assertEquals(matrix[p][q], back, 1e-12);
          assertEquals(p == q ? 1 : 0, dot, 1e-12);
        }
      }
    }
  }
}
