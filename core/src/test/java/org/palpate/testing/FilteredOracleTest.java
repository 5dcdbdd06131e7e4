package org.palpate.testing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.raycast.Ray;
import org.palpate.volume.BitCube;

class FilteredOracleTest {
  @Test
  void agreesWithRationalArithmeticOnHostileSegments() {
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    FilteredOracle filtered = new FilteredOracle();
    int touching = 0;
    for (int n = 0; n < 60_000; n++) {
      BitCube bits = new BitCube(5, 6, 4);
      bits.set(random.nextInt(5), random.nextInt(6), random.nextInt(4));
      bits.set(random.nextInt(5), random.nextInt(6), random.nextInt(4));
      Ray ray = new Ray();
      ray.from(near(random, 5), near(random, 6), near(random, 4));
      ray.to(near(random, 5), near(random, 6), near(random, 4));
      boolean expected = ExactOracle.touchesAny(bits, ray);
      assertEquals(expected, filtered.touchesAny(bits, ray), ray.toString());
      touching += expected ? 1 : 0;
    }
    assertTrue(touching > 3000 && filtered.doubts() > 300, touching + " " + filtered.doubts());
  }

  private static double near(SplittableRandom random, int size) {
    double v = HostileNumbers.coordinate(random, size);
    return Math.abs(v) < 100 ? v : random.nextDouble(size);
  }
}
