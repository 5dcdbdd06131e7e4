package org.palpate.proxy.smooth;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.smooth.field.FieldSample;
import org.palpate.proxy.smooth.field.OccupancyField;
import org.palpate.proxy.smooth.field.SeedCell;
import org.palpate.testing.RandomCases;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

/** Reading ahead changes no answer, and takes the work of a new region from the frame there. */
class ReadAheadTest {
  private static final int EDGE = 96;

  /** The columns that a frame may interpolate ahead, with those of the brick that is begun last. */
  private static final int MOST_AHEAD = 8 + 3 * 16;

  private static CollisionScene ball(double longEdge) {
    return new CollisionScene(List.of(bitsOfBall(longEdge)));
  }

  private static BitCube bitsOfBall(double longEdge) {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
      double x = n % EDGE - 48;
      double y = n / EDGE % EDGE - 48;
      double z = longEdge * (n / (EDGE * EDGE) - 24);
      if (x * x + y * y + z * z < 40 * 40) {
        bits.set(n % EDGE, n / EDGE % EDGE, n / (EDGE * EDGE));
      }
    }
    return bits;
  }

  @ParameterizedTest
  @CsvSource({"1, 2", "1, 3", "1, 5", "2, 3"})
  void aRegionThatWasReadAheadNeedsFewColumnsAndGivesTheSameAnswer(double y, double z) {
    CollisionScene scene = ball(z);
    GridMetric metric = new GridMetric(1, y, z);
    OccupancyField field = OccupancyField.ofBitsOverTerraces(metric);
    field.use(scene);
    Vec3 place = new Vec3(55.3, 49.2, 24 + 39 / z);
    SeedCell seed = new SeedCell().set(new Vec3(55, 49, 24 + 42 / z));
    for (int n = 0; n < 64; n++) {
      long before = field.interpolatedColumns();
      field.readAhead(place);
      long columns = field.interpolatedColumns() - before;
      assertTrue(y > 1 || columns <= MOST_AHEAD, columns + " columns in one frame");
    }
    long ahead = field.interpolatedColumns();
    assertTrue(ahead > 60, "columns " + ahead);
    double occupancy = field.evaluate(seed, place).occupancy();
    long left = field.interpolatedColumns() - ahead;
    OccupancyField fresh = OccupancyField.ofBitsOverTerraces(metric);
    fresh.use(scene);
    assertEquals(fresh.evaluate(seed, place).occupancy(), occupancy);
    // Terraces at the border of the window look at bricks beyond it.
    assertTrue(3 * left < fresh.interpolatedColumns(), left + " columns left to the evaluation");
    assertTrue(occupancy > 0.1 && occupancy < 0.9, "near the surface " + occupancy);
  }

  /** Compares two fields that see the same edits; one of them reads ahead at random places. */
  @ParameterizedTest
  @CsvSource({"1, 1.2", "1, 2", "1, 5", "2, 3"})
  void noBitOfAnAnswerDependsOnWhatWasReadAheadBetweenEdits(double y, double z) {
    BitCube bits = bitsOfBall(z);
    CollisionScene scene = new CollisionScene(List.of(bits));
    GridMetric metric = new GridMetric(1, y, z);
    OccupancyField ahead = OccupancyField.ofBitsOverTerraces(metric);
    OccupancyField plain = OccupancyField.ofBitsOverTerraces(metric);
    ahead.use(scene);
    plain.use(scene);
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    SeedCell seed = new SeedCell();
    Vec3 above = new Vec3();
    Vec3 beside = new Vec3();
    int onSurface = 0;
    double x = 55;
    for (int n = 0; n < RandomCases.of(400); n++) {
      x = Math.max(30, Math.min(66, x + 6 * random.nextDouble() - 3));
      double height = Math.sqrt(40 * 40 - (x - 48) * (x - 48)) / z;
      Vec3 place = new Vec3(x, 48.2, 24 + height + 4 * random.nextDouble() / z - 1 / z);
      above.set(x, 48.2, 24 + height + 5 / z);
      seed.set(above);
      if (n % 8 == 0) {
        editNear(place, bits, random);
        ahead.forget();
        plain.forget();
      }
      for (int left = random.nextInt(16); left > 0; left--) {
        beside.set(x + 16 * random.nextDouble() - 8, 44 + 8 * random.nextDouble(), place.z);
        ahead.readAhead(beside);
      }
      FieldSample expected = plain.evaluate(seed, place);
      FieldSample found = ahead.evaluate(seed, place);
      String where = "seed=" + Seeds.seed() + " n=" + n + " at " + place;
      assertEquals(expected.occupancy(), found.occupancy(), where);
      assertEquals(expected.gx(), found.gx(), where);
      assertEquals(expected.gy(), found.gy(), where);
      assertEquals(expected.gz(), found.gz(), where);
      onSurface += found.occupancy() > 0.01 && found.occupancy() < 0.99 ? 1 : 0;
      if (n % 64 == 0) {
        OccupancyField fresh = OccupancyField.ofBitsOverTerraces(metric);
        fresh.use(scene);
        assertEquals(fresh.evaluate(seed, place).occupancy(), found.occupancy(), where);
      }
    }
    assertTrue(onSurface >= RandomCases.of(100), "near the surface " + onSurface);
  }

  private static void editNear(Vec3 place, BitCube bits, SplittableRandom random) {
    for (int n = 0; n < 20; n++) {
      int i = (int) place.x + random.nextInt(-6, 7);
      int j = (int) place.y + random.nextInt(-6, 7);
      int k = (int) place.z + random.nextInt(-3, 4);
      if (bits.get(i, j, k)) {
        bits.clear(i, j, k);
      } else {
        bits.set(i, j, k);
      }
    }
  }

  @Test
  void whatWasReadAheadIsForgottenWithAllElse() {
    OccupancyField field = OccupancyField.ofBitsOverTerraces(new GridMetric(1, 1, 2));
    field.use(ball(2));
    Vec3 place = new Vec3(55.3, 49.2, 43.5);
    for (int n = 0; n < 64; n++) {
      field.readAhead(place);
    }
    long columns = field.interpolatedColumns();
    field.readAhead(place);
    assertEquals(columns, field.interpolatedColumns(), "all is read");
    field.forget();
    for (int n = 0; n < 64; n++) {
      field.readAhead(place);
    }
    assertEquals(2 * columns, field.interpolatedColumns());
  }

  @Test
  void placesFarAwayAreNotRead() {
    OccupancyField field = OccupancyField.ofBitsOverTerraces(new GridMetric(1, 1, 2));
    field.use(ball(2));
    for (double far : new double[] {1e9, 1e300, Double.POSITIVE_INFINITY, Double.NaN}) {
      field.readAhead(new Vec3(far, 0, 0));
      field.readAhead(new Vec3(0, 0, -far));
    }
    assertEquals(0, field.interpolatedColumns());
  }

  /** A hand at 10 kHz comes down at 300 edges a second, touches, and slides over the ball. */
  @Test
  void noFrameOfAHandThatTouchesAndSlidesInterpolatesAWholeWindow() {
    CollisionScene scene = ball(2);
    SmoothSolver solver = new SmoothSolver(new GridMetric(1, 1, 2), 8);
    InteractionPoint point = new InteractionPoint();
    Vec3 device = new Vec3(20, 48, 50);
    point.position.set(device);
    int most = 0;
    int all = 0;
    int touching = 0;
    for (int n = 0; n < 3000; n++) {
      double deep = Math.min(n * 0.03, 15);
      device.set(20 + 0.02 * n, 48 + 0.003 * n, 50 - deep / 2);
      solver.follow(scene, device, point);
      most = Math.max(most, solver.steps());
      all += solver.steps();
      touching += point.contact ? 1 : 0;
    }
    assertTrue(touching > 1000, "in contact " + touching);
    assertTrue(all > 5000, "work of all frames " + all);
    assertTrue(most < 100, "work of the longest frame " + most);
  }
}
