package org.palpate.volume;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.testing.Seeds;
import org.palpate.volume.phantom.Phantom;

class EnclosedSpaceTest {
  private static final int[][] DIRECTIONS = {
    {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}
  };

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());

  @Test
  void aVoxelBelongsToTheSpaceAsAPlainWalkInEachDirectionFindsIt() {
    long found = 0;
    for (int run = 0; run < 40; run++) {
      BitCube outer = noise(0.02 + 0.2 * random.nextDouble());
      BitCube inner = noise(0.2 * random.nextDouble());
      BitCube space = EnclosedSpace.between(outer, inner, List.of(outer, inner));
      for (int k = 0; k < outer.sizeZ(); k++) {
        for (int j = 0; j < outer.sizeY(); j++) {
          for (int i = 0; i < outer.sizeX(); i++) {
            boolean expected =
                !outer.get(i, j, k)
                    && !inner.get(i, j, k)
                    && seen(outer, i, j, k) >= 5
                    && seen(inner, i, j, k) < 6;
            assertEquals(expected, space.get(i, j, k), run + ": " + i + " " + j + " " + k);
          }
        }
      }
      found += space.solidCount();
    }
    assertTrue(found > 1000, "found " + found);
  }

  /** Returns the number of directions in which a walk from a voxel meets a solid one. */
  private static int seen(BitCube bits, int i, int j, int k) {
    int seen = 0;
    for (int[] step : DIRECTIONS) {
      boolean met = false;
      for (int n = 1; n < 32; n++) {
        met |= bits.get(i + n * step[0], j + n * step[1], k + n * step[2]);
      }
      seen += met ? 1 : 0;
    }
    return seen;
  }

  private BitCube noise(double density) {
    BitCube bits = new BitCube(13, 11, 17);
    for (int k = 0; k < bits.sizeZ(); k++) {
      for (int j = 0; j < bits.sizeY(); j++) {
        for (int i = 0; i < bits.sizeX(); i++) {
          if (random.nextDouble() < density) {
            bits.set(i, j, k);
          }
        }
      }
    }
    return bits;
  }

  @Test
  void theHeadHasTissueBelowTheSkinButNotInTheSkullOrAroundTheHead() {
    SegmentedVolume head = Phantom.parse("head:128").segments();
    List<BitCube> solids = head.segments().stream().map(Segment::bits).toList();
    BitCube space = EnclosedSpace.between(solids.get(2), solids.get(0), solids);
    assertTrue(space.get(64, 79, 15), "in the neck");
    assertTrue(space.get(64 + 24, 24, 50), "in the cheek");
    assertFalse(space.get(64, 70, 76), "in the cranial cavity");
    assertFalse(space.get(2, 2, 2), "in the air");
    assertFalse(space.get(64, 6, 15), "below the chin");
  }
}
