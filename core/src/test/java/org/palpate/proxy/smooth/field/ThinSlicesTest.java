package org.palpate.proxy.smooth.field;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.Vec3;
import org.palpate.testing.RandomCases;
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
    compareAll(edges(axis, ratio), RandomCases.of(60));
  }

  @ParameterizedTest
  @CsvSource({"1, 2, 2", "2, 1, 1.5", "3, 2, 1", "1, 5, 1.3", "1.25, 2, 1"})
  void equalTheirDefinitionAlongTwoAxes(double x, double y, double z) {
    compareAll(new Vec3(x, y, z), 4);
  }

  private void compareAll(Vec3 edges, int bricks) {
    int found = 0;
    for (Solid solid : solids()) {
      fill(solid);
      ThinSlices slices = ThinSlices.of(ThinGrid.ofGrey(edges), edges, true);
      for (int n = 0; n < bricks; n++) {
        int[] brick = randomBrick(edges);
        found += compare(slices, edges, brick);
        found += compare(slices, edges, new int[] {brick[0] + 1, brick[1], brick[2]});
        if (n % 8 == 3) {
          edit();
          slices.forget();
        }
      }
    }
    assertTrue(found > bricks, "too few bricks had a surface: " + found);
  }

  /** Asks one source for cells, and another one for the bricks that hold them. */
  @ParameterizedTest
  @CsvSource({"0, 2", "1, 1.5", "2, 3", "2, 5"})
  void solidCellsAreThoseOfTheBrickWhetherItIsMadeOrNot(int axis, double ratio) {
    Vec3 edges = edges(axis, ratio);
    int solid = 0;
    for (Solid shape : solids()) {
      fill(shape);
      ThinSlices asked = ThinSlices.of(ThinGrid.ofGrey(edges), edges, true);
      ThinSlices made = ThinSlices.of(ThinGrid.ofGrey(edges), edges, false);
      for (int n = 0; n < RandomCases.of(200); n++) {
        int[] at = randomBrick(edges);
        long cells = n % 2 == 0 ? 0x1111_1111_1111_1111L << (n & 3) : random.nextLong();
        boolean expected = (~made.brick(scene, at[0], at[1], at[2]) & cells) == 0;
        String where = "seed=" + SEED + " n=" + n;
        assertEquals(expected, asked.areSolid(scene, at[0], at[1], at[2], cells), where);
        solid += expected ? 1 : 0;
        assertEquals(
            made.brick(scene, at[0], at[1], at[2]), asked.brick(scene, at[0], at[1], at[2]), where);
        assertEquals(expected, asked.areSolid(scene, at[0], at[1], at[2], cells), where);
      }
    }
    assertTrue(solid > 10, "solid " + solid);
  }

  @Test
  void cellsBesideEmptyVoxelsAreKnownNotToBeSolidWithoutInterpolation() {
    Vec3 edges = edges(2, 3);
    fill((i, j, k) -> 2 * (i - 45) + 3 * (k - 45) < 0);
    ThinSlices slices = ThinSlices.of(ThinGrid.ofGrey(edges), edges, true);
    for (int z = 33; z < 36; z++) {
      assertFalse(slices.areSolid(scene, 11, 11, z, 0x8888_8888_8888_8888L));
    }
    assertEquals(0, slices.columns());
    slices.brick(scene, 11, 11, 33);
    assertTrue(slices.columns() > 0, "the surface is there");
  }

  @Test
  void voxelsThatAreVeryLongGetThickerCells() {
    Vec3 edges = edges(2, 16);
    assertEquals(8, ThinGrid.ofBits(edges).perVoxel(2));
    assertEquals(5, ThinGrid.ofGrey(edges).perVoxel(2));
    fill((i, j, k) -> i + 3 * k < 120);
    ThinSlices slices = ThinSlices.of(ThinGrid.ofGrey(edges), edges, true);
    for (int n = 0; n < RandomCases.of(200); n++) {
      compare(slices, edges, randomBrick(edges));
    }
  }

  @Test
  void anInclinedPlaneHasNoTerraces() {
    fill((i, j, k) -> i + 0.5 + 9 * (k + 0.5) < 200);
    Vec3 edges = edges(2, 3);
    ThinSlices slices = ThinSlices.of(ThinGrid.ofGrey(edges), edges, true);
    for (int x = 20; x < 60; x++) {
      int height = 0;
      while (slices.isSolid(scene, x, 40, height)) {
        height++;
      }
      assertEquals((200 - x - 0.5) / 9 * 3, height, 0.75, "at x=" + x);
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {1.06, 1.2, 1.5, 1.7, 2, 2.5, 3, 7.3})
  void theCellInTheMiddleOfAVoxelHasItsBit(double ratio) {
    AxisCut cut = new AxisCut(2, ratio);
    for (Solid solid : solids()) {
      fill(solid);
      ThinSlices slices = ThinSlices.of(ThinGrid.ofBits(edges(2, ratio)), edges(2, ratio), true);
      for (int n = 0; n < 2000; n++) {
        int i = random.nextInt(EDGE);
        int j = random.nextInt(EDGE);
        int k = random.nextInt(EDGE);
        boolean cell = slices.isSolid(scene, i, j, cut.middleOf(k));
        assertEquals(bits.get(i, j, k), cell, () -> i + "," + j + "," + k + " seed=" + SEED);
      }
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {1.06, 1.2, 1.3, 1.5, 2, 2.5, 3, 5})
  void aWallOneSliceThickStaysClosed(double ratio) {
    for (int n = 0; n < 8; n++) {
      Vec3 normal = new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
      normal.mul(1 / normal.length(), normal);
      fill((i, j, k) -> Math.abs(fromMiddle(normal, i, j, (k + 0.5) * ratio - 0.5)) <= ratio / 2);
      ThinSlices slices = ThinSlices.of(ThinGrid.ofBits(edges(2, ratio)), edges(2, ratio), true);
      for (int x = 30; x < 60; x++) {
        for (int y = 30; y < 60; y++) {
          for (int z = 30; z < 60; z++) {
            assertNoHole(slices, normal, new int[] {x, y, z}, ratio);
          }
        }
      }
    }
  }

  /** Checks that an empty cell and the next ones along the axes lie on one side of a wall. */
  private void assertNoHole(ThinSlices slices, Vec3 normal, int[] cell, double ratio) {
    if (slices.isSolid(scene, cell[0], cell[1], cell[2])) {
      return;
    }
    double height = fromMiddle(normal, cell[0], cell[1], cell[2]);
    for (int axis = 0; axis < 3; axis++) {
      int[] next = cell.clone();
      next[axis]++;
      double nextHeight = fromMiddle(normal, next[0], next[1], next[2]);
      assertTrue(
          height * nextHeight > 0 || slices.isSolid(scene, next[0], next[1], next[2]),
          () -> "seed=" + SEED + " ratio=" + ratio + " normal=" + normal + " at " + cell[0]);
    }
  }

  /** Returns the height of a cell's centre above a plane, in cells; the edges are all 1. */
  private static double fromMiddle(Vec3 normal, double x, double y, double z) {
    return normal.x * (x - 44.7) + normal.y * (y - 45.1) + normal.z * (z - 45.3);
  }

  @Test
  void voxelsOfNearlyEqualEdgesStayWhole() {
    assertTrue(ThinGrid.ofBits(new Vec3(1.04, 1, 1.05)).isWhole());
    assertFalse(ThinGrid.ofBits(new Vec3(1.04, 1, 1.06)).isWhole());
    assertTrue(ThinGrid.ofGrey(new Vec3(1, 1.1, 1)).isWhole());
    assertFalse(ThinGrid.ofGrey(new Vec3(1, 1.1, 1.2)).isWhole());
  }

  @Test
  void theLongestEdgeIsCutFirstAndASecondOneOnlyIfItIsLong() {
    assertEquals(List.of(new AxisCut(2, 1.4)), ThinGrid.ofBits(new Vec3(1.3, 1, 1.4)).cuts());
    assertEquals(
        List.of(new AxisCut(0, 3), new AxisCut(2, 2)), ThinGrid.ofBits(new Vec3(3, 1, 2)).cuts());
    assertEquals(
        List.of(new AxisCut(1, 1.3), new AxisCut(0, 1.2)),
        ThinGrid.ofGrey(new Vec3(1.2, 1.3, 1)).cuts());
  }

  @Test
  void everyCellBelongsToThePairThatHoldsItsCentre() {
    for (double ratio : new double[] {1.2, 1.5, 1.7, 2, 2.3, 3, 4.9, 5, 10}) {
      AxisCut cut = new AxisCut(2, ratio);
      for (int cell = -500; cell < 500; cell++) {
        int pair = cut.pairOf(cell);
        assertTrue(cut.firstOfPair(pair) <= cell && cell < cut.firstOfPair(pair + 1));
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

  private static Vec3 edges(int axis, double ratio) {
    Vec3 edges = new Vec3(1, 1, 1);
    edges.set(axis, ratio);
    return edges;
  }

  /** Returns a brick in the grid or beside it. */
  private int[] randomBrick(Vec3 edges) {
    ThinGrid grid = ThinGrid.ofGrey(edges);
    int[] brick = new int[3];
    for (int axis = 0; axis < 3; axis++) {
      brick[axis] = random.nextInt((int) (EDGE * grid.perVoxel(axis) / 4) + 4) - 2;
    }
    return brick;
  }

  /** Compares all cells of a brick; returns 1 if it has both kinds, else 0. */
  private int compare(ThinSlices slices, Vec3 edges, int[] brick) {
    NaiveThinSlices naive = NaiveThinSlices.of(scene::isSolid, ThinGrid.ofGrey(edges), edges);
    long expected = 0;
    for (int n = 0; n < 64; n++) {
      int x = 4 * brick[0] + (n & 3);
      int y = 4 * brick[1] + (n >> 2 & 3);
      int z = 4 * brick[2] + (n >> 4);
      expected |= naive.isSolid(x, y, z) ? 1L << n : 0;
    }
    long brickBits = slices.brick(scene, brick[0], brick[1], brick[2]);
    String where =
        "seed=" + SEED + " edges=" + edges + " brick=" + List.of(brick[0], brick[1], brick[2]);
    assertEquals(Long.toHexString(expected), Long.toHexString(brickBits), where);
    int slot = slices.slotOf(scene, brick[0], brick[1], brick[2]);
    for (int n = 0; n < 64; n++) {
      boolean corrected = (slices.slots().corrected(slot) >>> n & 1) != 0;
      double correction = corrected ? slices.slots().correction(slot, n) / 32.0 : 0;
      double occupancy =
          naive.occupancy(
              4 * brick[0] + (n & 3), 4 * brick[1] + (n >> 2 & 3), 4 * brick[2] + (n >> 4));
      assertEquals(occupancy, (brickBits >>> n & 1) + correction, where + " cell " + n);
    }
    return expected != 0 && expected != -1 ? 1 : 0;
  }
}
