package org.palpate.proxy.smooth;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.smooth.ClosestPointSearch.Outcome;
import org.palpate.proxy.smooth.field.OccupancyField;
import org.palpate.proxy.smooth.field.SeedCell;
import org.palpate.testing.Floor;

/** Searches on ellipsoids, whose two curvatures differ and change along the surface. */
class ClosestPointSearchTest {
  /** Fixed, because the number of evaluations belongs to it. */
  private static final long SEED = 25;

  private static final int SEARCHES = 1_000;

  /** A hundredth of the largest first offset, in edges. */
  private static final double LARGEST_OFFSET = 0.025;

  /** Solids, with the most evaluations of the field that the searches may take together. */
  private record Solid(GridMetric metric, Vec3 semiAxesMm, boolean isCavity, int evaluations) {
    Quadrics quadric() {
      return new Quadrics(metric, semiAxesMm, isCavity);
    }
  }

  static List<Solid> solids() {
    return List.of(
        new Solid(new GridMetric(1, 1, 1), new Vec3(15, 9, 7), false, 3_150),
        new Solid(new GridMetric(0.8, 1.1, 0.9), new Vec3(14, 8, 7), false, 3_320),
        new Solid(new GridMetric(1, 1, 1), new Vec3(15, 11, 9), true, 2_625));
  }

  private OccupancyField field;
  private EdgeUnits units;
  private WindowBudget budget;
  private ClosestPointSearch search;
  private final SeedCell seed = new SeedCell();

  private void use(GridMetric metric, CollisionScene scene) {
    field = OccupancyField.ofBits(metric);
    field.use(scene);
    units = new EdgeUnits(metric);
    budget = new WindowBudget(field);
    search = new ClosestPointSearch(field, units, budget);
  }

  @ParameterizedTest
  @MethodSource("solids")
  void findsThePointBelowWhichTheDeviceLiesInAboutThreeEvaluations(Solid solid) {
    Quadrics quadric = solid.quadric();
    use(solid.metric, new CollisionScene(List.of(quadric.bits())));
    SplittableRandom random = new SplittableRandom(SEED);
    int converged = 0;
    double offsets = 0;
    long evaluations = 0;
    for (int n = 0; n < SEARCHES; n++) {
      Vec3 start = quadric.position(random, random.nextDouble(1, 2));
      Vec3 device = deviceBelow(start, random);
      long before = field.sample().evaluation();
      seed.set(start);
      budget.beginFrame();
      Outcome outcome = search.search(seed, start, device);
      evaluations += field.sample().evaluation() - before;
      assertTrue(units.distance(start, search.found()) <= ClosestPointSearch.REACH_EDGES);
      if (outcome == Outcome.CONVERGED) {
        converged++;
        double offset = offset(device);
        offsets += offset;
        assertTrue(offset <= LARGEST_OFFSET, "n=" + n + " offset " + offset);
        assertEquals(0, field.sample().heightEdges(), LARGEST_OFFSET, "n=" + n);
      } else {
        assertEquals(Outcome.UNFINISHED, outcome, "n=" + n);
      }
    }
    assertTrue(converged >= 0.98 * SEARCHES, "converged " + converged);
    assertTrue(evaluations <= solid.evaluations, "evaluations " + evaluations);
    assertTrue(offsets / converged < 0.0025, "mean offset " + offsets / converged);
  }

  /** Returns how far the device lies beside the normal at the visited point, in edges. */
  private double offset(Vec3 device) {
    Vec3 toDevice = new Vec3();
    units.vector(search.found(), device, toDevice);
    Vec3 normal = search.normal();
    return toDevice.sub(normal.mul(toDevice.dot(normal), new Vec3()), toDevice).length();
  }

  @ParameterizedTest
  @MethodSource("solids")
  void aDeviceBeyondTheReachLeavesASearchUnfinishedWithinIt(Solid solid) {
    Quadrics quadric = solid.quadric();
    use(solid.metric, new CollisionScene(List.of(quadric.bits())));
    SplittableRandom random = new SplittableRandom(SEED);
    int unfinished = 0;
    double farthest = 0;
    for (int n = 0; n < SEARCHES; n++) {
      Vec3 start = quadric.position(random, random.nextDouble(1, 2));
      Vec3 device = quadric.position(random, -random.nextDouble(1, 4));
      seed.set(start);
      budget.beginFrame();
      Outcome outcome = search.search(seed, start, device);
      double distance = units.distance(start, search.found());
      assertTrue(distance <= ClosestPointSearch.REACH_EDGES * (1 + 1e-12), "distance " + distance);
      unfinished += outcome == Outcome.UNFINISHED ? 1 : 0;
      farthest = Math.max(farthest, distance);
    }
    assertTrue(unfinished > SEARCHES / 10, "unfinished " + unfinished);
    assertTrue(farthest > 0.9 * ClosestPointSearch.REACH_EDGES, "farthest " + farthest);
  }

  @Test
  void aDeviceAboveTheSurfaceIsOutside() {
    use(Floor.METRIC, Floor.make().scene);
    Vec3 start = new Vec3(16.2, 15.7, Floor.TOP + 1.1);
    budget.beginFrame();
    Vec3 above = new Vec3(17, 15, Floor.TOP + 2.5);
    assertEquals(Outcome.OUTSIDE, search.search(seed.set(start), start, above));
    assertTrue(search.found().sameBits(start));
  }

  @Test
  void thereIsNoSurfaceFarAboveTheFloorOrDeepInIt() {
    use(Floor.METRIC, Floor.make().scene);
    budget.beginFrame();
    Vec3 device = new Vec3(16, 16, 4);
    Vec3 high = new Vec3(16.2, 15.7, 25);
    assertEquals(Outcome.NO_SURFACE, search.search(seed.set(high), high, device));
    Vec3 above = new Vec3(16, 16, 12);
    Vec3 deep = new Vec3(16.2, 15.7, 6.5);
    assertEquals(Outcome.NO_SURFACE, search.search(seed.set(above), deep, device));
  }

  /** From any height near a plane, one step leads below the device and onto the isosurface. */
  @Test
  void onAPlaneTheResultLiesAboveTheDeviceAtTheOffsetOfTheIsosurface() {
    use(Floor.METRIC, Floor.make().scene);
    double surface = Floor.TOP + field.level().mostOffsetEdges();
    for (double height : new double[] {-0.6, -0.2, 0, 0.3, 0.8}) {
      Vec3 start = new Vec3(16.2, 15.7, surface + height);
      Vec3 device = new Vec3(17.3, 14.9, 6.5);
      budget.beginFrame();
      assertEquals(Outcome.CONVERGED, search.search(seed.set(new Vec3(16, 16, 12)), start, device));
      assertEquals(device.x, search.found().x, 0.014);
      assertEquals(device.y, search.found().y, 0.014);
      assertEquals(surface, search.found().z, 0.03);
    }
  }

  /** Returns a position up to three edges below the surface near a start, and beside it. */
  private Vec3 deviceBelow(Vec3 start, SplittableRandom random) {
    seed.set(start);
    assertTrue(field.evaluate(seed, start).hasNormal());
    Vec3 normal = new Vec3().set(field.sample().normal());
    double height = field.sample().heightEdges();
    Vec3 beside =
        new Vec3(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
    beside.sub(normal.mul(beside.dot(normal), new Vec3()), beside);
    beside.mul(random.nextDouble(0.2, 1.8) / beside.length(), beside);
    Vec3 device = new Vec3();
    units.offset(start, -height - random.nextDouble(0.3, 3), normal, device);
    units.offset(device, 1, beside, device);
    return device;
  }
}
