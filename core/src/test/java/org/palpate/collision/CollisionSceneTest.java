package org.palpate.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayHit;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

class CollisionSceneTest {
  private static final int SIZE = 64;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 3, 4, 7, 8, 9, 100, 1000})
  void treeFindsTheSameBoxesAsATestOfEachBox(int count) {
    IntBox[] boxes = new IntBox[count];
    for (int n = 0; n < count; n++) {
      boxes[n] = random.nextInt(20) == 0 ? new IntBox() : box();
    }
    BoundingVolumeTree tree = new BoundingVolumeTree(boxes);
    int[] found = new int[count];
    for (int n = 0; n < 300; n++) {
      IntBox query = box();
      List<Integer> indices = new ArrayList<>();
      int foundCount = tree.find(query, found);
      for (int at = 0; at < foundCount; at++) {
        indices.add(found[at]);
      }
      indices.sort(null);
      assertEquals(naive(boxes, query), indices, "seed " + Seeds.seed());
    }
  }

  @Test
  void aCubeHandedOutForEditingStaysACandidateAfterBoundsChanged() {
    List<BitCube> cubes = new ArrayList<>();
    for (int n = 0; n < 12; n++) {
      BitCube cube = new BitCube(256, 16, 16);
      cube.set(20 * n, 1, 1);
      cubes.add(cube);
    }
    CollisionScene scene = new CollisionScene(cubes);
    BitCube edited = scene.cube(11);
    scene.boundsChanged();
    edited.set(10, 8, 8);
    assertTrue(scene.isSolid(10, 8, 8));
  }

  private static List<Integer> naive(IntBox[] boxes, IntBox query) {
    List<Integer> indices = new ArrayList<>();
    for (int n = 0; n < boxes.length; n++) {
      if (shareACell(boxes[n], query)) {
        indices.add(n);
      }
    }
    return indices;
  }

  private static boolean shareACell(IntBox a, IntBox b) {
    for (int k = Math.max(a.lowZ, b.lowZ); k <= Math.min(a.highZ, b.highZ); k++) {
      for (int j = Math.max(a.lowY, b.lowY); j <= Math.min(a.highY, b.highY); j++) {
        for (int i = Math.max(a.lowX, b.lowX); i <= Math.min(a.highX, b.highX); i++) {
          return a.contains(i, j, k) && b.contains(i, j, k);
        }
      }
    }
    return false;
  }

  private IntBox box() {
    IntBox box = new IntBox();
    box.include(random.nextInt(SIZE), random.nextInt(SIZE), random.nextInt(SIZE));
    box.include(
        box.lowX + random.nextInt(9), box.lowY + random.nextInt(9), box.lowZ + random.nextInt(9));
    return box;
  }

  @Test
  void broadPhaseChangesNoAnswerWhileCubesAreEdited() {
    List<BitCube> cubes = cubes(120);
    CollisionScene all = CollisionScene.withoutBroadPhase(cubes);
    CollisionScene near = new CollisionScene(cubes);
    ExactRayCaster caster = new ExactRayCaster();
    RayHit expected = new RayHit();
    RayHit hit = new RayHit();
    int hits = 0;
    for (int n = 0; n < 20_000; n++) {
      String what = "seed " + Seeds.seed() + " n=" + n;
      int i = coordinate();
      int j = coordinate();
      int k = coordinate();
      assertEquals(all.isSolid(i, j, k), near.isSolid(i, j, k), what);
      assertEquals(all.objectAt(i, j, k), near.objectAt(i, j, k), what);
      assertEquals(all.window(i, j, k), near.window(i, j, k), what);
      assertEquals(all.brick(i >> 2, j >> 2, k >> 2), near.brick(i >> 2, j >> 2, k >> 2), what);
      Ray ray = new Ray().from(i + random.nextDouble(), j, k + 0.5);
      ray.to(i + random.nextDouble(-30, 30), j + random.nextDouble(-3, 3), coordinate());
      boolean found = all.cast(caster, ray, expected);
      assertEquals(found, near.cast(caster, ray, hit), what);
      if (found) {
        hits++;
        assertEquals(expected.t, hit.t, what);
        assertEquals(expected.i, hit.i, what);
        assertEquals(expected.axis, hit.axis, what);
      }
      if (n % 100 == 0) {
        near.cube(random.nextInt(cubes.size())).set(inside(), inside(), inside());
      }
    }
    assertTrue(hits > 2_000, "too few hits to mean anything: " + hits);
    assertEquals(0, all.searches());
    assertTrue(near.searches() > 0);
  }

  @Test
  void findsTheSolidsOfAReplacedCube() {
    List<BitCube> cubes = cubes(20);
    CollisionScene near = new CollisionScene(cubes);
    BitCube fresh = new BitCube(SIZE, SIZE, SIZE);
    fresh.set(63, 63, 63);
    boolean before = near.isSolid(63, 63, 63);
    near.replace(5, fresh);
    assertTrue(near.isSolid(63, 63, 63), "before: " + before);
  }

  @Test
  void broadPhaseChangesNoPathOfAPoint() {
    List<BitCube> cubes = cubes(200);
    GridMetric metric = new GridMetric(1, 1, 1);
    CollisionScene[] scenes = {
      CollisionScene.withoutBroadPhase(cubes), CollisionScene.withBroadPhase(cubes)
    };
    GuardedSolver[] solvers = {new GuardedSolver(metric, 8), new GuardedSolver(metric, 8)};
    InteractionPoint[] points = {new InteractionPoint(), new InteractionPoint()};
    Vec3 device = new Vec3(-2.5, -2.5, -2.5);
    points[0].position.set(device);
    points[1].position.set(device);
    for (int frame = 0; frame < 3_000; frame++) {
      for (int axis = 0; axis < 3; axis++) {
        device.set(axis, device.get(axis) + random.nextDouble(-0.9, 1));
        device.set(axis, device.get(axis) > SIZE ? -1.5 : device.get(axis));
      }
      solvers[0].follow(scenes[0], device, points[0]);
      solvers[1].follow(scenes[1], device, points[1]);
      assertTrue(points[0].position.sameBits(points[1].position), "seed " + Seeds.seed());
      assertEquals(points[0].contact, points[1].contact);
    }
  }

  private List<BitCube> cubes(int count) {
    List<BitCube> cubes = new ArrayList<>();
    for (int n = 0; n < count; n++) {
      BitCube cube = new BitCube(SIZE, SIZE, SIZE);
      IntBox box = box();
      for (int voxel = 0; voxel < 60; voxel++) {
        cube.set(
            Math.min(SIZE - 1, box.lowX + random.nextInt(6)),
            Math.min(SIZE - 1, box.lowY + random.nextInt(6)),
            Math.min(SIZE - 1, box.lowZ + random.nextInt(6)));
      }
      cubes.add(cube);
    }
    return cubes;
  }

  private int coordinate() {
    return random.nextInt(-5, SIZE + 5);
  }

  private int inside() {
    return random.nextInt(SIZE);
  }
}
