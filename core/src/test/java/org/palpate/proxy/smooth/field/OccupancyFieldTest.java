package org.palpate.proxy.smooth.field;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.testing.RandomCases;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

class OccupancyFieldTest {
  private static final long SEED = Seeds.seed();
  private static final GridMetric UNIT = new GridMetric(1, 1, 1);
  private static final int[] ISOTROPIC = {6, 5};

  private final Random random = new Random(SEED);

  @Test
  void equalsItsDefinitionOnRandomBits() {
    for (double fraction : new double[] {0.02, 0.2, 0.5, 0.8, 0.97}) {
      compare(randomBits(fraction), UNIT, new int[][] {ISOTROPIC, ISOTROPIC, ISOTROPIC});
    }
  }

  @Test
  void equalsItsDefinitionOnThinWalls() {
    BitCube walls = new BitCube(27, 29, 31);
    for (int j = 0; j < 29; j++) {
      for (int k = 0; k < 31; k++) {
        for (int i = 3; i < 27; i += 4) {
          if (random.nextInt(40) != 0) {
            walls.set(i, j, k);
          }
        }
      }
    }
    compare(walls, UNIT, new int[][] {ISOTROPIC, ISOTROPIC, ISOTROPIC});
  }

  @Test
  void equalsItsDefinitionOnWideTerraces() {
    compare(gentleFaces(), UNIT, new int[][] {ISOTROPIC, ISOTROPIC, ISOTROPIC});
    compareThin(gentleFaces(), new GridMetric(0.7, 0.7, 1.4));
  }

  @Test
  void terracesShowHowAGentleSurfaceRuns() {
    BitCube bits = new BitCube(60, 60, 40);
    fill(bits, (i, j, k) -> k + 0.5 < 10 + (i + 0.5) / 12);
    OccupancyField field = field(new CollisionScene(List.of(bits)), UNIT);
    for (double x = 20; x < 40; x += 0.7) {
      Vec3 point = new Vec3(x, 30, 10 + x / 12 + field.level().mostOffsetEdges());
      FieldSample sample = field.evaluate(cell(point), point);
      assertTrue(sample.hasNormal());
      assertEquals(-1 / Math.sqrt(145), sample.normal().x, 0.045, "at x=" + x);
      assertEquals(0, sample.heightEdges(), 0.1, "at x=" + x);
    }
  }

  @Test
  void longerVoxelsGetNarrowerBoxes() {
    GridMetric flat = new GridMetric(0.7, 0.98, 1.4);
    compareThin(randomBits(0.4), flat, new int[][] {ISOTROPIC, {4, 3}, ISOTROPIC});
  }

  @Test
  void voxelsThatAreLongAlongOneAxisAreCutIntoThinSlices() {
    for (double ratio : new double[] {1.5, 2, 3, 3.3}) {
      for (int axis = 0; axis < 3; axis++) {
        Vec3 spacing = new Vec3(0.7, 0.7, 0.7);
        spacing.set(axis, 0.7 * ratio);
        compareThin(randomBits(0.5), GridMetric.of(spacing));
      }
    }
  }

  @Test
  void voxelsThatAreLongAlongTwoAxesAreCutAlongBoth() {
    for (int axis = 0; axis < 3; axis++) {
      Vec3 spacing = new Vec3(1.6, 1.6, 1.6);
      spacing.set(axis, 0.7);
      spacing.set((axis + 1) % 3, 1.3);
      compareThin(randomBits(0.5), GridMetric.of(spacing));
    }
  }

  /** From a seed in a solid all empty voxels count as reached; that must not outlast the seed. */
  @Test
  void aSeedInASolidDoesNotChangeLaterEvaluations() {
    BitCube wall = new BitCube(24, 24, 24);
    for (int k = 0; k < 24; k++) {
      for (int j = 0; j < 24; j++) {
        wall.set(10, j, k);
      }
    }
    CollisionScene scene = new CollisionScene(List.of(wall));
    Vec3 inSolid = new Vec3(10, 12.5, 12.5);
    Vec3 point = new Vec3(9.7, 12.5, 12.5);
    OccupancyField used = field(scene, UNIT);
    used.evaluate(cell(inSolid), inSolid);
    double fresh = field(scene, UNIT).evaluate(cell(point), point).occupancy();
    assertEquals(fresh, used.evaluate(cell(point), point).occupancy());
    double freshFromSolid = field(scene, UNIT).evaluate(cell(inSolid), point).occupancy();
    assertEquals(freshFromSolid, used.evaluate(cell(inSolid), point).occupancy());
  }

  @Test
  void answersDoNotDependOnEarlierEvaluations() {
    answersDoNotDependOnEarlierEvaluations(randomBits(0.3));
    answersDoNotDependOnEarlierEvaluations(gentleFaces());
  }

  private void answersDoNotDependOnEarlierEvaluations(BitCube bits) {
    CollisionScene scene = new CollisionScene(List.of(bits));
    OccupancyField used = field(scene, UNIT);
    for (int n = 0; n < RandomCases.of(1000); n++) {
      Vec3 point = new Vec3(coordinate(), coordinate(), coordinate());
      FieldSample fresh = field(scene, UNIT).evaluate(cell(point), point);
      FieldSample sample = used.evaluate(cell(point), point);
      assertEquals(fresh.occupancy(), sample.occupancy(), "seed=" + SEED + " at " + point);
      assertEquals(fresh.gz(), sample.gz(), "seed=" + SEED + " at " + point);
      assertEquals(fresh.hxy(), sample.hxy(), "seed=" + SEED + " at " + point);
    }
  }

  /** Cells 128 apart share the slots of the caches. */
  @Test
  void answersDoNotDependOnEvaluationsOfCellsWithTheSameSlots() {
    BitCube first = gentleFaces();
    BitCube second = gentleFaces();
    BitCube both =
        fill(
            new BitCube(155, 29, 31),
            (i, j, k) -> i < 27 ? first.get(i, j, k) : i >= 128 && second.get(i - 128, j, k));
    CollisionScene scene = new CollisionScene(List.of(both));
    for (GridMetric metric : List.of(UNIT, new GridMetric(0.7, 0.7, 1.4))) {
      OccupancyField used = field(scene, metric);
      for (int n = 0; n < RandomCases.of(100); n++) {
        Vec3 point = new Vec3(coordinate(), coordinate(), coordinate());
        for (int side = 0; side < 2; side++) {
          FieldSample fresh = field(scene, metric).evaluate(cell(point), point);
          FieldSample sample = used.evaluate(cell(point), point);
          assertEquals(fresh.occupancy(), sample.occupancy(), "seed=" + SEED + " at " + point);
          assertEquals(fresh.gx(), sample.gx(), "seed=" + SEED + " at " + point);
          point.x += 128;
        }
      }
    }
  }

  @Test
  void aFieldForManyPlacesGivesTheSameAnswers() {
    compareManyPlaces(randomBits(0.3), UNIT);
    compareManyPlaces(randomBits(0.6), UNIT);
    compareManyPlaces(randomBits(0.01), new GridMetric(1, 1, 2));
    compareManyPlaces(gentleFaces(), new GridMetric(0.7, 0.7, 1.4));
  }

  /** Points return to few corners from other seeds, while voxels change from time to time. */
  private void compareManyPlaces(BitCube bits, GridMetric metric) {
    CollisionScene scene = new CollisionScene(List.of(bits));
    OccupancyField many = OccupancyField.ofBits(metric).forManyPlaces();
    OccupancyField plain = OccupancyField.ofBits(metric);
    many.use(scene);
    plain.use(scene);
    for (int n = 0; n < RandomCases.of(2000); n++) {
      if (n % 250 == 249) {
        bits.set(random.nextInt(27), random.nextInt(29), random.nextInt(31));
        many.forget();
        plain.forget();
      }
      Vec3 point = new Vec3(2 + 5 * random.nextDouble(), 9.2 + random.nextDouble(), 12.3);
      Vec3 inSeed = new Vec3(near(point.x) + 0.5, near(point.y) + 0.5, near(point.z) + 0.5);
      FieldSample expected = plain.evaluate(cell(inSeed), point);
      FieldSample sample = many.evaluate(cell(inSeed), point);
      assertEquals(expected.occupancy(), sample.occupancy(), "seed=" + SEED + " at " + point);
      assertEquals(expected.gx(), sample.gx(), "seed=" + SEED + " at " + point);
      assertEquals(expected.hyz(), sample.hyz(), "seed=" + SEED + " at " + point);
    }
  }

  @Test
  void theSameQuestionIsNotEvaluatedAgain() {
    CollisionScene scene = new CollisionScene(List.of(randomBits(0.3)));
    OccupancyField field = field(scene, UNIT);
    Vec3 point = new Vec3(12.2, 13.3, 14.4);
    long first = field.evaluate(cell(point), point).evaluation();
    assertEquals(first, field.evaluate(cell(point), point).evaluation());
    assertEquals(1, field.windowReads());
    assertEquals(first + 1, field.evaluate(cell(point), new Vec3(12.3, 13.3, 14.4)).evaluation());
    assertEquals(1, field.windowReads());
  }

  @Test
  void derivativesAreThoseOfTheOccupancy() {
    GridMetric metric = new GridMetric(0.7, 1.4, 2.1);
    OccupancyField field = field(new CollisionScene(List.of(randomBits(0.3))), metric);
    double h = 1e-5;
    for (int n = 0; n < RandomCases.of(300); n++) {
      Vec3 p = awayFromHalves();
      FieldSample sample = field.evaluate(cell(p), p);
      double gx = sample.gx();
      double gz = sample.gz();
      double hzz = sample.hzz();
      double hxy = sample.hxy();
      double right = field.evaluate(cell(p), new Vec3(p.x + h, p.y, p.z)).occupancy();
      double left = field.evaluate(cell(p), new Vec3(p.x - h, p.y, p.z)).occupancy();
      assertEquals((right - left) / (2 * h), gx, 1e-6, "seed=" + SEED);
      field.evaluate(cell(p), new Vec3(p.x, p.y, p.z + h));
      double up = sample.occupancy();
      double upSlope = sample.gz();
      field.evaluate(cell(p), new Vec3(p.x, p.y, p.z - h));
      assertEquals((up - sample.occupancy()) / (2 * h * 3), gz, 1e-6, "seed=" + SEED);
      assertEquals((upSlope - sample.gz()) / (2 * h * 3), hzz, 1e-6, "seed=" + SEED);
      double back = field.evaluate(cell(p), new Vec3(p.x, p.y + h, p.z)).gx();
      double front = field.evaluate(cell(p), new Vec3(p.x, p.y - h, p.z)).gx();
      assertEquals((back - front) / (2 * h * 2), hxy, 1e-6, "seed=" + SEED);
    }
  }

  @Test
  void theNormalPointsOutOfAPlaneAndTheHeightIsTheDistance() {
    BitCube floor = new BitCube(40, 40, 40);
    for (int j = 0; j < 40; j++) {
      for (int i = 0; i < 40; i++) {
        for (int k = 0; k < 20; k++) {
          floor.set(i, j, k);
        }
      }
    }
    OccupancyField field = field(new CollisionScene(List.of(floor)), UNIT);
    Vec3 point = new Vec3(20.3, 20.4, 20 + field.level().mostOffsetEdges());
    FieldSample sample = field.evaluate(cell(point), point);
    assertTrue(sample.hasNormal());
    assertEquals(1, sample.normal().z, 1e-9);
    assertEquals(0, sample.heightEdges(), 0.02);
    assertEquals(0, sample.boundedHeightEdges(), 0.02);
    assertEquals(0, sample.curvatureSum(), 1e-9);
    point.z += 0.5;
    assertEquals(0.5, field.evaluate(cell(point), point).boundedHeightEdges(), 0.05);
  }

  @Test
  void aChangedVoxelIsSeenAfterForget() {
    BitCube bits = randomBits(0.1);
    CollisionScene scene = new CollisionScene(List.of(bits));
    OccupancyField field = field(scene, UNIT);
    SeedCell seed = new SeedCell();
    Vec3 point = new Vec3(15.2, 15.2, 15.2);
    double before = field.evaluate(seed, point).occupancy();
    bits.set(15, 15, 16);
    bits.set(16, 15, 16);
    field.forget();
    double after = field.evaluate(seed, point).occupancy();
    assertEquals(field(scene, UNIT).evaluate(seed, point).occupancy(), after);
    assertTrue(after > before);
  }

  @Test
  void changedTerracesAreSeenAfterForgetWhereverTheWindowMovesNext() {
    for (GridMetric metric : List.of(UNIT, new GridMetric(0.7, 0.7, 1.4))) {
      BitCube bits = gentleFaces();
      CollisionScene scene = new CollisionScene(List.of(bits));
      OccupancyField used = field(scene, metric);
      Vec3 point = new Vec3(14, 14, 24);
      for (int n = 0; n < RandomCases.of(300); n++) {
        if (n % 3 == 0) {
          toggleTile(bits, random.nextInt(7), random.nextInt(7), random.nextInt(31));
          used.forget();
        }
        point.set(step(point.x), step(point.y), step(point.z));
        FieldSample fresh = field(scene, metric).evaluate(cell(point), point);
        FieldSample sample = used.evaluate(cell(point), point);
        assertEquals(fresh.occupancy(), sample.occupancy(), "seed=" + SEED + " at " + point);
        assertEquals(fresh.gx(), sample.gx(), "seed=" + SEED + " at " + point);
      }
    }
  }

  /** Adds or removes 4x4 voxels of a layer. */
  private static void toggleTile(BitCube bits, int tileX, int tileY, int k) {
    for (int n = 0; n < 16; n++) {
      int i = Math.min(bits.sizeX() - 1, 4 * tileX + n % 4);
      int j = Math.min(bits.sizeY() - 1, 4 * tileY + n / 4);
      if (bits.get(i, j, k)) {
        bits.clear(i, j, k);
      } else {
        bits.set(i, j, k);
      }
    }
  }

  /** Returns a coordinate at most 3 voxels away, within the solid and beside it. */
  private double step(double from) {
    return Math.max(-4, Math.min(34, from + 6 * random.nextDouble() - 3));
  }

  private void compare(BitCube bits, GridMetric metric, int[][] boxes) {
    CollisionScene scene = new CollisionScene(List.of(bits));
    OccupancyField field = field(scene, metric);
    Vec3 edges = OccupancyField.edges(metric);
    NaiveTerraces terraces = new NaiveTerraces(scene::isSolid, ThinGrid.WHOLE, edges);
    NaiveOccupancyField naive = new NaiveOccupancyField(scene::isSolid, terraces, boxes);
    for (int n = 0; n < RandomCases.of(60); n++) {
      Vec3 point = new Vec3(coordinate(), coordinate(), coordinate());
      int[] seed = {near(point.x), near(point.y), near(point.z)};
      Vec3 inSeed = new Vec3(seed[0] + 0.5, seed[1] + 0.5, seed[2] + 0.5);
      assertEquals(
          naive.occupancy(point, seed),
          field.evaluate(cell(inSeed), point).occupancy(),
          1e-12,
          "seed=" + SEED + " at " + point);
    }
  }

  private void compareThin(BitCube bits, GridMetric metric) {
    compareThin(bits, metric, new int[][] {ISOTROPIC, ISOTROPIC, ISOTROPIC});
  }

  private void compareThin(BitCube bits, GridMetric metric, int[][] boxes) {
    CollisionScene scene = new CollisionScene(List.of(bits));
    OccupancyField field = field(scene, metric);
    Vec3 edges = OccupancyField.edges(metric);
    ThinGrid grid = ThinGrid.ofBits(edges);
    NaiveThinSlices slices = NaiveThinSlices.of(scene::isSolid, grid, edges);
    NaiveOccupancyField naive =
        new NaiveOccupancyField(slices, new NaiveTerraces(slices, grid, edges), boxes);
    for (int n = 0; n < RandomCases.of(15); n++) {
      Vec3 point = new Vec3(coordinate(), coordinate(), coordinate());
      Vec3 inSeed = new Vec3(near(point.x) + 0.5, near(point.y) + 0.5, near(point.z) + 0.5);
      assertEquals(
          naive.occupancy(inCells(point, grid), NaiveThinSlices.seeds(inSeed, grid)),
          field.evaluate(cell(inSeed), point).occupancy(),
          1e-12,
          "seed=" + SEED + " " + grid + " at " + point);
    }
  }

  private static Vec3 inCells(Vec3 point, ThinGrid grid) {
    return new Vec3(
        grid.perVoxel(0) * point.x, grid.perVoxel(1) * point.y, grid.perVoxel(2) * point.z);
  }

  /** Returns a cell at most three voxels away. */
  private int near(double coordinate) {
    return (int) Math.floor(coordinate + random.nextInt(7) - 3);
  }

  private static SeedCell cell(Vec3 position) {
    return new SeedCell().set(position);
  }

  private static OccupancyField field(CollisionScene scene, GridMetric metric) {
    OccupancyField field = OccupancyField.ofBitsOverTerraces(metric);
    field.use(scene);
    return field;
  }

  private BitCube randomBits(double fraction) {
    return fill(new BitCube(27, 29, 31), (i, j, k) -> random.nextDouble() < fraction);
  }

  /** Returns a solid whose six faces bulge, dent and slope a little, with a few holes and bumps. */
  private BitCube gentleFaces() {
    return fill(
        new BitCube(27, 29, 31),
        (i, j, k) ->
            i < 22 - (j - 14) * (j - 14) / 90.0
                && i > 3 + k / 9.0
                && j < 23 + (k - 15) * (k - 15) / 80.0
                && j > 5 + (i + k) / 14.0
                && k < 24 - (i - 13) * (i - 13) / 70.0 - (j - 14) * (j - 14) / 90.0
                && k > 6 - j / 8.0
                && random.nextInt(300) != 0);
  }

  private static BitCube fill(BitCube bits, Solid solid) {
    for (int k = 0; k < bits.sizeZ(); k++) {
      for (int j = 0; j < bits.sizeY(); j++) {
        for (int i = 0; i < bits.sizeX(); i++) {
          if (solid.at(i, j, k)) {
            bits.set(i, j, k);
          }
        }
      }
    }
    return bits;
  }

  private interface Solid {
    boolean at(int i, int j, int k);
  }

  private double coordinate() {
    return random.nextDouble() * 40 - 6;
  }

  /** Returns a point whose neighbours at a small step lie in the same piece of the splines. */
  private Vec3 awayFromHalves() {
    return new Vec3(coordinateInPiece(), coordinateInPiece(), coordinateInPiece());
  }

  private double coordinateInPiece() {
    return random.nextInt(25) + 0.6 + 0.8 * random.nextDouble();
  }

  @Test
  void onVeryLongVoxelsTheIsosurfaceLiesFartherOutsideWhereItIsParallelToTheSlices() {
    IsoLevel level = OccupancyField.ofBits(new GridMetric(1, 1, 10)).level();
    double upright = level.offsetEdges(new Vec3(1, 0, 0));
    double parallel = level.offsetEdges(new Vec3(0, 0, 1));
    assertEquals(upright, level.offsetEdges(new Vec3(0, 1, 0)));
    assertEquals(parallel, level.mostOffsetEdges());
    assertTrue(
        parallel > 5 && upright < 5, parallel + " has to clear half a voxel, not " + upright);
    double last = upright;
    for (int degrees = 10; degrees <= 90; degrees += 10) {
      double angle = Math.toRadians(degrees);
      Vec3 normal = new Vec3(Math.cos(angle), 0, Math.sin(angle));
      double offset = level.offsetEdges(normal);
      assertTrue(offset > last, offset + " at " + degrees + " degrees after " + last);
      assertEquals(0, level.heightEdges(level.occupancy(normal), normal), 1e-9);
      last = offset;
    }
    assertEquals(parallel, last, 1e-9);
    IsoLevel shorter = OccupancyField.ofBits(new GridMetric(1, 1, 5)).level();
    assertEquals(shorter.mostOffsetEdges(), shorter.offsetEdges(new Vec3(1, 0, 0)));
  }
}
