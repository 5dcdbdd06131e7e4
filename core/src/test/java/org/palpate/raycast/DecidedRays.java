package org.palpate.raycast;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.function.Supplier;
import org.palpate.volume.BitCube;

/** Compares a traversal with the exhaustive caster wherever it decides a ray. One thread. */
final class DecidedRays {
  private final ExhaustiveRayCaster exhaustive = new ExhaustiveRayCaster(new ExactPredicates());
  private final RayHit expected = new RayHit();
  private final RayHit hit = new RayHit();
  private final BitCube bits;
  private final Traversal traversal;

  /** The number of rays that were decided. */
  private int decided;

  /** The number of these that hit a solid. */
  private int hits;

  /** A traversal of one kind. */
  interface Traversal {
    TraversalResult cast(BitCube bits, Ray ray, RayHit hit);
  }

  DecidedRays(BitCube bits, Traversal traversal) {
    this.bits = bits;
    this.traversal = traversal;
  }

  /**
   * Casts rays, and requires the same answer from both wherever the traversal decides.
   *
   * @param leastDecided the least part of the rays that the traversal must decide
   * @param leastHits the part of the rays of which more must hit a solid
   * @param next makes a ray
   * @param what begins the message of a failure
   */
  void assertSame(
      int rays, double leastDecided, double leastHits, Supplier<Ray> next, String what) {
    for (int n = 0; n < rays; n++) {
      Ray ray = next.get();
      compare(ray, what + " ray " + n + " " + ray);
    }
    assertTrue(decided >= leastDecided * rays, what + " decided " + decided + " of " + rays);
    assertTrue(hits > leastHits * rays, what + " too few hits to mean anything: " + hits);
  }

  private void compare(Ray ray, String what) {
    TraversalResult result = traversal.cast(bits, ray, hit);
    if (result == TraversalResult.IN_DOUBT) {
      return;
    }
    decided++;
    boolean found = exhaustive.cast(bits, ray, expected);
    assertEquals(found ? TraversalResult.HIT : TraversalResult.MISS, result, what);
    if (found) {
      hits++;
      assertEquals(expected.t, hit.t, 1e-13, what);
      assertEquals(expected.axis, hit.axis, what);
      assertEquals(expected.cell(0), hit.i, what);
      assertEquals(expected.cell(1), hit.j, what);
      assertEquals(expected.cell(2), hit.k, what);
    }
  }
}
