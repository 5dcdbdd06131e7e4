package org.palpate.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.IntBox;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayCaster;
import org.palpate.raycast.RayHit;
import org.palpate.statistics.SkipCounters;
import org.palpate.statistics.SkipKind;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

/** The answers of a scene, each against the voxels themselves. */
class CollisionSceneQueriesTest {
  private static final int SIZE = 12;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final ExactRayCaster caster = new ExactRayCaster();
  private final RayHit hit = new RayHit();

  private static BitCube cube(int... ijk) {
    BitCube cube = new BitCube(SIZE, SIZE, SIZE);
    for (int n = 0; n < ijk.length; n += 3) {
      cube.set(ijk[n], ijk[n + 1], ijk[n + 2]);
    }
    return cube;
  }

  private List<BitCube> sparseCubes(int count, int voxels) {
    List<BitCube> cubes = new ArrayList<>();
    for (int n = 0; n < count; n++) {
      BitCube cube = new BitCube(SIZE, SIZE, SIZE);
      for (int voxel = 0; voxel < voxels; voxel++) {
        cube.set(random.nextInt(SIZE), random.nextInt(SIZE), random.nextInt(SIZE));
      }
      cubes.add(cube);
    }
    return cubes;
  }

  private static List<CollisionScene> bothScenes(List<BitCube> cubes) {
    return List.of(CollisionScene.withoutBroadPhase(cubes), CollisionScene.withBroadPhase(cubes));
  }

  @Test
  void aVoxelIsSolidIfAnyCubeHasItAndBelongsToTheFirstSuchCube() {
    List<BitCube> cubes = sparseCubes(4, 250);
    for (CollisionScene scene : bothScenes(cubes)) {
      for (int n = 0; n < 5_000; n++) {
        int i = random.nextInt(-2, SIZE + 2);
        int j = random.nextInt(-2, SIZE + 2);
        int k = random.nextInt(-2, SIZE + 2);
        int first = -1;
        for (int object = cubes.size() - 1; object >= 0; object--) {
          first = cubes.get(object).get(i, j, k) ? object : first;
        }
        String what = "seed " + Seeds.seed() + " voxel " + i + "," + j + "," + k;
        assertEquals(first, scene.objectAt(i, j, k), what);
        assertEquals(first >= 0, scene.isSolid(i, j, k), what);
      }
    }
  }

  @Test
  void aWindowAndABrickHoldTheVoxelsOfAllCubes() {
    List<BitCube> cubes = sparseCubes(3, 200);
    for (CollisionScene scene : bothScenes(cubes)) {
      for (int n = 0; n < 500; n++) {
        int i = random.nextInt(-5, SIZE + 2);
        int j = random.nextInt(-5, SIZE + 2);
        int k = random.nextInt(-5, SIZE + 2);
        assertEquals(naiveWindow(cubes, i, j, k), scene.window(i, j, k));
        int x = i >> 2;
        int y = j >> 2;
        int z = k >> 2;
        assertEquals(naiveWindow(cubes, 4 * x, 4 * y, 4 * z), scene.brick(x, y, z));
      }
    }
  }

  private static long naiveWindow(List<BitCube> cubes, int i, int j, int k) {
    long word = 0;
    for (int bit = 0; bit < 64; bit++) {
      for (BitCube cube : cubes) {
        if (cube.get(i + bit % 4, j + bit / 4 % 4, k + bit / 16)) {
          word |= 1L << bit;
        }
      }
    }
    return word;
  }

  @Test
  void windowsAtTheEndOfTheIntegersAreEmpty() {
    int last = Integer.MAX_VALUE;
    int first = Integer.MIN_VALUE;
    for (CollisionScene scene : bothScenes(sparseCubes(2, 900))) {
      assertEquals(0, scene.window(last, last, last));
      assertEquals(0, scene.window(first, first, first));
      assertEquals(0, scene.window(last, 0, 0));
      assertEquals(0, scene.brick(last >> 2, 0, 0));
      assertFalse(scene.isSolid(last, first, 0));
    }
  }

  /** A point touches a voxel if it lies in the closed cell, compared as decimal fractions. */
  @Test
  void aPointTouchesEveryClosedVoxelThatHoldsIt() {
    List<BitCube> cubes = sparseCubes(2, 60);
    int touching = 0;
    for (CollisionScene scene : bothScenes(cubes)) {
      for (int n = 0; n < 4_000; n++) {
        double[] p = {coordinate(), coordinate(), coordinate()};
        boolean expected = naiveTouches(cubes, p);
        touching += expected ? 1 : 0;
        assertEquals(
            expected,
            scene.touches(p[0], p[1], p[2]),
            () -> "seed " + Seeds.seed() + " at " + p[0] + " " + p[1] + " " + p[2]);
      }
    }
    assertTrue(touching > 300 && touching < 6_000, "touching: " + touching);
  }

  private double coordinate() {
    double whole = random.nextInt(-1, SIZE + 2);
    return switch (random.nextInt(4)) {
      case 0 -> whole;
      case 1 -> Math.nextUp(whole);
      case 2 -> Math.nextDown(whole);
      default -> whole + random.nextDouble();
    };
  }

  private static boolean naiveTouches(List<BitCube> cubes, double[] p) {
    boolean touches = false;
    for (int k = 0; k < SIZE; k++) {
      for (int j = 0; j < SIZE; j++) {
        for (int i = 0; i < SIZE; i++) {
          for (BitCube cube : cubes) {
            touches |= cube.get(i, j, k) && holds(i, p[0]) && holds(j, p[1]) && holds(k, p[2]);
          }
        }
      }
    }
    return touches;
  }

  private static boolean holds(int cell, double coordinate) {
    BigDecimal exact = new BigDecimal(coordinate);
    return exact.compareTo(BigDecimal.valueOf(cell)) >= 0
        && exact.compareTo(BigDecimal.valueOf(cell + 1L)) <= 0;
  }

  @Test
  void aPointThatIsNotFiniteOrBeyondTheVoxelsTouchesNothing() {
    double[] hostile = {
      Double.NaN,
      Double.POSITIVE_INFINITY,
      Double.NEGATIVE_INFINITY,
      1e300,
      -1e300,
      Integer.MAX_VALUE,
      Integer.MIN_VALUE,
      0x1p40
    };
    for (CollisionScene scene : bothScenes(List.of(cube(0, 0, 0), cube(11, 11, 11)))) {
      assertTrue(scene.touches(0, 0, 0));
      assertTrue(scene.touches(12, 12, 12));
      for (double far : hostile) {
        assertFalse(scene.touches(far, 0, 0), "x=" + far);
        assertFalse(scene.touches(0, far, 0), "y=" + far);
        assertFalse(scene.touches(0, 0, far), "z=" + far);
      }
    }
  }

  @Test
  void aRayMeetsTheNearestVoxelOfAllCubes() {
    List<BitCube> cubes = sparseCubes(5, 12);
    BitCube union = new BitCube(SIZE, SIZE, SIZE);
    for (int k = 0; k < SIZE; k++) {
      for (int j = 0; j < SIZE; j++) {
        for (int i = 0; i < SIZE; i++) {
          for (BitCube cube : cubes) {
            if (cube.get(i, j, k)) {
              union.set(i, j, k);
            }
          }
        }
      }
    }
    RayHit expected = new RayHit();
    int hits = 0;
    for (CollisionScene scene : bothScenes(cubes)) {
      for (int n = 0; n < 4_000; n++) {
        Ray ray = new Ray().from(place(), place(), place()).to(place(), place(), place());
        boolean found = caster.cast(union, ray, expected);
        assertEquals(found, scene.cast(caster, ray, hit), ray::toString);
        if (found) {
          hits++;
          assertEquals(expected.t, hit.t, ray::toString);
        }
      }
    }
    assertTrue(hits > 1_000, "hits: " + hits);
  }

  private double place() {
    return random.nextDouble(-3, SIZE + 3);
  }

  @Test
  void ofEqualHitsThatOfTheFirstObjectCounts() {
    RayCaster byObject = new AlwaysAtHalf();
    List<BitCube> cubes = List.of(cube(1, 0, 0), cube(2, 0, 0), cube(3, 0, 0));
    for (CollisionScene scene : bothScenes(cubes)) {
      assertTrue(scene.cast(byObject, new Ray().from(0, 0, 0).to(9, 0, 0), hit));
      assertEquals(1, hit.i);
    }
  }

  /** Reports the first solid voxel of a row as hit half way, wherever it is. */
  private static final class AlwaysAtHalf implements RayCaster {
    @Override
    public boolean cast(BitCube bits, Ray ray, RayHit dest) {
      int i = 0;
      while (!bits.get(i, 0, 0)) {
        i++;
      }
      dest.set(0.5, i, 0, 0, 0);
      return true;
    }
  }

  @Test
  void aSceneOfOneCubeCastsIntoThatCube() {
    CollisionScene scene = new CollisionScene(List.of(cube(5, 5, 5)));
    assertTrue(scene.cast(caster, new Ray().from(0.5, 5.5, 5.5).to(9.5, 5.5, 5.5), hit));
    assertEquals(5, hit.i);
    assertFalse(scene.cast(caster, new Ray().from(0.5, 3.5, 5.5).to(9.5, 3.5, 5.5), hit));
  }

  @Test
  void theBoundsHoldTheSolidsOfAllCubesAndNothingOfBefore() {
    for (CollisionScene scene : bothScenes(List.of(cube(3, 4, 5), cube(), cube(7, 2, 6)))) {
      IntBox box = new IntBox();
      box.include(-50, 90, 0);
      scene.bounds(box);
      assertEquals(List.of(3, 2, 5), List.of(box.lowX, box.lowY, box.lowZ));
      assertEquals(List.of(7, 4, 6), List.of(box.highX, box.highY, box.highZ));
    }
  }

  @Test
  void aReplacedCubeIsGivenBackAndItsVoxelsAreGone() {
    for (CollisionScene scene : bothScenes(List.of(cube(1, 1, 1), cube(9, 9, 9)))) {
      BitCube former = scene.cube(1);
      BitCube fresh = cube(4, 4, 4);
      assertSame(former, scene.replace(1, fresh));
      assertSame(fresh, scene.cube(1));
      assertFalse(scene.isSolid(9, 9, 9));
      assertEquals(1, scene.objectAt(4, 4, 4));
    }
  }

  @Test
  void aCubeThatGrewByItselfIsFoundOnceTheBoundsWereTakenOver() {
    List<BitCube> cubes = new ArrayList<>();
    for (int n = 0; n < 9; n++) {
      BitCube cube = new BitCube(200, 4, 4);
      cube.set(n, 0, 0);
      cubes.add(cube);
    }
    CollisionScene scene = new CollisionScene(cubes);
    assertFalse(scene.isSolid(180, 0, 0));
    cubes.get(4).set(180, 0, 0);
    assertFalse(scene.isSolid(180, 0, 0), "nine cubes have a broad phase, which knows old bounds");
    scene.boundsChanged();
    assertTrue(scene.isSolid(180, 0, 0));
    assertEquals(4, scene.objectAt(180, 0, 0));
  }

  @Test
  void eightCubesNeedNoBroadPhase() {
    List<BitCube> cubes = new ArrayList<>();
    for (int n = 0; n < 8; n++) {
      cubes.add(new BitCube(200, 4, 4));
    }
    CollisionScene scene = new CollisionScene(cubes);
    assertFalse(scene.isSolid(180, 0, 0));
    cubes.get(4).set(180, 0, 0);
    assertTrue(scene.isSolid(180, 0, 0));
    assertEquals(0, scene.searches());
    scene.boundsChanged();
    assertEquals(0, scene.searches());
  }

  @Test
  void theCubesThatQueriesLeaveOutAreCounted() {
    List<BitCube> cubes = new ArrayList<>();
    for (int n = 0; n < 10; n++) {
      BitCube cube = new BitCube(1_000, 4, 4);
      cube.set(100 * n, 0, 0);
      cubes.add(cube);
    }
    SkipCounters counters = new SkipCounters();
    CollisionScene scene = new CollisionScene(cubes);
    scene.isSolid(300, 0, 0);
    scene.objectAt(300, 0, 0);
    scene.addSkips(counters);
    assertEquals(18, counters.of(SkipKind.FAR_OBJECTS));
    CollisionScene.withoutBroadPhase(cubes).addSkips(counters);
    assertEquals(18, counters.of(SkipKind.FAR_OBJECTS));
  }
}
