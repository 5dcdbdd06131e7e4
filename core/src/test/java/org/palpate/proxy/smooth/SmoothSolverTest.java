package org.palpate.proxy.smooth;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.smooth.field.GreyIsosurfaceSource;
import org.palpate.proxy.smooth.field.OccupancyField;
import org.palpate.testing.LegJudge;
import org.palpate.testing.RandomCases;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

/** Holds the promises of the solver, from bits and from grey values, on cubes and long voxels. */
class SmoothSolverTest {
  private static final GridMetric UNIT = new GridMetric(1, 1, 1);
  private static final GridMetric TALL = new GridMetric(0.9, 0.9, 1.8);

  /** Cubes, and voxels that are long along one axis or two. */
  private static final List<GridMetric> METRICS =
      List.of(
          UNIT,
          TALL,
          new GridMetric(1, 1, 3),
          new GridMetric(1, 1, 5),
          new GridMetric(3, 1, 1),
          new GridMetric(0.8, 2, 0.8),
          new GridMetric(1, 3, 2));

  private static final List<Source> SOURCES =
      METRICS.stream()
          .flatMap(metric -> Stream.of(new Source(metric, false), new Source(metric, true)))
          .toList();

  /** The voxels of a solver, and whether its field is made from grey values or from bits. */
  private record Source(GridMetric metric, boolean isGrey) {
    SmoothSolver solver(BitCube bits, double maxStepMm) {
      return isGrey
          ? new SmoothSolver(metric, maxStepMm, Worlds.grey(bits, Seeds.seed()))
          : new SmoothSolver(metric, maxStepMm);
    }

    OccupancyField field(BitCube bits) {
      return isGrey
          ? OccupancyField.ofGrey(metric, new GreyIsosurfaceSource(Worlds.grey(bits, Seeds.seed())))
          : OccupancyField.ofBitsOverTerraces(metric);
    }

    /** Returns a number of cases: all on cubes of bits, and a part otherwise. */
    int cases(int all, int part) {
      return RandomCases.of(isGrey ? part / 2 : metric.equals(UNIT) ? all : part);
    }
  }

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final InteractionPoint point = new InteractionPoint();
  private final Vec3 device = new Vec3();

  @Test
  void goesToAFreeDeviceBitForBit() {
    device.set(3.1, 0.7, 5.3);
    point.position.set(-2, 1, 1);
    new SmoothSolver(UNIT, 100).follow(scene(new BitCube(8, 8, 8)), device, point);
    assertTrue(point.position.sameBits(device));
    assertFalse(point.contact);
    assertEquals(1, point.legs.count());
  }

  @Test
  void aThinWallStopsThePointAtTheSameDistanceOnBothSides() {
    for (double maxStep : new double[] {0.5, 1, 2, 8}) {
      Vec3 fromLow = restAtWall(10, 3.3, 10.9, maxStep);
      Vec3 fromHigh = restAtWall(13, 20.7, 13.1, maxStep);
      assertEquals(fromLow.x, 24 - fromHigh.x, 1e-6, "w_max=" + maxStep);
    }
  }

  /** Returns where a point rests on a wall one voxel thick with the device behind it. */
  private Vec3 restAtWall(int wallX, double startX, double deviceX, double maxStep) {
    BitCube wall = new BitCube(24, 24, 24);
    for (int k = 0; k < 24; k++) {
      for (int j = 0; j < 24; j++) {
        wall.set(wallX, j, k);
      }
    }
    SmoothSolver solver = new SmoothSolver(UNIT, maxStep);
    point.position.set(startX, 12.5, 12.5);
    device.set(deviceX, 12.7, 12.6);
    int frames = 0;
    do {
      solver.follow(scene(wall), device, point);
      frames++;
    } while (point.legs.count() > 0 && frames < 200);
    return new Vec3().set(point.position);
  }

  @Test
  void refusesAMaxStepThatIsNotPositive() {
    assertThrows(IllegalArgumentException.class, () -> new SmoothSolver(UNIT, 0));
  }

  @Test
  void noLegTouchesASolidInAnyWorld() {
    for (String name : Worlds.NAMES) {
      for (Source source : SOURCES) {
        wander(name, source, source.cases(1500, 400));
      }
    }
  }

  private void wander(String world, Source source, int frames) {
    String name = world + " " + source;
    BitCube bits = Worlds.make(world, Seeds.seed());
    CollisionScene scene = scene(bits);
    SmoothSolver solver = source.solver(bits, 8);
    point.position.set(-3, -3, 45);
    device.set(point.position);
    LegJudge judge = new LegJudge(bits, point.position);
    Vec3 goal = new Vec3();
    for (int frame = 0; frame < frames; frame++) {
      if (frame % 40 == 0) {
        goal.set(anywhere(), anywhere(), anywhere());
      }
      approach(goal, frame / 40 % 3 == 0 ? 2 : 0.3);
      solver.follow(scene, device, point);
      assertNull(judge.faultOf(point), name + " frame " + frame + " seed=" + Seeds.seed());
      assertTrue(point.legs.lengthMm() <= 8, name);
      assertTrue(solver.windows() <= SmoothSolver.MOST_WINDOWS, name);
    }
    assertTrue(judge.legCount() > 0, name);
  }

  /** Moves the device a step towards the goal. */
  private void approach(Vec3 goal, double step) {
    double length = UNIT.distance(device.x, device.y, device.z, goal.x, goal.y, goal.z);
    double fraction = Math.min(1, step / Math.max(length, 1e-9));
    VerifiedMotion.between(device, goal, fraction, device);
  }

  /** Returns a coordinate in a world or a little outside. */
  private double anywhere() {
    return random.nextDouble() * 1.2 * Worlds.EDGE - 0.1 * Worlds.EDGE;
  }

  @Test
  void comesToRestBitForBitInEveryWorldAndStaysThere() {
    int longest = 0;
    for (Source source : SOURCES) {
      longest = Math.max(longest, longestToRest(source, source.cases(60, 20)));
    }
    assertTrue(longest < 200, "longest=" + longest + " seed=" + Seeds.seed());
  }

  /** Returns the most frames that it took to come to rest at random places. */
  private int longestToRest(Source source, int holds) {
    int longest = 0;
    for (String name : Worlds.NAMES) {
      BitCube bits = Worlds.make(name, Seeds.seed());
      CollisionScene scene = scene(bits);
      SmoothSolver solver = source.solver(bits, 8);
      point.position.set(-3, -3, 45);
      device.set(point.position);
      Vec3 goal = new Vec3();
      for (int hold = 0; hold < holds; hold++) {
        goal.set(anywhere(), anywhere(), anywhere());
        for (int frame = 0; frame < 30; frame++) {
          approach(goal, 0.4);
          solver.follow(scene, device, point);
        }
        longest = Math.max(longest, framesToRest(solver, scene, name + " " + source));
      }
    }
    return longest;
  }

  private int framesToRest(SmoothSolver solver, CollisionScene scene, String name) {
    Vec3 before = new Vec3();
    int moving = 0;
    do {
      before.set(point.position);
      solver.follow(scene, device, point);
      moving++;
      assertTrue(moving < 2000, name + " never rests, seed=" + Seeds.seed());
    } while (!before.sameBits(point.position));
    for (int frame = 0; frame < 5; frame++) {
      solver.follow(scene, device, point);
      assertTrue(before.sameBits(point.position), name);
      assertEquals(0, point.legs.count());
    }
    return moving;
  }

  @Test
  void everyMovingFrameLowersThePotentialWhileTheDeviceRests() {
    for (Source source : SOURCES) {
      int moving = 0;
      for (String name : Worlds.NAMES) {
        BitCube bits = Worlds.make(name, Seeds.seed());
        CollisionScene scene = scene(bits);
        SmoothSolver solver = source.solver(bits, 0.4);
        OccupancyField field = source.field(bits);
        field.use(scene);
        point.position.set(-3, -3, 45);
        device.set(point.position);
        for (int hold = 0; hold < source.cases(40, 12); hold++) {
          device.set(anywhere(), anywhere(), anywhere());
          solver.follow(scene, device, point);
          moving += framesThatLowerThePotential(solver, scene, field, source.metric, name + source);
        }
      }
      assertTrue(moving > source.cases(300, 300), source + ": too few moving frames: " + moving);
    }
  }

  private int framesThatLowerThePotential(
      SmoothSolver solver,
      CollisionScene scene,
      OccupancyField field,
      GridMetric metric,
      String name) {
    Potential potential = new Potential(field, new EdgeUnits(metric));
    int frames = 0;
    double lastFreeDistance = Double.POSITIVE_INFINITY;
    double before = potential.at(point.position, device);
    double distance = distanceToDevice(metric);
    solver.follow(scene, device, point);
    while (point.legs.count() > 0 && !point.position.sameBits(device)) {
      double after = potential.at(point.position, device);
      if (after > before - RestRule.LEAST_FALL_EDGES) {
        String message = name + ": " + before + " to " + after + " seed=" + Seeds.seed();
        assertTrue(distance < lastFreeDistance, message);
        assertFalse(point.legs.slid(0), message);
        lastFreeDistance = distance;
      }
      before = after;
      distance = distanceToDevice(metric);
      frames++;
      solver.follow(scene, device, point);
    }
    return frames;
  }

  private double distanceToDevice(GridMetric metric) {
    Vec3 p = point.position;
    return metric.distance(p.x, p.y, p.z, device.x, device.y, device.z);
  }

  /** Frames that are left out after the point has settled must not be why it rests. */
  @Test
  void restsWithoutLeavingOutFrames() {
    BitCube bits = Worlds.make("maze", Seeds.seed());
    CollisionScene scene = scene(bits);
    SmoothSolver solver = new SmoothSolver(UNIT, 8);
    point.position.set(-3, -3, 45);
    device.set(20.3, 21.2, 19.9);
    for (int frame = 0; frame < 300; frame++) {
      solver.follow(scene, device, point);
    }
    Vec3 rested = new Vec3().set(point.position);
    SmoothSolver other = new SmoothSolver(UNIT, 8);
    other.follow(scene, new Vec3(device.x, device.y, Math.nextUp(device.z)), point);
    other.follow(scene, device, point);
    assertTrue(rested.sameBits(point.position), "rested " + rested + " now " + point.position);
  }

  @Test
  void anEditedVoxelCountsInTheNextFrame() {
    SOURCES.forEach(this::assertAnEditCounts);
  }

  private void assertAnEditCounts(Source source) {
    BitCube bits = Worlds.make("slope", Seeds.seed());
    CollisionScene scene = scene(bits);
    SmoothSolver solver = source.solver(bits, 8);
    point.position.set(25, 25, 30);
    device.set(20, 20, 14);
    for (int frame = 0; frame < 50; frame++) {
      solver.follow(scene, device, point);
    }
    double before = distanceToDevice(source.metric);
    clearColumnsBelow(bits, point.position);
    solver.reset();
    solver.follow(scene, device, point);
    String message = source + ": before " + before + " now " + point.position;
    assertTrue(distanceToDevice(source.metric) < before - 1e-3, message);
  }

  private static void clearColumnsBelow(BitCube bits, Vec3 position) {
    for (int n = 0; n < 49; n++) {
      int i = (int) position.x - 3 + n % 7;
      int j = (int) position.y - 3 + n / 7;
      for (int k = 0; k < Worlds.EDGE; k++) {
        bits.clear(i, j, k);
      }
    }
  }

  @Test
  void allocatesNothingInAWarmFrame() {
    SOURCES.forEach(this::assertAllocatesNothing);
  }

  private void assertAllocatesNothing(Source source) {
    var threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    BitCube bits = Worlds.make("sponge", Seeds.seed());
    CollisionScene scene = scene(bits);
    SmoothSolver solver = source.solver(bits, 8);
    point.position.set(-3, -3, 45);
    device.set(point.position);
    Vec3 goal = new Vec3(20, 22, 18);
    slideAndTurn(solver, scene, goal, RandomCases.of(2000));
    long thread = Thread.currentThread().getId();
    long before = threads.getThreadAllocatedBytes(thread);
    slideAndTurn(solver, scene, goal, RandomCases.of(20_000));
    long allocated = threads.getThreadAllocatedBytes(thread) - before;
    assertTrue(allocated <= 200, source + " allocated=" + allocated);
  }

  private void slideAndTurn(SmoothSolver solver, CollisionScene scene, Vec3 goal, int frames) {
    for (int frame = 0; frame < frames; frame++) {
      if (frame % 50 == 0) {
        goal.set(goal.y, goal.z + frame % 7 - 3, goal.x);
      }
      approach(goal, 0.3);
      solver.follow(scene, device, point);
    }
  }

  private static CollisionScene scene(BitCube bits) {
    return new CollisionScene(List.of(bits));
  }
}
