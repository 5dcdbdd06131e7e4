package org.palpate.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.IntBox;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

class BroadPhaseTest {
  private static final long SEED = Seeds.seed();
  private static final int SIZE = 128;
  private static final int MARGIN = 16;

  private final SplittableRandom random = new SplittableRandom(SEED);

  private BitCube[] cubes(int count) {
    BitCube[] cubes = new BitCube[count];
    for (int n = 0; n < count; n++) {
      cubes[n] = new BitCube(SIZE, SIZE, SIZE);
      int i = random.nextInt(SIZE - 8);
      int j = random.nextInt(SIZE - 8);
      int k = random.nextInt(SIZE - 8);
      for (int voxel = n % 7 == 0 ? 9 : 0; voxel < 5; voxel++) { // some cubes are empty
        cubes[n].set(i + random.nextInt(8), j + random.nextInt(8), k + random.nextInt(8));
      }
    }
    return cubes;
  }

  private static List<Integer> found(BroadPhase phase, IntBox box) {
    int count = phase.find(box.lowX, box.lowY, box.lowZ, box.highX, box.highY, box.highZ);
    List<Integer> indices = new ArrayList<>();
    for (int n = 0; n < count; n++) {
      indices.add(phase.index(n));
    }
    return indices;
  }

  private IntBox randomBox() {
    IntBox box = new IntBox();
    int i = random.nextInt(SIZE);
    int j = random.nextInt(SIZE);
    int k = random.nextInt(SIZE);
    box.include(i, j, k);
    box.include(i + random.nextInt(5), j + random.nextInt(5), k + random.nextInt(5));
    return box;
  }

  private static boolean meet(IntBox a, IntBox b) {
    return !b.isEmpty()
        && a.lowX <= b.highX
        && b.lowX <= a.highX
        && a.lowY <= b.highY
        && b.lowY <= a.highY
        && a.lowZ <= b.highZ
        && b.lowZ <= a.highZ;
  }

  /** Returns the cubes whose solids come within the margin of a box. */
  private static List<Integer> naive(BitCube[] cubes, IntBox box) {
    IntBox grown = new IntBox().set(box).grow(MARGIN);
    List<Integer> near = new ArrayList<>();
    for (int n = 0; n < cubes.length; n++) {
      if (meet(grown, cubes[n].bounds())) {
        near.add(n);
      }
    }
    return near;
  }

  @Test
  void aSearchFindsTheCubesWithinTheMarginInTheirOrder() {
    for (int round = 0; round < 20; round++) {
      BitCube[] cubes = cubes(1 + random.nextInt(60));
      for (int query = 0; query < 20; query++) {
        IntBox box = randomBox();
        BroadPhase phase = new BroadPhase(cubes);
        List<Integer> found = found(phase, box);
        assertEquals(naive(cubes, box), found, "seed=" + SEED);
        assertEquals(1, phase.searches());
        assertEquals(cubes.length - found.size(), phase.skippedCubes());
        for (int n = 0; n < found.size(); n++) {
          assertSame(cubes[found.get(n)], phase.candidates()[n]);
        }
      }
    }
  }

  @Test
  void allCubesMayBeCandidates() {
    BitCube[] cubes = cubes(6);
    cubes[0].set(1, 1, 1);
    IntBox everywhere = new IntBox();
    everywhere.include(0, 0, 0);
    everywhere.include(SIZE, SIZE, SIZE);
    BroadPhase phase = new BroadPhase(cubes);
    assertEquals(List.of(0, 1, 2, 3, 4, 5), found(phase, everywhere), "seed=" + SEED);
    assertEquals(0, phase.skippedCubes());
  }

  @Test
  void queriesWithinTheMarginSearchNoMoreAndMissNothing() {
    BitCube[] cubes = cubes(50);
    BroadPhase phase = new BroadPhase(cubes);
    IntBox first = new IntBox();
    first.include(60, 60, 60);
    List<Integer> kept = found(phase, first);
    int[] ends = {60 - MARGIN, 60 + MARGIN};
    for (int x : ends) {
      for (int y : ends) {
        for (int z : ends) {
          IntBox box = new IntBox();
          box.include(x, y, z);
          assertEquals(kept, found(phase, box));
        }
      }
    }
    assertEquals(1, phase.searches());
    for (int axis = 0; axis < 3; axis++) {
      for (int side = -1; side <= 1; side += 2) {
        BroadPhase fresh = new BroadPhase(cubes);
        found(fresh, first);
        IntBox beyond = new IntBox();
        int far = 60 + side * (MARGIN + 1);
        beyond.include(axis == 0 ? far : 60, axis == 1 ? far : 60, axis == 2 ? far : 60);
        assertEquals(naive(cubes, beyond), found(fresh, beyond), "seed=" + SEED);
        assertEquals(2, fresh.searches(), "axis " + axis + " side " + side);
      }
    }
  }

  @Test
  void aCubeThatWasHandedOutIsAlwaysACandidateOnce() {
    BitCube[] cubes = cubes(40);
    BroadPhase phase = new BroadPhase(cubes);
    IntBox box = randomBox();
    found(phase, box);
    int far = 0;
    while (naive(cubes, box).contains(far)) {
      far++;
    }
    phase.keep(far);
    phase.keep(far);
    List<Integer> expected = new ArrayList<>(naive(cubes, box));
    expected.add(far);
    expected.sort(null);
    assertEquals(expected, found(phase, box), "seed=" + SEED);
    if (!naive(cubes, box).isEmpty()) {
      phase.keep(naive(cubes, box).get(0));
      assertEquals(expected, found(phase, box), "a candidate that is near comes once");
    }
    BroadPhase rebuilt = phase.rebuilt();
    assertEquals(phase.searches(), rebuilt.searches());
    assertEquals(phase.skippedCubes(), rebuilt.skippedCubes());
    assertEquals(expected, found(rebuilt, box));
  }

  @Test
  void aRebuiltPhaseKnowsThePresentBounds() {
    BitCube[] cubes = cubes(20);
    BroadPhase phase = new BroadPhase(cubes);
    IntBox corner = new IntBox();
    corner.include(0, 0, 0);
    found(phase, corner);
    cubes[7].set(0, 0, 0);
    assertTrue(found(phase.rebuilt(), corner).contains(7));
  }
}
