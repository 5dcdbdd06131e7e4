package org.palpate.volume;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.palpate.testing.RandomCases;
import org.palpate.testing.Seeds;

class LevelGradientsTest {
  private static final long SEED = Seeds.seed();
  private static final int[] WEIGHTS = {1, 2, 1};

  @Test
  void equalTheirDefinition() {
    Random random = new Random(SEED);
    LevelGradients gradients = new LevelGradients();
    for (int n = 0; n < RandomCases.of(2000); n++) {
      int[][] levels = new int[LevelGradients.ROWS][24];
      for (int row = 0; row < LevelGradients.ROWS; row++) {
        for (int x = 0; x < 24; x++) {
          levels[row][x] = random.nextInt(3) == 0 ? random.nextInt(256) : 255 * random.nextInt(2);
        }
        gradients.set(row, word(levels[row], 0), word(levels[row], 8), word(levels[row], 16));
      }
      gradients.find();
      for (int voxel = 0; voxel < 8; voxel++) {
        int[] expected = gradient(levels, 8 + voxel);
        String where = "seed=" + SEED + " n=" + n + " voxel " + voxel;
        assertEquals(expected[0], gradients.x(voxel), where);
        assertEquals(expected[1], gradients.y(voxel), where);
        assertEquals(expected[2], gradients.z(voxel), where);
      }
    }
  }

  private static long word(int[] levels, int from) {
    long word = 0;
    for (int n = 0; n < 8; n++) {
      word |= (long) levels[from + n] << (8 * n);
    }
    return word;
  }

  private static int[] gradient(int[][] levels, int x) {
    int[] sum = new int[3];
    for (int a = -1; a <= 1; a++) {
      for (int b = -1; b <= 1; b++) {
        for (int c = -1; c <= 1; c++) {
          int level = levels[3 * (c + 1) + b + 1][x + a];
          sum[0] += a * WEIGHTS[b + 1] * WEIGHTS[c + 1] * level;
          sum[1] += b * WEIGHTS[a + 1] * WEIGHTS[c + 1] * level;
          sum[2] += c * WEIGHTS[a + 1] * WEIGHTS[b + 1] * level;
        }
      }
    }
    return sum;
  }
}
