package org.palpate.raycast;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.math.BigDecimal;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.testing.RandomCases;
import org.palpate.testing.Seeds;

class ExactProductSumTest {

  @Test
  void hasTheSignOfTheSumInRationalArithmetic() {
    long seed = Seeds.seed();
    SplittableRandom random = new SplittableRandom(seed);
    ExactProductSum sum = new ExactProductSum();
    for (int n = 0; n < RandomCases.of(20_000); n++) {
      BigDecimal expected = BigDecimal.ZERO;
      int terms = random.nextInt(1, 7);
      for (int t = 0; t < terms; t++) {
        double a = anyFinite(random);
        double b = anyFinite(random);
        BigDecimal product = new BigDecimal(a).multiply(new BigDecimal(b));
        if (random.nextBoolean()) {
          sum.add(a, b);
          expected = expected.add(product);
        } else {
          sum.subtract(a, b);
          expected = expected.subtract(product);
        }
      }
      assertEquals(expected.signum(), sum.sign(), "seed=" + seed + " case " + n);
    }
  }

  @Test
  void cancelsToZero() {
    ExactProductSum sum = new ExactProductSum();
    sum.add(Double.MAX_VALUE, Double.MIN_VALUE);
    sum.add(Double.MIN_VALUE, Double.MIN_VALUE);
    sum.subtract(Double.MIN_VALUE, Double.MAX_VALUE);
    assertEquals(1, sum.sign());
    sum.add(3, 5);
    sum.subtract(5, 3);
    assertEquals(0, sum.sign());
  }

  private static double anyFinite(SplittableRandom random) {
    return switch (random.nextInt(4)) {
      case 0 -> random.nextInt(-4, 5);
      case 1 -> random.nextDouble(-300, 300);
      case 2 -> Math.scalb(random.nextDouble(-1, 1), random.nextInt(-1074, 1024));
      default -> random.nextBoolean() ? Double.MIN_VALUE : -Double.MAX_VALUE;
    };
  }
}
