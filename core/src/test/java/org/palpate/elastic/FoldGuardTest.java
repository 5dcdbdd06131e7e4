package org.palpate.elastic;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.palpate.elastic.lattice.ControlLattice;
import org.palpate.elastic.lattice.ElasticMaterial;
import org.palpate.elastic.lattice.ElasticSegment;
import org.palpate.geometry.GridMetric;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

class FoldGuardTest {
  private final Random random = new Random(Seeds.seed());
  private final ControlLattice lattice = lattice();
  private final FoldGuard guard = new FoldGuard(lattice.cells());
  private final int size = 3 * lattice.layout().nodeCount();

  private static ControlLattice lattice() {
    BitCube bits = new BitCube(20, 20, 20);
    ElasticTouch.fill(bits, 2, 18, 2, 18, 2, 18);
    ElasticSegment soft = new ElasticSegment(bits, new ElasticMaterial(1e4, 0.3));
    return new ControlLattice(new GridMetric(1, 1, 1), List.of(soft), List.of(), 4);
  }

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
