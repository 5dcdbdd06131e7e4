package org.palpate.proxy.smooth.field;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.Vec3;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

/** Thin slices equal their definition bit for bit, whatever was read before. */
class ThinSlicesTest {
  private static final long SEED = Seeds.seed();
  private static final int EDGE = 90;

  private final Random random = new Random(SEED);
  private final BitCube bits = new BitCube(EDGE, EDGE, EDGE);
  private final CollisionScene scene = new CollisionScene(List.of(bits));

  @ParameterizedTest
  @CsvSource({
    "0, 2", "1, 2", "2, 1.2", "1, 1.5", "2, 2", "2, 2.4", "0, 3", "2, 3.57", "1, 5", "2, 7.3"
  })
  void equalTheirDefinition(int axis, double ratio) {
    ThinGrid grid = grid(axis, ratio);
    for (Solid solid : solids()) {
      fill(solid);
      ThinSlices slices = new ThinSlices(grid);
      int found = 0;
      for (int n = 0; n < 60; n++) {
        int[] brick = randomBrick(grid);
        found += compare(slices, grid, brick);
        found += compare(slices, grid, new int[] {brick[0] + 1, brick[1], brick[2]});
        if (n % 8 == 0) {
          edit();
          slices.forget();
        }
      }
      assertTrue(found > 0, "no brick had a surface");
    }
  }

  @Test
  void slicesFartherApartThanTenPixelsGetThickerCells() {
    ThinGrid grid = grid(2, 16);
    assertEquals(10, grid.perVoxel());
    fill((i, j, k) -> i + 3 * k < 120);
    ThinSlices slices = new ThinSlices(grid);
    for (int n = 0; n < 200; n++) {
      compare(slices, grid, randomBrick(grid));
    }
  }

  @Test
  void anInclinedPlaneHasNoTerraces() {
    fill((i, j, k) -> i + 0.5 + 9 * (k + 0.5) < 200);
    ThinGrid grid = grid(2, 3);
    ThinSlices slices = new ThinSlices(grid);
    for (int x = 20; x < 60; x++) {
      int height = 0;
      while (slices.isSolid(scene, x, 40, height)) {
        height++;
      }
      assertEquals((200 - x - 0.5) / 9 * 3, height, 0.75, "at x=" + x);
    }
  }

  @Test
  void voxelsOfEqualEdgesAndThoseWithTwoLongEdgesStayWhole() {
    assertTrue(ThinGrid.ofBits(new Vec3(1.2, 1, 1.4)).isWhole());
    assertFalse(ThinGrid.ofBits(new Vec3(1.2, 1, 1.5)).isWhole());
    assertTrue(ThinGrid.ofBits(new Vec3(2, 1, 2)).isWhole());
    assertTrue(ThinGrid.ofGrey(new Vec3(1, 1.1, 1)).isWhole());
    assertFalse(ThinGrid.ofGrey(new Vec3(1, 1.1, 1.2)).isWhole());
    assertTrue(ThinGrid.ofGrey(new Vec3(2, 1, 2)).isWhole());
  }

  @Test
  void everyCellBelongsToThePairThatHoldsItsCentre() {
    for (double ratio : new double[] {1.2, 1.5, 1.7, 2, 2.3, 3, 4.9, 5, 10}) {
      ThinGrid grid = grid(2, ratio);
      for (int cell = -500; cell < 500; cell++) {
        int pair = grid.pairOf(cell);
        assertTrue(grid.firstOfPair(pair) <= cell && cell < grid.firstOfPair(pair + 1));
        assertEquals(Math.floor((cell + 0.5) / ratio - 0.5 + 1e-9), pair, "cell " + cell);
      }
    }
  }

  private interface Solid {
    boolean at(int i, int j, int k);
  }

  /** Returns noise, waves, walls one voxel thick with holes, a gentle cap, and a slope. */
  private List<Solid> solids() {
    return List.of(
        (i, j, k) -> random.nextInt(3) == 0,
        (i, j, k) -> random.nextInt(400) != 0,
        (i, j, k) -> Math.sin(0.3 * i) + Math.sin(0.2 * j + 1) + Math.sin(0.4 * k + 2) > 0.2,
        (i, j, k) -> (i % 9 == 0 || j % 11 == 0 || k % 7 == 0) && random.nextInt(40) != 0,
        (i, j, k) -> (i - 45) * (i - 45) + (j - 45) * (j - 45) + 60 * (k - 30) * (k - 30) < 1900,
        (i, j, k) -> i + 2 * j + 17 * k < 900);
  }

  private void fill(Solid solid) {
    for (int k = 0; k < EDGE; k++) {
      for (int j = 0; j < EDGE; j++) {
        for (int i = 0; i < EDGE; i++) {
          if (solid.at(i, j, k)) {
            bits.set(i, j, k);
          } else {
            bits.clear(i, j, k);
          }
        }
      }
    }
  }

  /** Flips some voxels. */
  private void edit() {
    for (int n = 0; n < 50; n++) {
      int i = random.nextInt(EDGE);
      int j = random.nextInt(EDGE);
      int k = random.nextInt(EDGE);
      if (bits.get(i, j, k)) {
        bits.clear(i, j, k);
      } else {
        bits.set(i, j, k);
      }
    }
  }

  private static ThinGrid grid(int axis, double ratio) {
    Vec3 edges = new Vec3(1, 1, 1);
    edges.set(axis, ratio);
    return ThinGrid.ofGrey(edges);
  }

  /** Returns a brick in the grid or beside it. */
  private int[] randomBrick(ThinGrid grid) {
    int[] brick = new int[3];
    for (int axis = 0; axis < 3; axis++) {
      brick[axis] = random.nextInt((int) (EDGE * grid.perVoxel(axis) / 4) + 4) - 2;
    }
    return brick;
  }

  /** Compares all cells of a brick; returns 1 if it has both kinds, else 0. */
  private int compare(ThinSlices slices, ThinGrid grid, int[] brick) {
    int reach = 4 * Math.min(6, (int) Math.ceil(2 * grid.perVoxel()));
    NaiveThinSlices naive = new NaiveThinSlices(scene, grid.axis(), grid.perVoxel(), reach);
    long expected = 0;
    for (int n = 0; n < 64; n++) {
      int x = 4 * brick[0] + (n & 3);
      int y = 4 * brick[1] + (n >> 2 & 3);
      int z = 4 * brick[2] + (n >> 4);
      expected |= naive.isSolid(x, y, z) ? 1L << n : 0;
    }
    long brickBits = slices.brick(scene, brick[0], brick[1], brick[2]);
    assertEquals(
        Long.toHexString(expected),
        Long.toHexString(brickBits),
        "seed=" + SEED + " grid=" + grid + " brick=" + List.of(brick[0], brick[1], brick[2]));
    return expected != 0 && expected != -1 ? 1 : 0;
  }
}
