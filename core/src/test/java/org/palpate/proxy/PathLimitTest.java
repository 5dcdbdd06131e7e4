package org.palpate.proxy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.testing.HostileNumbers;
import org.palpate.testing.RandomCases;
import org.palpate.testing.Seeds;

class PathLimitTest {
  private static final long SEED = Seeds.seed();

  /** Far above the rounding of a computed length, which is a few 2^-53. */
  private static final BigDecimal TOLERANCE = BigDecimal.valueOf(1 + 0x1p-50);

  private final SplittableRandom random = new SplittableRandom(SEED);
  private final LegPath legs = new LegPath();
  private final Vec3 from = new Vec3();
  private final Vec3 to = new Vec3();
  private final Vec3 dest = new Vec3();

  @Test
  void noLegIsLongerThanTheRemainingPath() {
    int cuts = 0;
    for (int n = 0; n < RandomCases.of(200_000); n++) {
      String what = "seed=" + SEED + " n=" + n;
      GridMetric metric = anyMetric();
      double maxPathMm = anyLength();
      PathLimit limit = new PathLimit(metric, maxPathMm);
      anyLeg(metric, maxPathMm);
      double remainingMm = limit.remainingMm(legs);
      boolean cut = limit.cut(legs, from, to, dest);
      cuts += cut ? 1 : 0;
      double lengthMm = distance(metric, from, dest);
      assertTrue(lengthMm <= remainingMm || dest.sameBits(from), what);
      assertTrue(dest.sameBits(from) || isWithin(metric, remainingMm), what);
      assertTrue(cut || dest.sameBits(to), what);
    }
    assertTrue(cuts > RandomCases.of(50_000), "too few cuts to mean anything: " + cuts);
  }

  @Test
  void cutsToTheSameBitsAsTheNaiveCut() {
    Vec3 expected = new Vec3();
    for (int n = 0; n < RandomCases.of(200_000); n++) {
      GridMetric metric = anyMetric();
      double maxPathMm = anyLength();
      PathLimit limit = new PathLimit(metric, maxPathMm);
      anyLeg(metric, maxPathMm);
      boolean expectedCut = naiveCut(metric, limit.remainingMm(legs), expected);
      assertEquals(expectedCut, limit.cut(legs, from, to, dest), "seed=" + SEED + " n=" + n);
      assertTrue(expected.sameBits(dest), "seed=" + SEED + " n=" + n);
      limit.cut(legs, from, to, to);
      assertTrue(expected.sameBits(to), "in place: seed=" + SEED + " n=" + n);
    }
  }

  @Test
  void aPathOfManyCutLegsStaysWithinTheLimit() {
    GridMetric metric = new GridMetric(0.7, 1, 2.3);
    for (int frame = 0; frame < 2_000; frame++) {
      double maxPathMm = random.nextDouble(0.1, 10);
      PathLimit limit = new PathLimit(metric, maxPathMm);
      legs.clear();
      from.set(5, 5, 5);
      while (!legs.isFull()) {
        to.set(random.nextDouble(10), random.nextDouble(10), random.nextDouble(10));
        limit.cut(legs, from, to, dest);
        add(metric);
        from.set(dest);
      }
      assertTrue(legs.lengthMm() <= maxPathMm, "seed=" + SEED + " frame=" + frame);
    }
  }

  @Test
  void knowsWhenThePathIsUsedUpOrTooLong() {
    PathLimit limit = new PathLimit(new GridMetric(1, 1, 1), 4);
    legs.add(0, 0, 0, 3, 0, 0, 3, false);
    assertEquals(1, limit.remainingMm(legs));
    assertFalse(limit.isUsedUp(legs));
    assertFalse(limit.isExceededBy(legs, 1));
    assertTrue(limit.isExceededBy(legs, 1.001));
    legs.add(3, 0, 0, 4, 0, 0, 1, false);
    assertTrue(limit.isUsedUp(legs));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, -1, Double.NaN})
  void refusesALimitThatIsNotPositive(double maxPathMm) {
    GridMetric metric = new GridMetric(1, 1, 1);
    assertThrows(IllegalArgumentException.class, () -> new PathLimit(metric, maxPathMm));
  }

  /**
   * Sets any leg, and the legs before it to any part of the path, sometimes more than all of it.
   */
  private void anyLeg(GridMetric metric, double maxPathMm) {
    from.set(anyCoordinate(), anyCoordinate(), anyCoordinate());
    to.set(anyCoordinate(), anyCoordinate(), anyCoordinate());
    legs.clear();
    double usedMm = maxPathMm * random.nextInt(0, 5) / 4;
    legs.add(0, 0, 0, 0, 0, 0, usedMm, false);
    if (random.nextInt(4) == 0) { // a leg that ends close to the limit
      double lengthMm = distance(metric, from, to);
      double fraction = (maxPathMm - usedMm) / lengthMm * (1 + random.nextInt(-4, 5) * 0x1p-52);
      if (fraction > 0 && fraction < 1e6) {
        to.set(
            from.x + fraction * (to.x - from.x),
            from.y + fraction * (to.y - from.y),
            from.z + fraction * (to.z - from.z));
      }
    }
  }

  private double anyCoordinate() {
    return random.nextInt(3) == 0
        ? HostileNumbers.coordinate(random, 64)
        : random.nextDouble(-20, 20);
  }

  private double anyLength() {
    return Math.exp(random.nextDouble(-20, 20));
  }

  private GridMetric anyMetric() {
    return random.nextBoolean()
        ? new GridMetric(1, 1, 1)
        : new GridMetric(
            random.nextDouble(0.1, 3), random.nextDouble(0.1, 3), random.nextDouble(0.1, 30));
  }

  private void add(GridMetric metric) {
    legs.add(from.x, from.y, from.z, dest.x, dest.y, dest.z, distance(metric, from, dest), false);
  }

  private static double distance(GridMetric metric, Vec3 a, Vec3 b) {
    return metric.distance(a.x, a.y, a.z, b.x, b.y, b.z);
  }

  /** Whether the leg is no longer than the remaining path in rational arithmetic. */
  private boolean isWithin(GridMetric metric, double remainingMm) {
    BigDecimal square =
        squareMm(from.x, dest.x, metric.spacingX())
            .add(squareMm(from.y, dest.y, metric.spacingY()))
            .add(squareMm(from.z, dest.z, metric.spacingZ()));
    BigDecimal remaining = new BigDecimal(remainingMm).multiply(TOLERANCE);
    return square.compareTo(remaining.multiply(remaining)) <= 0;
  }

  private static BigDecimal squareMm(double from, double to, double spacing) {
    BigDecimal mm =
        new BigDecimal(to).subtract(new BigDecimal(from)).multiply(new BigDecimal(spacing));
    return mm.multiply(mm);
  }

  /** Cuts without a shortcut, by the length of the leg. */
  private boolean naiveCut(GridMetric metric, double remainingMm, Vec3 expected) {
    double lengthMm = distance(metric, from, to);
    if (lengthMm <= remainingMm) {
      expected.set(to);
      return false;
    }
    double fraction = Math.max(0, remainingMm / lengthMm * (1 - 0x1p-40));
    expected.set(
        from.x + fraction * (to.x - from.x),
        from.y + fraction * (to.y - from.y),
        from.z + fraction * (to.z - from.z));
    if (distance(metric, from, expected) > remainingMm) {
      expected.set(from);
    }
    return true;
  }
}
