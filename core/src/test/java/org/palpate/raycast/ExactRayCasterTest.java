package org.palpate.raycast;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.statistics.SkipCounters;
import org.palpate.statistics.SkipKind;
import org.palpate.testing.ExactOracle;
import org.palpate.testing.HostileNumbers;
import org.palpate.testing.RandomCases;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

class ExactRayCasterTest {
  private final ExactRayCaster caster = new ExactRayCaster();
  private final RayHit hit = new RayHit();

  @Test
  void hitsAnEdgeSharedByTwoSolids() {
    BitCube bits = new BitCube(4, 4, 4);
    bits.set(1, 2, 1);
    bits.set(2, 1, 1);
    assertTrue(caster.cast(bits, new Ray().from(1.5, 1.5, 1.5).to(2.5, 2.5, 1.5), hit));
    assertEquals(0.5, hit.t);
  }

  @Test
  void hitsACornerThatIsOnlyTouched() {
    BitCube bits = new BitCube(4, 4, 4);
    bits.set(2, 2, 2);
    assertTrue(caster.cast(bits, new Ray().from(1, 3, 1.5).to(3, 1, 2.5), hit));
    assertFalse(caster.cast(bits, new Ray().from(1, 3, 1.5).to(3, 1, Math.nextDown(2.5) - 1), hit));
  }

  @Test
  void aRayInAGridPlaneTouchesTheVoxelsOnBothSides() {
    BitCube bits = new BitCube(8, 4, 4);
    bits.set(5, 1, 1);
    assertTrue(caster.cast(bits, new Ray().from(0.5, 2, 1.5).to(7, 2, 1.5), hit));
    assertEquals(5, hit.i);
    bits.clear(5, 1, 1);
    bits.set(5, 2, 1);
    assertTrue(caster.cast(bits, new Ray().from(0.5, 2, 1.5).to(7, 2, 1.5), hit));
  }

  @Test
  void touchesAVoxelAtTheEndOfTheRay() {
    BitCube bits = new BitCube(8, 4, 4);
    bits.set(5, 1, 1);
    assertTrue(caster.cast(bits, new Ray().from(0.3, 1.5, 1.5).to(5, 1.5, 1.5), hit));
    assertFalse(
        caster.cast(bits, new Ray().from(0.3, 1.5, 1.5).to(Math.nextDown(5.0), 1.5, 1.5), hit));
  }

  @Test
  void crossesAChainOfThreeNearTiesAsOne() {
    BitCube bits = new BitCube(4, 7, 14);
    bits.set(0, 3, 11);
    bits.set(0, 0, 12);
    Ray ray = new Ray().from(6.9373795814663115, 1.5, 10.511562080284987);
    assertTrue(caster.cast(bits, ray.to(0.0, 3.0, 11.000000000000002), hit));
  }

  /** Returns a ray along an axis whose other coordinates are {@code beside} and {@code across}. */
  private static Ray along(int axis, double from, double to, double beside, double across) {
    double[] start = new double[3];
    start[axis] = from;
    start[(axis + 1) % 3] = beside;
    start[(axis + 2) % 3] = across;
    double[] end = start.clone();
    end[axis] = to;
    return new Ray().from(start[0], start[1], start[2]).to(end[0], end[1], end[2]);
  }

  /** The only solid is the voxel (4, 4, 4), so that its faces are those of all solids. */
  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2})
  void aRayThatOnlyTouchesTheBoundsOfAllSolidsHits(int axis) {
    BitCube bits = new BitCube(8, 8, 8);
    bits.set(4, 4, 4);
    assertTrue(caster.cast(bits, along(axis, 2, 4, 4.5, 4.5), hit), "ends on the lower face");
    assertTrue(caster.cast(bits, along(axis, 4, 2, 4.5, 4.5), hit), "starts on the lower face");
    assertTrue(caster.cast(bits, along(axis, 7, 5, 4.5, 4.5), hit), "ends on the upper face");
    assertTrue(caster.cast(bits, along(axis, 5, 7, 4.5, 4.5), hit), "starts on the upper face");
    assertTrue(caster.cast(bits, along(axis, 2, 7, 4, 4.5), hit), "runs within a face");
    assertTrue(caster.cast(bits, along(axis, 2, 7, 5, 4.5), hit), "runs within the other face");
  }

  /** A ray within a grid plane is cast in the layers on both sides of the plane. */
  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2})
  void aRayWithinAPlaneMeetsTheFirstLayerOfAllSolids(int axis) {
    BitCube bits = new BitCube(16, 16, 16);
    for (int n = 0; n < 16 * 16; n++) {
      for (int layer : new int[] {2, 3, 12, 13}) {
        int[] cell = new int[3];
        cell[axis] = layer;
        cell[(axis + 1) % 3] = n % 16;
        cell[(axis + 2) % 3] = n / 16;
        bits.set(cell[0], cell[1], cell[2]);
      }
    }
    assertTrue(caster.cast(bits, along(axis, -14.5, 20.5, 5, 5.5), hit));
    assertEquals(2, hit.cell(axis));
    assertEquals(16.5 / 35, hit.t, 1e-15);
    assertEquals(axis, hit.axis);
    assertTrue(caster.cast(bits, along(axis, 25.5, -4.5, 5, 5.5), hit));
    assertEquals(13, hit.cell(axis));
    assertEquals(11.5 / 30, hit.t, 1e-15);
    assertEquals(axis, hit.axis);
  }

  /** Two planes are crossed at once; three of the four voxels around their edge are solid. */
  @Test
  void aTieMeetsAVoxelBehindAFaceBeforeTheOneBehindTheEdge() {
    BitCube bits = new BitCube(4, 4, 4);
    bits.set(1, 0, 0);
    bits.set(0, 1, 0);
    bits.set(1, 1, 0);
    assertTrue(caster.cast(bits, new Ray().from(0.5, 0.5, 0.5).to(1.5, 1.5, 0.5), hit));
    assertEquals(1, hit.i + hit.j, "a neighbour by a face");
    assertEquals(hit.i == 1 ? 0 : 1, hit.axis);
  }

  @Test
  void countsTheRaysBesideAllSolids() {
    BitCube bits = new BitCube(8, 8, 8);
    bits.set(4, 4, 4);
    assertFalse(caster.cast(bits, new Ray().from(0, 3.9, 4.5).to(8, 3.9, 4.5), hit));
    assertFalse(caster.cast(bits, new Ray().from(5.1, 0, 4.5).to(5.1, 8, 4.5), hit));
    assertFalse(caster.cast(bits, new Ray().from(0, 4.5, 5.1).to(8, 4.5, 9), hit));
    assertFalse(caster.cast(new BitCube(8, 8, 8), new Ray().from(0, 0, 0).to(8, 8, 8), hit));
    assertEquals(4, skips(caster, SkipKind.BESIDE_BOUNDS));
    assertFalse(caster.cast(bits, new Ray().from(3, 4.5, 4.5).to(4.5, 8, 4.5), hit));
    assertEquals(4, skips(caster, SkipKind.BESIDE_BOUNDS), "it meets the box, but not the solid");
  }

  @Test
  void passesEmptyBricksAndBlocksInOneStepEach() {
    assertPassesEmptyBricks(new Ray().from(0.5, 5.5, 5.5).to(127.25, 5.6, 5.7), 32);
  }

  /** It starts on a plane, and is cast in the layers on both sides. */
  @Test
  void aRayWithinAPlanePassesEmptyBricksToo() {
    assertPassesEmptyBricks(new Ray().from(0.5, 4, 5.5).to(127.25, 4, 5.5), 2 * 32);
  }

  /** The far corners hold a solid each, so that the bounds are those of the cube. */
  private void assertPassesEmptyBricks(Ray ray, long fewerThan) {
    BitCube bits = new BitCube(128, 8, 8);
    bits.set(0, 0, 0);
    bits.set(127, 7, 7);
    assertFalse(caster.cast(bits, ray, hit));
    long bricks = skips(caster, SkipKind.EMPTY_BRICKS);
    assertTrue(bricks > 0 && bricks < fewerThan, "bricks=" + bricks);
    ExactRayCaster voxelByVoxel = ExactRayCaster.voxelByVoxel();
    assertFalse(voxelByVoxel.cast(bits, ray, hit));
    assertEquals(0, skips(voxelByVoxel, SkipKind.EMPTY_BRICKS));
  }

  @Test
  void aShortRayAmongTheEmptyVoxelsOfABrickEndsAtOnce() {
    BitCube bits = new BitCube(8, 8, 8);
    bits.set(0, 0, 0);
    bits.set(3, 3, 3);
    assertFalse(caster.cast(bits, new Ray().from(1.5, 1.5, 1.5).to(2.5, 2.4, 2.3), hit));
    assertEquals(1, skips(caster, SkipKind.EMPTY_BRICKS));
    assertFalse(caster.cast(bits, new Ray().from(1.5, 1.5, 1.5).to(3.5, 2.4, 3.3), hit));
    assertEquals(2, skips(caster, SkipKind.EMPTY_BRICKS), "no solid in the box of the ray");
    assertFalse(caster.cast(bits, new Ray().from(2.2, 3.2, 3.2).to(3.2, 2.2, 2.1), hit));
    assertEquals(2, skips(caster, SkipKind.EMPTY_BRICKS), "the box of the ray holds a solid");
  }

  private static long skips(ExactRayCaster of, SkipKind kind) {
    SkipCounters counts = new SkipCounters();
    of.addSkips(counts);
    return counts.of(kind);
  }

  /** Three planes crossed within a few roundings of each other, one voxel at the corner solid. */
  @Test
  void agreesWithTheExactOracleWhereRaysPassCornersAtAFewRoundings() {
    long seed = Seeds.seed();
    SplittableRandom random = new SplittableRandom(seed);
    int hits = 0;
    for (int n = 0; n < RandomCases.of(300_000); n++) {
      int[] corner = {random.nextInt(1, 15), random.nextInt(1, 15), random.nextInt(1, 15)};
      BitCube bits = new BitCube(16, 16, 16);
      bits.set(
          corner[0] - random.nextInt(2),
          corner[1] - random.nextInt(2),
          corner[2] - random.nextInt(2));
      bits.set(0, 0, 0); // so that the traversal does not start at the bounds of the one
      bits.set(15, 15, 15);
      Ray ray = n % 2 == 0 ? rayByACorner(random, corner) : chainOfNearTies(random, corner);
      hits += agrees(bits, ray, "seed=" + seed + " ray " + n) ? 1 : 0;
    }
    assertTrue(hits > RandomCases.of(10_000), "too few hits to mean anything: " + hits);
  }

  /** Returns a ray that ends within some roundings of a corner, or goes on as far again. */
  private static Ray rayByACorner(SplittableRandom random, int[] corner) {
    double[] from = new double[3];
    double[] to = new double[3];
    double length = new double[] {1, 4, 12}[random.nextInt(3)];
    boolean goesOn = random.nextInt(3) == 0;
    for (int axis = 0; axis < 3; axis++) {
      double at = corner[axis];
      for (int ulps = random.nextInt(-8, 9); ulps != 0; ulps -= Integer.signum(ulps)) {
        at = ulps > 0 ? Math.nextUp(at) : Math.nextDown(at);
      }
      from[axis] = at + random.nextDouble(-length, length);
      to[axis] = goesOn ? at + (at - from[axis]) : at;
    }
    return new Ray().from(from[0], from[1], from[2]).to(to[0], to[1], to[2]);
  }

  /** Returns a ray that ends at a corner of two axes, one doubt after the plane of the third. */
  private static Ray chainOfNearTies(SplittableRandom random, int[] corner) {
    double[] from = new double[3];
    double[] to = {corner[0], corner[1], corner[2]};
    int first = random.nextInt(3);
    for (int axis = 0; axis < 3; axis++) {
      from[axis] = corner[axis] + random.nextDouble(-9, 9);
    }
    double beyond = random.nextInt(1, 9) * Math.ulp(corner[first] + 0.5);
    double length = beyond / (AxisTraversal.DOUBT_RELATIVE * random.nextDouble(0.95, 1.05));
    double side = random.nextBoolean() ? 1 : -1;
    to[first] = corner[first] + side * beyond;
    from[first] = corner[first] - side * length;
    return new Ray().from(from[0], from[1], from[2]).to(to[0], to[1], to[2]);
  }

  @Test
  void agreesWithTheExactOracleOnHostileRays() {
    long seed = Seeds.seed();
    SplittableRandom random = new SplittableRandom(seed);
    int hits = 0;
    for (int scene = 0; scene < RandomCases.of(300); scene++) {
      BitCube bits = randomCube(random);
      for (int n = 0; n < 300; n++) {
        Ray ray = hostileRay(random, bits);
        hits += agrees(bits, ray, "seed=" + seed + " scene=" + scene + " ray " + n) ? 1 : 0;
      }
    }
    assertTrue(hits > RandomCases.of(10_000), "too few hits to mean anything: " + hits);
  }

  @Test
  void agreesWithTheExhaustiveCasterOnLongRaysThroughEmptyBricks() {
    long seed = Seeds.seed();
    SplittableRandom random = new SplittableRandom(seed);
    ExactRayCaster voxelByVoxel = ExactRayCaster.voxelByVoxel();
    ExhaustiveRayCaster exhaustive = new ExhaustiveRayCaster(new ExactPredicates());
    RayHit expected = new RayHit();
    int hits = 0;
    for (int scene = 0; scene < 40; scene++) {
      BitCube bits = clusters(random);
      for (int n = 0; n < RandomCases.of(500); n++) {
        Ray ray = longRay(random);
        String what = "seed=" + seed + " scene=" + scene + " ray " + n + " " + ray;
        boolean found = caster.cast(bits, ray, hit);
        assertEquals(exhaustive.cast(bits, ray, expected), found, what);
        assertEquals(found, voxelByVoxel.cast(bits, ray, new RayHit()), what);
        if (found) {
          hits++;
          assertEquals(expected.t, hit.t, 1e-13, what);
          assertTrue(bits.get(hit.i, hit.j, hit.k), what);
          assertTrue(new ExactPredicates().touchesVoxel(ray, hit.i, hit.j, hit.k), what);
        }
      }
    }
    assertTrue(hits > RandomCases.of(2_000), "too few hits to mean anything: " + hits);
  }

  private static BitCube clusters(SplittableRandom random) {
    BitCube bits = new BitCube(90, 61, 130);
    for (int cluster = 0; cluster < 60; cluster++) {
      int i = random.nextInt(90);
      int j = random.nextInt(61);
      int k = random.nextInt(130);
      for (int n = 0; n < 80; n++) {
        bits.set(
            Math.min(89, i + random.nextInt(8)),
            Math.min(60, j + random.nextInt(8)),
            Math.min(129, k + random.nextInt(8)));
      }
    }
    return bits;
  }

  /** Returns a ray anywhere: from outside, along axes and diagonals, on planes and off them. */
  private static Ray longRay(SplittableRandom random) {
    Ray ray =
        new Ray().from(coordinate(random, 90), coordinate(random, 61), coordinate(random, 130));
    ray.to(coordinate(random, 90), coordinate(random, 61), coordinate(random, 130));
    switch (random.nextInt(6)) {
      case 0 -> ray.toX = ray.fromX;
      case 1 -> {
        ray.toY = ray.fromY;
        ray.toZ = ray.fromZ;
      }
      case 2 -> {
        double length = random.nextInt(-60, 60);
        ray.to(ray.fromX + length, ray.fromY + length, ray.fromZ - length);
      }
      default -> {}
    }
    return ray;
  }

  private static double coordinate(SplittableRandom random, int size) {
    double anywhere = random.nextDouble(-40, size + 40);
    return random.nextInt(5) == 0 ? Math.rint(4 * anywhere) / 4 : anywhere;
  }

  private boolean agrees(BitCube bits, Ray ray, String what) {
    double expected = ExactOracle.firstTouch(bits, ray);
    boolean found = caster.cast(bits, ray, hit);
    assertEquals(!Double.isNaN(expected), found, () -> what + " " + ray);
    if (found) {
      assertTrue(bits.get(hit.i, hit.j, hit.k), () -> what + " hit an empty voxel");
      assertTrue(ExactOracle.touches(ray, hit.i, hit.j, hit.k), () -> what + " hit is not touched");
      assertEquals(expected, hit.t, 1e-13, () -> what + " " + ray);
      assertEntersThroughAFaceOfItsAxis(ray, what);
    }
    return found;
  }

  /** The start lies before the face or on it; without an axis, it touches the voxel. */
  private void assertEntersThroughAFaceOfItsAxis(Ray ray, String what) {
    String message = what + " " + ray + " axis " + hit.axis;
    double[] from = {ray.fromX, ray.fromY, ray.fromZ};
    double[] to = {ray.toX, ray.toY, ray.toZ};
    if (hit.axis == RayHit.NO_AXIS) {
      assertTrue(ExactOracle.touches(resting(ray), hit.i, hit.j, hit.k), message);
      assertEquals(0, hit.t, message);
      return;
    }
    double delta = to[hit.axis] - from[hit.axis];
    double face = hit.cell(hit.axis) + (delta > 0 ? 0 : 1);
    assertTrue(delta > 0 ? from[hit.axis] <= face : from[hit.axis] >= face, message);
    assertEquals((face - from[hit.axis]) / delta, hit.t, 1e-13, message);
  }

  private static Ray resting(Ray ray) {
    return new Ray().from(ray.fromX, ray.fromY, ray.fromZ).to(ray.fromX, ray.fromY, ray.fromZ);
  }

  private static BitCube randomCube(SplittableRandom random) {
    BitCube bits = new BitCube(random.nextInt(1, 24), random.nextInt(1, 24), random.nextInt(1, 24));
    long voxels = (long) bits.sizeX() * bits.sizeY() * bits.sizeZ();
    long solids = Math.max(1, (long) (voxels * Math.pow(random.nextDouble(), 4) * 0.5));
    for (long n = 0; n < solids; n++) {
      bits.set(
          random.nextInt(bits.sizeX()), random.nextInt(bits.sizeY()), random.nextInt(bits.sizeZ()));
    }
    return bits;
  }

  private static Ray hostileRay(SplittableRandom random, BitCube bits) {
    Ray ray = new Ray();
    ray.from(
        HostileNumbers.coordinate(random, bits.sizeX()),
        HostileNumbers.coordinate(random, bits.sizeY()),
        HostileNumbers.coordinate(random, bits.sizeZ()));
    switch (random.nextInt(4)) {
      case 0 -> diagonal(ray, random);
      case 1 -> {
        ray.to(ray.fromX, ray.fromY, ray.fromZ);
        step(ray, random);
      }
      default ->
          ray.to(
              HostileNumbers.coordinate(random, bits.sizeX()),
              HostileNumbers.coordinate(random, bits.sizeY()),
              HostileNumbers.coordinate(random, bits.sizeZ()));
    }
    return ray;
  }

  private static void diagonal(Ray ray, SplittableRandom random) {
    double length = random.nextInt(1, 12);
    ray.to(
        ray.fromX + random.nextInt(-1, 2) * length,
        ray.fromY + random.nextInt(-1, 2) * length,
        ray.fromZ + random.nextInt(-1, 2) * length);
  }

  private static void step(Ray ray, SplittableRandom random) {
    double[] steps = {0, 0x1p-20, -0x1p-20, 0.5, 1, -1, Double.MIN_VALUE, 1e-310, 3};
    ray.toX += steps[random.nextInt(steps.length)];
    ray.toY += steps[random.nextInt(steps.length)];
    ray.toZ += steps[random.nextInt(steps.length)];
  }
}
