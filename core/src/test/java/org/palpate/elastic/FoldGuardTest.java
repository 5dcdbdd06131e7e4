package org.palpate.elastic;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.palpate.elastic.lattice.ControlLattice;
import org.palpate.geometry.GridMetric;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

class FoldGuardTest {
  private final Random random = new Random(Seeds.seed());
  private final ControlLattice lattice =
      ElasticTouch.softCube(new BitCube(20, 20, 20), 2, new GridMetric(1, 1, 1), 4);
  private final FoldGuard guard = new FoldGuard(lattice.cells());
  private final int size = 3 * lattice.layout().nodeCount();

  private float[] randomDisplacement(double mm) {
    float[] u = new float[size];
    for (int n = 0; n < size; n++) {
      boolean fixed = lattice.cells().isFixed(n % lattice.layout().nodeCount());
      u[n] = fixed ? 0 : (float) (mm * random.nextGaussian());
    }
    return u;
  }

  private boolean isFolded(float[] u) {
    return guard.unfold(u.clone(), new float[size]);
  }

  @Test
  void leavesAShapeThatIsNotFoldedAsItIs() {
    float[] u = randomDisplacement(0.2);
    float[] before = u.clone();
    assertFalse(guard.unfold(u, new float[size]));
    assertArrayEquals(before, u);
  }

  @Test
  void takesEveryFoldOut() {
    float[] proved = randomDisplacement(0.2);
    for (double mm : new double[] {1, 3, 10, 1000}) {
      float[] u = randomDisplacement(mm);
      assertTrue(guard.unfold(u, proved), mm + " mm");
      assertFalse(isFolded(u), mm + " mm");
    }
  }

  @Test
  void goesBackAltogetherIfNothingIsFinite() {
    float[] proved = randomDisplacement(0.2);
    float[] u = new float[size];
    java.util.Arrays.fill(u, Float.NaN);
    assertTrue(guard.unfold(u, proved));
    assertArrayEquals(proved, u);
  }
}
