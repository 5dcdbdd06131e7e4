package org.palpate.raycast;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.testing.RandomCases;
import org.palpate.volume.BitCube;

class SampledRayCasterTest {
  private static final long SEED = Long.getLong("palpate.seed", 20130);
  private static final int RAYS = 40_000;

  private final RayHit hit = new RayHit();
  private final RayHit expected = new RayHit();

  @ParameterizedTest
  @ValueSource(doubles = {1, 0.1, 0.37, 2.5})
  void agreesWithTheNaiveSampledCaster(double step) {
    RayCaster caster = new SampledRayCaster(step);
    SplittableRandom random = new SplittableRandom(SEED);
    BitCube bits = RandomRays.sparseCube(random);
    Ray ray = new Ray();
    for (int n = 0; n < RandomCases.of(RAYS); n++) {
      RandomRays.next(random, ray);
      boolean found = caster.cast(bits, ray, hit);
      String what = "seed " + SEED + " step " + step + " ray " + ray;
      assertEquals(NaiveRayCasters.sampled(step, bits, ray, expected), found, what);
      if (found) {
        RandomRays.assertSame(expected, hit, what);
      }
    }
  }

  /** Starts at a coordinate where a step is shorter than the distance of two doubles. */
  @Test
  void aRayWithMoreStepsThanDoublesEnds() {
    BitCube bits = new BitCube(4, 4, 4);
    bits.setBrick(0, 0, 0, -1L);
    for (double far : new double[] {0x1p53, 1e17, 1e30, 1e90}) {
      Ray ray = new Ray().from(far, 1.5, 1.5).to(1.5, 1.5, 1.5);
      assertTrue(new SampledRayCaster(1).cast(bits, ray, hit), "from " + far);
    }
  }

  @Test
  void gridPlanesAgreeWithTheNaiveCaster() {
    RayCaster caster = new GridPlanesRayCaster();
    SplittableRandom random = new SplittableRandom(SEED);
    BitCube bits = RandomRays.sparseCube(random);
    Ray ray = new Ray();
    for (int n = 0; n < RandomCases.of(RAYS); n++) {
      RandomRays.next(random, ray);
      boolean found = caster.cast(bits, ray, hit);
      String what = "seed " + SEED + " ray " + ray;
      assertEquals(NaiveRayCasters.gridPlanes(bits, ray, expected), found, what);
      if (found) {
        RandomRays.assertSame(expected, hit, what);
      }
    }
  }

  @Test
  void missesACornerThatGridPlanesFind() {
    BitCube bits = new BitCube(4, 4, 4);
    bits.set(1, 0, 0);
    Ray clipsACorner = new Ray().from(0.7, 0.75, 0.5).to(1.3, 1.15, 0.5);
    assertFalse(new SampledRayCaster(1).cast(bits, clipsACorner, hit));
    assertTrue(new GridPlanesRayCaster().cast(bits, clipsACorner, hit));
  }

  @Test
  void bothPassBetweenSolidsThatShareAnEdge() {
    BitCube bits = new BitCube(4, 4, 4);
    bits.set(1, 0, 0);
    bits.set(0, 1, 0);
    Ray throughTheEdge = new Ray().from(0.5, 0.5, 0.5).to(1.5, 1.5, 0.5);
    assertFalse(new SampledRayCaster(1).cast(bits, throughTheEdge, hit));
    assertFalse(new GridPlanesRayCaster().cast(bits, throughTheEdge, hit));
  }

  @Test
  void reachesTheEndOfAVeryLongRayAtOnce() {
    BitCube bits = new BitCube(4, 4, 4);
    bits.set(2, 2, 2);
    Ray far = new Ray().from(2.5, 2.5, -1e12).to(2.5, 2.5, 1e12);
    assertTrue(new GridPlanesRayCaster().cast(bits, far, hit));
    assertEquals(2, hit.k);
    assertFalse(new SampledRayCaster(1).cast(new BitCube(4, 4, 4), far, hit));
    Ray past = new Ray().from(1e12, 1e12, 1e12).to(3e12, 2e12, 1e12);
    assertFalse(new SampledRayCaster(1).cast(bits, past, hit));
  }

  @Test
  void findsASolidUnderTheStartAndUnderTheEnd() {
    BitCube bits = new BitCube(4, 4, 4);
    bits.set(1, 1, 1);
    Ray resting = new Ray().from(1.5, 1.5, 1.5).to(1.5, 1.5, 1.5);
    for (RayCaster caster : new RayCaster[] {new SampledRayCaster(1), new GridPlanesRayCaster()}) {
      assertTrue(caster.cast(bits, resting, hit));
      assertTrue(caster.cast(bits, new Ray().from(0.9, 0.9, 0.9).to(1.01, 1.01, 1.01), hit));
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, -1, Double.NaN, Double.POSITIVE_INFINITY})
  void refusesAStepThatIsNotPositiveAndFinite(double step) {
    assertThrows(IllegalArgumentException.class, () -> new SampledRayCaster(step));
  }
}
