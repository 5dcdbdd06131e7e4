package org.palpate.raycast;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.testing.RandomCases;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

class FarRayTraversalTest {
  /** Far less than the distance to a plane at which a position is in doubt, voxels. */
  private static final double TINY = 0x1p-30;

  private final EmptySpaceSkipper empty = new EmptySpaceSkipper(true);
  private final FarRayTraversal traversal = new FarRayTraversal(empty);
  private final RayHit hit = new RayHit();

  @Test
  void aRayIsWithinReachIfEachOfItsCoordinatesIs() {
    for (int n = 0; n < 6; n++) {
      for (double far : new double[] {0x1p20, -0x1p20}) {
        double[] at = {1.5, -2.5, 3.5, 4.5, 5.5, -6.5};
        at[n] = far / 2;
        assertTrue(FarRayTraversal.isWithinReach(ray(at)), "coordinate " + n + " = " + at[n]);
        at[n] = far * 2;
        assertFalse(FarRayTraversal.isWithinReach(ray(at)), "coordinate " + n + " = " + at[n]);
      }
    }
  }

  private static Ray ray(double[] at) {
    return new Ray().from(at[0], at[1], at[2]).to(at[3], at[4], at[5]);
  }

  /** The only solid is the voxel (4, 4, 4). */
  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2})
  void findsTheFaceThroughWhichARayEntersTheOnlySolid(int axis) {
    BitCube bits = new BitCube(8, 8, 8);
    bits.set(4, 4, 4);
    double[] before = {-11.5, 4.25, 4.5};
    double[] after = {12.5, 4.75, 4.5};
    assertEquals(TraversalResult.HIT, traversal.cast(bits, TurnedRay.of(axis, before, after), hit));
    assertEquals(15.5 / 24, hit.t, 1e-15);
    assertEquals(axis, hit.axis);
    assertEquals(TraversalResult.HIT, traversal.cast(bits, TurnedRay.of(axis, after, before), hit));
    assertEquals(7.5 / 24, hit.t, 1e-15);
    assertEquals(axis, hit.axis);
    assertEquals(4, hit.i);
    assertEquals(4, hit.j);
    assertEquals(4, hit.k);
    double[] beside = {12.5, 5.75, 4.5};
    assertEquals(
        TraversalResult.MISS, traversal.cast(bits, TurnedRay.of(axis, before, beside), hit));
    double[] tooShort = {3.75, 4.5, 4.5};
    assertEquals(
        TraversalResult.MISS, traversal.cast(bits, TurnedRay.of(axis, before, tooShort), hit));
  }

  /** Rays whose numbers are random come near a tie very rarely. */
  @Test
  void decidesRandomRaysAsTheExhaustiveCasterDoes() {
    long seed = Seeds.seed();
    SplittableRandom random = new SplittableRandom(seed);
    DecidedRays both = new DecidedRays(sparseCube(random), traversal::cast);
    both.assertSame(RandomCases.of(4_000), 0.98, 0.1, () -> randomRay(random), "seed=" + seed);
  }

  private static BitCube sparseCube(SplittableRandom random) {
    BitCube bits = new BitCube(60, 50, 70);
    for (int n = 0; n < 400; n++) {
      int i = random.nextInt(10, 58);
      int j = random.nextInt(10, 48);
      int k = random.nextInt(10, 68);
      bits.set(i, j, k);
      bits.set(i + 1, j, k);
      bits.set(i, j + 1, k + 1);
    }
    return bits;
  }

  private static Ray randomRay(SplittableRandom random) {
    double[] at = new double[6];
    for (int n = 0; n < 6; n++) {
      at[n] = random.nextDouble(-10, 80);
    }
    return ray(at);
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2})
  void aRayThatStartsOnAPlaneIsInDoubt(int axis) {
    BitCube bits = cornersOf(32);
    double[] to = {27.3, 21.4, 18.6};
    Ray onPlane = TurnedRay.of(axis, new double[] {5, 5.3, 6.2}, to);
    assertEquals(TraversalResult.IN_DOUBT, traversal.cast(bits, onPlane, hit));
    Ray nearPlane = TurnedRay.of(axis, new double[] {5 + TINY, 5.3, 6.2}, to);
    assertEquals(TraversalResult.MISS, traversal.cast(bits, nearPlane, hit));
  }

  private static BitCube cornersOf(int edge) {
    BitCube bits = new BitCube(edge, edge, edge);
    bits.set(0, 0, 0);
    bits.set(edge - 1, edge - 1, edge - 1);
    return bits;
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2})
  void aRayThatEndsOnAPlaneIsInDoubt(int axis) {
    BitCube bits = cornersOf(32);
    double[] from = {5.25, 5.375, 6.25};
    Ray onPlane = TurnedRay.of(axis, from, new double[] {20, 21.5, 18.625});
    assertEquals(TraversalResult.IN_DOUBT, traversal.cast(bits, onPlane, hit));
    Ray before = TurnedRay.of(axis, from, new double[] {20 - TINY, 21.5, 18.625});
    assertEquals(TraversalResult.MISS, traversal.cast(bits, before, hit));
  }

  /** All solids lie from 4 on; the ray enters their box at 4, beside the plane at 4 or 5. */
  @ParameterizedTest
  @CsvSource({"0, 1", "0, 2", "1, 1", "1, 2", "2, 1", "2, 2"})
  void aRayThatEntersTheBoundsNearlyOnAnotherPlaneIsInDoubt(int axis, int other) {
    BitCube bits = new BitCube(8, 8, 8);
    bits.set(4, 4, 4);
    bits.set(7, 7, 7);
    for (double at : new double[] {4 + TINY, 5 - TINY, 5 + TINY}) {
      double[] from = {-11.5, 4.25, 4.25};
      double[] to = {9.5, 5.5, 5.625};
      // The ray goes down along this axis as far as it goes along the first.
      from[other] = at + 15.5;
      to[other] = at - 5.5;
      assertEquals(
          TraversalResult.IN_DOUBT,
          traversal.cast(bits, TurnedRay.of(axis, from, to), hit),
          "enters at " + at);
    }
  }

  /** The ray starts in an empty block and leaves it at 32, beside the plane at 22. */
  @ParameterizedTest
  @CsvSource({"0, 1", "0, 2", "1, 1", "1, 2", "2, 1", "2, 2"})
  void aLongStepThatEndsNearlyOnAnotherPlaneIsInDoubt(int axis, int other) {
    BitCube bits = cornersOf(48);
    for (double at : new double[] {22 - TINY, 22 + TINY}) {
      double[] from = {17.5, 19.25, 19.25};
      double[] to = {42.5, 25.5, 25.5};
      // The ray goes up along this axis as far as it goes along the first.
      from[other] = at - 14.5;
      to[other] = at + 10.5;
      assertEquals(
          TraversalResult.IN_DOUBT,
          traversal.cast(bits, TurnedRay.of(axis, from, to), hit),
          "leaves the block at " + at);
    }
  }

  @Test
  void aRayThatHasLeftTheBoundsEndsAtOnce() {
    BitCube bits = cornersOf(8);
    Ray ray = new Ray().from(2.5, 2.25, 3.5).to(9_002.5, 302.75, 4_003.5);
    assertEquals(TraversalResult.MISS, traversal.cast(bits, ray, hit));
    assertTrue(empty.skippedBricks <= 8, "skipped " + empty.skippedBricks);
  }
}
