package org.palpate.proxy.smooth.field;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;
import org.palpate.testing.RandomCases;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;

/**
 * A field that forgets only what an edit reaches gives the same answers, to the bit, as a field
 * that is made after the edit.
 */
class FieldAfterEditsTest {
  private static final int EDGE = 80;
  private static final int MIDDLE = EDGE / 2;

  /** The middle of domes, across their axis: that of a brick. */
  private static final int DOME = MIDDLE - 2;

  /** The farthest that a correction depends on a voxel, in shortest edges, with a window's half. */
  private static final int FARTHEST = 24 + 8;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final BitCube bits = new BitCube(EDGE, EDGE, EDGE);
  private final CollisionScene scene = new CollisionScene(List.of(bits));
  private final IntBox changed = new IntBox();
  private final List<Vec3> places = new ArrayList<>();

  /** The answers that an edit changed. */
  private int changes;

  /** The answers near a surface. */
  private int onSurface;

  private interface Shape {
    boolean isSolid(int i, int j, int k);
  }

  private void fill(Shape shape) {
    for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
      int i = n % EDGE;
      int j = n / EDGE % EDGE;
      int k = n / (EDGE * EDGE);
      set(i, j, k, shape.isSolid(i, j, k));
    }
    changed.clear();
  }

  /** Sets a voxel, if it is in the cube, and notes it if it changes. */
  private void set(int i, int j, int k, boolean solid) {
    boolean inside = i >= 0 && j >= 0 && k >= 0 && i < EDGE && j < EDGE && k < EDGE;
    if (inside && bits.get(i, j, k) != solid) {
      if (solid) {
        bits.set(i, j, k);
      } else {
        bits.clear(i, j, k);
      }
      changed.include(i, j, k);
    }
  }

  private void turn(int i, int j, int k) {
    set(i, j, k, !bits.get(i, j, k));
  }

  private OccupancyField fresh(GridMetric metric) {
    OccupancyField field = OccupancyField.ofBitsOverTerraces(metric);
    field.use(scene);
    return field;
  }

  /**
   * Fills the caches around all places, edits, and compares the answers there with those of a fresh
   * field. It begins where it was last, so that what is kept from one evaluation to the next
   * counts.
   */
  private void assertSameAfter(Runnable edit, OccupancyField field, OccupancyField fresh) {
    double[] before = new double[places.size()];
    for (int n = 0; n < before.length; n++) {
      before[n] = evaluate(field, places.get(n)).occupancy();
    }
    edit.run();
    if (changed.isEmpty()) {
      return;
    }
    field.forget(changed);
    changed.clear();
    for (int n = before.length - 1; n >= 0; n--) {
      FieldSample expected = evaluate(fresh, places.get(n));
      FieldSample sample = evaluate(field, places.get(n));
      String where = "seed=" + Seeds.seed() + " at " + places.get(n);
      assertEquals(expected.occupancy(), sample.occupancy(), where);
      assertEquals(expected.gx(), sample.gx(), where);
      assertEquals(expected.gy(), sample.gy(), where);
      assertEquals(expected.gz(), sample.gz(), where);
      changes += sample.occupancy() != before[n] ? 1 : 0;
      onSurface += sample.occupancy() > 0.01 && sample.occupancy() < 0.99 ? 1 : 0;
    }
  }

  private static FieldSample evaluate(OccupancyField field, Vec3 place) {
    return field.evaluate(new SeedCell().set(place), place);
  }

  /** Digs at the end of one terrace of stairs, and feels that terrace and those beside it. */
  @ParameterizedTest
  @CsvSource({
    "1, 1, 1",
    "1, 1, 1.2",
    "1, 1, 2",
    "1, 2, 1",
    "2, 1, 1",
    "1, 1, 5",
    "1, 5, 1",
    "5, 1, 1",
    "1, 1, 8",
    "1, 2, 2",
    "3, 1, 2",
    "2, 3, 1",
    "5, 5, 1"
  })
  void theEndOfATerraceReachesAsFarAsInAFreshField(double x, double y, double z) {
    GridMetric metric = new GridMetric(x, y, z);
    for (int axis = 0; axis < 3; axis++) {
      for (int turns = 0; turns < 4; turns++) {
        for (int n = RandomCases.of(1); n > 0; n--) {
          checkStairs(metric, axis, turns);
        }
      }
    }
    assertTrue(changes > RandomCases.of(200), "answers that changed " + changes);
  }

  /**
   * Checks stairs that go up along an axis.
   *
   * @param turns whether the stairs go along the other one of the two axes across, and whether they
   *     go down along it: two bits
   */
  private void checkStairs(GridMetric metric, int up, int turns) {
    int along = (up + 1 + (turns & 1)) % 3;
    int side = (turns & 2) == 0 ? 1 : -1;
    int length = 4 + random.nextInt((int) Math.max(2, 44 / edge(metric, along)));
    int end = MIDDLE + random.nextInt(4);
    int first = MIDDLE - 8 + random.nextInt(4);
    fill(
        (i, j, k) -> {
          int[] at = {i, j, k};
          return at[up] < first + Math.floorDiv(side * (at[along] - end), length);
        });
    OccupancyField field = fresh(metric);
    places.clear();
    int reach = (int) (FARTHEST / edge(metric, along));
    for (int d = -reach; d <= reach; d++) {
      int steps = Math.floorDiv(side * (d + MIDDLE - end), length);
      double above = (1.8 * random.nextDouble() - 0.3) / edge(metric, up);
      double[] at = {MIDDLE + 0.5, MIDDLE + 0.5, MIDDLE + 0.5};
      at[along] = MIDDLE + d + random.nextDouble();
      at[up] = first + steps + above;
      places.add(new Vec3(at[0], at[1], at[2]));
    }
    int[] edited = {MIDDLE, MIDDLE, MIDDLE};
    Runnable edit =
        () -> {
          edited[along] = side > 0 ? end : end - 1;
          edited[up] = first + random.nextInt(-2, 2);
          for (int n = 0; n < 4; n++) {
            turn(edited[0], edited[1], edited[2]);
            edited[along] -= side * random.nextInt(2);
            edited[3 - up - along] += random.nextInt(-1, 2);
          }
        };
    for (int n = 0; n < 3; n++) {
      assertSameAfter(edit, field, fresh(metric));
    }
  }

  private static double edge(GridMetric metric, int axis) {
    return OccupancyField.edges(metric).get(axis);
  }

  /**
   * A dome ends in a terrace at the border of a brick. Its height there depends on the layer below
   * the last one, which is in the next brick: it is two layers away from the corrected one. The dug
   * voxel lies beside the brick of the terrace along both axes across, so that only the terraces
   * across this axis reach it.
   */
  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2})
  void theTopOfADomeFollowsTheLayerBelowItsLast(int up) {
    for (int side = -1; side <= 1; side += 2) {
      for (int last = MIDDLE; last < MIDDLE + 4; last++) {
        checkDome(up, side, last, 20 + random.nextInt(8));
      }
    }
    assertTrue(changes >= 8, "answers that changed " + changes);
  }

  private void checkDome(int up, int side, int last, int radius) {
    GridMetric metric = new GridMetric(1, 1, 1);
    double[] middle = {DOME, DOME, DOME};
    middle[up] = last - side * (radius - 0.5);
    fill(
        (i, j, k) -> {
          double x = i - middle[0];
          double y = j - middle[1];
          double z = k - middle[2];
          return x * x + y * y + z * z < radius * radius;
        });
    OccupancyField field = fresh(metric);
    places.clear();
    double[] top = {DOME + 0.5, DOME + 0.5, DOME + 0.5};
    top[up] = last + 0.5 + side * 1.5;
    places.add(new Vec3(top[0], top[1], top[2]));
    for (int n = 0; n < 4; n++) {
      int[] edited = {DOME, DOME, DOME};
      edited[(up + 1) % 3] += (n & 1) == 0 ? 4 : -5;
      edited[(up + 2) % 3] += (n & 2) == 0 ? 4 : -5;
      edited[up] = last - side;
      assertSameAfter(() -> turn(edited[0], edited[1], edited[2]), field, fresh(metric));
    }
  }

  @ParameterizedTest
  @CsvSource({"1, 1, 1", "1, 1, 2", "1, 1, 5", "2, 1, 1.5", "1, 3, 2"})
  void anyEditsLeaveTheAnswersOfAFreshField(double x, double y, double z) {
    GridMetric metric = new GridMetric(x, y, z);
    fillGentleSurface(metric);
    OccupancyField field = fresh(metric);
    OccupancyField manyPlaces = fresh(metric).forManyPlaces();
    manyPlaces.use(scene);
    for (int n = RandomCases.of(60); n > 0; n--) {
      choosePlaces(metric);
      OccupancyField edited = n % 2 == 0 ? field : manyPlaces;
      OccupancyField other = n % 2 == 0 ? manyPlaces : field;
      Runnable edit =
          () -> {
            editSomewhere(metric);
            if (!changed.isEmpty()) {
              other.forget(changed);
            }
          };
      for (int left = random.nextInt(16); left > 0; left--) {
        edited.readAhead(places.get(left % places.size()));
      }
      assertSameAfter(edit, edited, fresh(metric));
    }
    assertTrue(onSurface > RandomCases.of(60), "near the surface " + onSurface);
  }

  /**
   * In one tile, two columns are solid in the lower slice and two in the upper one. The lower ones
   * depend on the outline of the slice below, which is far away; the upper ones on near outlines.
   */
  @Test
  void aTileFollowsTheFarthestOutlineOfItsColumns() {
    GridMetric metric = new GridMetric(1, 1, 2);
    int tile = MIDDLE;
    fill(
        (i, j, k) ->
            switch (k) {
              case 19 -> i >= tile - 8;
              case 20 -> i >= tile - 10 && i < tile + 2;
              case 21 -> i >= tile + 2 && i < tile + 4;
              default -> false;
            });
    OccupancyField field = fresh(metric);
    places.clear();
    places.add(new Vec3(tile + 0.5, tile + 1.5, 21.2));
    assertSameAfter(() -> turn(tile - 7, tile + 1, 19), field, fresh(metric));
    assertEquals(1, changes);
  }

  /** Half of a pixel's long edge is far longer than the reach of a search. */
  @Test
  void aTileOfVeryLongPixelsFollowsItsOutlineAlongTheirShortEdge() {
    GridMetric metric = new GridMetric(1, 300, 300);
    fill((i, j, k) -> i < MIDDLE + 4 - 8 * (k - 20));
    OccupancyField field = fresh(metric);
    places.clear();
    places.add(new Vec3(MIDDLE - 1.5, MIDDLE + 0.5, 21.1));
    assertSameAfter(() -> turn(MIDDLE + 3, MIDDLE, 20), field, fresh(metric));
    assertEquals(1, changes);
  }

  @ParameterizedTest
  @CsvSource({"1, 1, 1", "1, 1, 2", "1, 1, 5", "2, 1, 1.5"})
  void editsLeaveTheAnswersOfAFreshFieldOfGreyValues(double x, double y, double z) {
    GridMetric metric = new GridMetric(x, y, z);
    fillGentleSurface(metric);
    VoxelGrid grid = VoxelGrid.ofUnitVoxels(EDGE, EDGE, EDGE);
    ScalarVolume volume = ScalarVolume.of(grid, ScalarVolume.Storage.INT16);
    for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
      int i = n % EDGE;
      int j = n / EDGE % EDGE;
      int k = n / (EDGE * EDGE);
      double depth = height(i + 0.5, j + 0.5, metric) - k - 0.5;
      // Four voxels of a row are partly solid, so that each depends on voxels far along the row.
      volume.set(i, j, k, 100 + 120 * Math.max(-1, Math.min(1, depth / 2)));
    }
    OccupancyField field = ofGrey(volume, metric);
    for (int n = RandomCases.of(40); n > 0; n--) {
      choosePlaces(metric);
      Runnable edit =
          () -> {
            editSomewhere(metric);
            if (!changed.isEmpty()) {
              volume.set(
                  random.nextInt(changed.lowX, changed.highX + 1),
                  random.nextInt(changed.lowY, changed.highY + 1),
                  random.nextInt(changed.lowZ, changed.highZ + 1),
                  200 * random.nextDouble());
            }
          };
      assertSameAfter(edit, field, ofGrey(volume, metric));
    }
    assertTrue(onSurface > RandomCases.of(40), "near the surface " + onSurface);
  }

  private OccupancyField ofGrey(ScalarVolume volume, GridMetric metric) {
    GreyIsosurface grey = new GreyIsosurface(volume, 100, 120);
    OccupancyField field = OccupancyField.ofGrey(metric, new GreyIsosurfaceSource(grey));
    field.use(scene);
    return field;
  }

  /** Returns the height of a gentle surface above voxel coordinates, in voxels along z. */
  private static double height(double i, double j, GridMetric metric) {
    double mm = 0.03 * i * metric.spacingX() + 0.04 * j * metric.spacingY();
    double waves = 2 * Math.sin(0.12 * i) * Math.sin(0.1 * j);
    return 0.3 * EDGE + mm / metric.spacingZ() + waves;
  }

  private void fillGentleSurface(GridMetric metric) {
    fill((i, j, k) -> k + 0.5 < height(i + 0.5, j + 0.5, metric));
  }

  private void choosePlaces(GridMetric metric) {
    places.clear();
    for (int n = 0; n < 12; n++) {
      double i = 20 + 40 * random.nextDouble();
      double j = 20 + 40 * random.nextDouble();
      double off = (5 * random.nextDouble() - 1) / metric.spacingZ();
      places.add(new Vec3(i, j, height(i, j, metric) + off));
    }
  }

  /** Makes a small box solid or empty; sometimes far from the surface. */
  private void editSomewhere(GridMetric metric) {
    int i = random.nextInt(EDGE);
    int j = random.nextInt(EDGE);
    int k = (int) height(i, j, metric) + random.nextInt(-4, 5);
    int edge = 1 + random.nextInt(random.nextInt(5) == 0 ? 12 : 4);
    boolean solid = random.nextBoolean();
    for (int n = 0; n < edge * edge * edge; n++) {
      set(i + n % edge, j + n / edge % edge, k + n / edge / edge, solid);
    }
  }

  /** Columns are the work that a frame after an edit would otherwise do again. */
  @ParameterizedTest
  @CsvSource({"1, 1, 1.2", "2, 1, 1"})
  void anEditFarAwayCostsNoColumnAndOneNearbyOnlySome(double x, double y, double z) {
    GridMetric metric = new GridMetric(x, y, z);
    fillGentleSurface(metric);
    OccupancyField field = fresh(metric);
    Vec3 place = new Vec3(30.4, 30.6, height(30.4, 30.6, metric) + 0.8 / z);
    long all = columnsAt(place, field);
    assertTrue(all >= 16, "columns " + all);
    turn(75, 75, (int) height(75, 75, metric));
    field.forget(changed);
    assertEquals(0, columnsAt(place, field));
    changed.clear();
    turn(32, 31, (int) height(32, 31, metric));
    field.forget(changed);
    long again = columnsAt(place, field);
    assertTrue(again > 0 && again < all, again + " of " + all);
  }

  private static long columnsAt(Vec3 place, OccupancyField field) {
    long before = field.interpolatedColumns();
    evaluate(field, place);
    return field.interpolatedColumns() - before;
  }

  @Test
  void whatIsReadAheadAfterAnEditIsMadeAgain() {
    GridMetric metric = new GridMetric(1, 1, 3);
    fillGentleSurface(metric);
    OccupancyField field = fresh(metric);
    Vec3 place = new Vec3(30.4, 30.6, height(30.4, 30.6, metric));
    readAheadOf(place, field);
    long columns = field.interpolatedColumns();
    readAheadOf(place, field);
    assertEquals(columns, field.interpolatedColumns(), "all is read");
    turn(32, 31, (int) height(32, 31, metric));
    field.forget(changed);
    readAheadOf(place, field);
    assertTrue(field.interpolatedColumns() > columns, "what the edit reaches is read again");
  }

  private static void readAheadOf(Vec3 place, OccupancyField field) {
    for (int n = 0; n < 64; n++) {
      field.readAhead(place);
    }
  }
}
