package org.palpate.raycast;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.palpate.volume.BitCube;

/** Compares a traversal with the exhaustive caster wherever it decides a ray. One thread. */
final class DecidedRays {
  private final ExhaustiveRayCaster exhaustive = new ExhaustiveRayCaster(new ExactPredicates());
  private final RayHit expected = new RayHit();
  private final RayHit hit = new RayHit();
  private final BitCube bits;
  private final Traversal traversal;

  /** The number of rays that were decided. */
  int decided;

  /** The number of these that hit a solid. */
  int hits;

  /** A traversal of one kind. */
  interface Traversal {
    TraversalResult cast(BitCube bits, Ray ray, RayHit hit);
  }

  DecidedRays(BitCube bits, Traversal traversal) {
    this.bits = bits;
    this.traversal = traversal;
  }

  /** Casts a ray, and requires the same answer from both if the traversal decides it. */
  void compare(Ray ray, String what) {
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
