package org.palpate.proxy.smooth.field;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.collision.CollisionScene;
import org.palpate.testing.RandomCases;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

/** Compares the bricks that are found while a window moves with all tiles of 4x4 voxels. */
class FlatBricksTest {
  private static final int EDGE = 48;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final BitCube bits = new BitCube(EDGE, EDGE, EDGE);
  private final CollisionScene scene = new CollisionScene(List.of(bits));
  private final BrickCopy copy = new BrickCopy(BrickSource.VOXELS);

  /** The bricks that were found and are still in the copy, a bit each. */
  private long found;

  /** The terraces in windows that a brick of the copy holds, and those at its rim. */
  private int seen;

  private int seenAtRim;

  @ParameterizedTest
  @ValueSource(ints = {0b111, 0b011, 0b101, 0b110})
  void everyTerraceInAWindowIsFoundAndNothingElse(int axes) {
    int[] counted = IntStream.range(0, 3).filter(n -> (axes >> n & 1) != 0).toArray();
    for (int n = RandomCases.of(20); n > 0; n--) {
      fill(random.nextInt(3));
      moveAround(new FlatBricks(copy, counted), counted);
    }
    assertTrue(seen > RandomCases.of(2000), "terraces in windows " + seen);
    assertTrue(seenAtRim > RandomCases.of(100), "terraces at the rim of the copy " + seenAtRim);
  }

  /** Fills columns of 4x4 voxels along an axis, some of which stick together; a few are rough. */
  private void fill(int axis) {
    int[][] heights = new int[EDGE / 4][EDGE / 4];
    for (int[] row : heights) {
      for (int n = 0; n < row.length; n++) {
        row[n] = random.nextInt(EDGE);
      }
    }
    int[] at = new int[3];
    for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
      at[0] = n % EDGE;
      at[1] = n / EDGE % EDGE;
      at[2] = n / EDGE / EDGE;
      int height = heights[at[(axis + 1) % 3] / 4][at[(axis + 2) % 3] / 4];
      boolean solid = at[axis] < height != (random.nextInt(400) == 0);
      if (solid) {
        bits.set(at[0], at[1], at[2]);
      } else {
        bits.clear(at[0], at[1], at[2]);
      }
    }
  }

  private void moveAround(FlatBricks flat, int[] axes) {
    copy.forget();
    boolean known = false;
    long reads = 0;
    int[] low = {16, 16, 16};
    int[] first = new int[3];
    for (int n = 0; n < 300; n++) {
      int reach = random.nextInt(8) == 0 ? 12 : 2;
      for (int axis = 0; axis < 3; axis++) {
        low[axis] += random.nextInt(-reach, reach + 1);
        low[axis] = Math.max(-6, Math.min(EDGE - 6, low[axis]));
      }
      copy.cover(scene, low[0], low[1], low[2]);
      if (!known || copy.reads() != reads) {
        int byX = (copy.lowX() >> 2) - first[0];
        int byY = (copy.lowY() >> 2) - first[1];
        int byZ = (copy.lowZ() >> 2) - first[2];
        long kept = known ? BrickCopy.overlap(byX, byY, byZ) : 0;
        found = kept & BrickCopy.moved(found, byX, byY, byZ);
        found |= flat.find(kept, BrickCopy.number(byX, byY, byZ));
        reads = copy.reads();
        known = true;
        first[0] = copy.lowX() >> 2;
        first[1] = copy.lowY() >> 2;
        first[2] = copy.lowZ() >> 2;
      }
      found |=
          flat.findAtRim(scene, low[0] - copy.lowX(), low[1] - copy.lowY(), low[2] - copy.lowZ());
      check(low, axes);
    }
  }

  private void check(int[] low, int[] axes) {
    for (int brick = 0; brick < 64; brick++) {
      boolean any = false;
      for (int axis : axes) {
        for (int layer = 0; layer < 4; layer++) {
          boolean terrace = isTerrace(brick, axis, layer);
          any |= terrace;
          if (terrace && isInWindow(brick, axis, layer, low)) {
            seen++;
            int inCopy = 4 * (brick >> (2 * axis) & 3) + layer;
            seenAtRim += inCopy == 0 || inCopy == 15 ? 1 : 0;
            assertTrue((found >>> brick & 1) != 0, "seed=" + Seeds.seed() + " brick=" + brick);
          }
        }
      }
      assertTrue(any || (found >>> brick & 1) == 0, "seed=" + Seeds.seed() + " brick=" + brick);
    }
  }

  /** Returns the coordinate of a brick's first voxel along an axis. */
  private int first(int brick, int axis) {
    int low = axis == 0 ? copy.lowX() : axis == 1 ? copy.lowY() : copy.lowZ();
    return low + 4 * (brick >> (2 * axis) & 3);
  }

  /** Whether a layer of a brick is empty, and one beside it solid. */
  private boolean isTerrace(int brick, int axis, int layer) {
    return isUniform(brick, axis, layer, false)
        && (isUniform(brick, axis, layer - 1, true) || isUniform(brick, axis, layer + 1, true));
  }

  private boolean isUniform(int brick, int axis, int layer, boolean solid) {
    int[] at = new int[3];
    for (int n = 0; n < 16; n++) {
      int across = (axis + 1) % 3;
      int other = (axis + 2) % 3;
      at[axis] = first(brick, axis) + layer;
      at[across] = first(brick, across) + n % 4;
      at[other] = first(brick, other) + n / 4;
      if (bits.get(at[0], at[1], at[2]) != solid) {
        return false;
      }
    }
    return true;
  }

  /** Whether a window holds a voxel of a layer of a brick. */
  private boolean isInWindow(int brick, int axis, int layer, int[] low) {
    for (int n = 0; n < 3; n++) {
      int begin = first(brick, n) + (n == axis ? layer : 0);
      int end = n == axis ? begin : begin + 3;
      if (end < low[n] || begin >= low[n] + BinaryWindow.EDGE) {
        return false;
      }
    }
    return true;
  }

  @Test
  void aBitIsInOneLayerAcrossEachAxis() {
    for (int bit = 0; bit < 64; bit++) {
      for (int axis = 0; axis < 3; axis++) {
        int layer = 1 << (bit >> (2 * axis) & 3);
        assertEquals(0xF & ~layer, FlatBricks.emptyLayers(1L << bit, axis), "bit " + bit);
        boolean first = (FlatBricks.outermost(axis, -1) >>> bit & 1) != 0;
        boolean last = (FlatBricks.outermost(axis, 1) >>> bit & 1) != 0;
        assertEquals(layer == 1, first, "bit " + bit);
        assertEquals(layer == 8, last, "bit " + bit);
      }
    }
  }
}
