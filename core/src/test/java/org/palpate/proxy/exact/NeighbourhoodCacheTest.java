package org.palpate.proxy.exact;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.collision.CollisionScene;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

class NeighbourhoodCacheTest {
  private static final int EDGE = 24;
  private static final long CENTRE_BIT = 1L << NeighbourhoodCache.CENTRE;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final BitCube bits = new BitCube(EDGE, EDGE, EDGE);
  private final CollisionScene scene = new CollisionScene(List.of(bits));

  @Test
  void eachNeighbourHasItsBitWhateverWasAskedBefore() {
    for (int n = 0; n < EDGE * EDGE * EDGE / 3; n++) {
      bits.set(anywhereInside(), anywhereInside(), anywhereInside());
    }
    NeighbourhoodCache cache = new NeighbourhoodCache(true);
    for (int n = 0; n < 1000; n++) {
      int i = random.nextInt(-2, EDGE + 2);
      int j = random.nextInt(-2, EDGE + 2);
      int k = random.nextInt(-2, EDGE + 2);
      long near = cache.around(scene, i, j, k);
      for (int neighbour = 0; neighbour < 27; neighbour++) {
        int x = neighbour % 3 - 1;
        int y = neighbour / 3 % 3 - 1;
        int z = neighbour / 9 - 1;
        int bit = NeighbourhoodCache.CENTRE + x + 4 * y + 16 * z;
        assertEquals(
            scene.isSolid(i + x, j + y, k + z),
            (near >>> bit & 1) != 0,
            "seed=" + Seeds.seed() + " around " + List.of(i, j, k) + " at " + List.of(x, y, z));
      }
    }
  }

  /** Voxels 3 and 4 lie in windows from 2, voxel 5 in one from 4. */
  @Test
  void voxelsOfOneWindowAreReadOnce() {
    NeighbourhoodCache cache = new NeighbourhoodCache(true);
    cache.around(scene, 3, 3, 3);
    assertEquals(0, cache.hits());
    cache.around(scene, 4, 3, 4);
    cache.around(scene, 3, 4, 3);
    assertEquals(2, cache.hits());
    cache.around(scene, 5, 3, 3);
    cache.around(scene, 3, 5, 3);
    cache.around(scene, 3, 3, 5);
    assertEquals(2, cache.hits());
    cache.around(scene, 3, 3, 3);
    assertEquals(3, cache.hits(), "the windows are kept side by side");
  }

  /** Windows 32 voxels apart share a place in the cache. */
  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2})
  void aWindowIsNotTakenForOneFarAway(int axis) {
    int[] solid = {3, 3, 3};
    bits.set(solid[0], solid[1], solid[2]);
    int[] farAway = solid.clone();
    farAway[axis] += 32;
    NeighbourhoodCache cache = new NeighbourhoodCache(true);
    for (int n = 0; n < 2; n++) {
      assertEquals(CENTRE_BIT, cache.around(scene, solid[0], solid[1], solid[2]) & CENTRE_BIT);
      assertEquals(0, cache.around(scene, farAway[0], farAway[1], farAway[2]) & CENTRE_BIT);
    }
  }

  @Test
  void aChangedVoxelIsSeenAfterForgetOrIfNothingIsKept() {
    NeighbourhoodCache kept = new NeighbourhoodCache(true);
    NeighbourhoodCache notKept = new NeighbourhoodCache(false);
    assertEquals(0, (kept.around(scene, 7, 8, 9) | notKept.around(scene, 7, 8, 9)) & CENTRE_BIT);
    bits.set(7, 8, 9);
    assertEquals(CENTRE_BIT, notKept.around(scene, 7, 8, 9) & CENTRE_BIT);
    assertEquals(0, notKept.hits());
    kept.forget();
    assertEquals(CENTRE_BIT, kept.around(scene, 7, 8, 9) & CENTRE_BIT);
  }

  @Test
  void theStepAlongAnAxisLeadsToTheNeighbour() {
    assertEquals(
        List.of(1, 4, 16),
        List.of(
            NeighbourhoodCache.step(0), NeighbourhoodCache.step(1), NeighbourhoodCache.step(2)));
  }

  private int anywhereInside() {
    return random.nextInt(EDGE);
  }
}
