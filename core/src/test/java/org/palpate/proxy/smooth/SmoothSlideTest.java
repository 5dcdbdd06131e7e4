package org.palpate.proxy.smooth;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
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
import org.palpate.proxy.smooth.field.OccupancyField;
import org.palpate.proxy.smooth.field.SeedCell;
import org.palpate.statistics.SkipCounters;
import org.palpate.statistics.SkipKind;
import org.palpate.testing.Floor;
import org.palpate.volume.BitCube;

/** Whole frames on an ellipsoid: where the point ends, and what a frame takes. */
class SmoothSlideTest {
  private static final long SEED = 25;
  private static final int FRAMES = 4_000;

  private final InteractionPoint point = new InteractionPoint();
  private final Vec3 device = new Vec3();
  private final SeedCell seed = new SeedCell();
  private final Vec3 toDevice = new Vec3();

  /** The least part of the frames that end close, the mean offset, and the steps of a frame. */
  @ParameterizedTest
  @CsvSource({"false, 0.99, 0.004, 1.25", "true, 0.86, 0.055, 0.97"})
  void frameByFrameThePointIsTheOneOfTheIsosurfaceClosestToASlidingDevice(
      boolean isCavity, double part, double meanOffset, double frameSteps) {
    GridMetric metric = new GridMetric(1, 1, 1);
    Quadrics quadric = new Quadrics(metric, new Vec3(15, 11, 9), isCavity);
    CollisionScene scene = new CollisionScene(List.of(quadric.bits()));
    OccupancyField field = OccupancyField.ofBitsOverTerraces(metric);
    field.use(scene);
    SmoothSolver solver = new SmoothSolver(metric, 8);
    SplittableRandom random = new SplittableRandom(SEED);
    point.position.set(quadric.position(random, 3));
    device.set(point.position);
    Vec3 goal = new Vec3();
    int contacts = 0;
    int close = 0;
    long steps = 0;
    double sum = 0;
    for (int n = 0; n < FRAMES; n++) {
      if (n % 100 == 0) {
        goal.set(quadric.position(random, random.nextDouble(-2.5, -0.5)));
      }
      approach(goal, 0.3);
      solver.follow(scene, device, point);
      steps += solver.steps();
      if (point.contact) {
        contacts++;
        double offset = offset(field);
        sum += offset;
        close += offset < 0.05 ? 1 : 0;
      }
    }
    assertTrue(contacts > FRAMES / 2, "contacts " + contacts);
    assertTrue(close > part * contacts, "close " + close + " of " + contacts);
    assertTrue(sum < meanOffset * contacts, "mean offset " + sum / contacts);
    assertTrue(steps < frameSteps * FRAMES, "steps " + steps);
  }

  /** The point falls from open space to the isosurface, and slides on in the same frame. */
  @Test
  void aDeviceThatPassesIntoTheSolidAtOnceIsFollowedOntoTheSurfaceAndToRest() {
    GridMetric metric = new GridMetric(1, 1, 1);
    Quadrics quadric = new Quadrics(metric, new Vec3(15, 11, 9), false);
    CollisionScene scene = new CollisionScene(List.of(quadric.bits()));
    OccupancyField field = OccupancyField.ofBitsOverTerraces(metric);
    field.use(scene);
    SplittableRandom random = new SplittableRandom(SEED);
    int falls = 300;
    int frames = 0;
    double heights = 0;
    double offsets = 0;
    double first = 0;
    int straight = 0;
    for (int n = 0; n < falls; n++) {
      SmoothSolver solver = new SmoothSolver(metric, 100);
      point.position.set(quadric.position(random, random.nextDouble(4, 9)));
      Vec3 start = new Vec3().set(point.position);
      device.set(start);
      solver.follow(scene, device, point);
      assertFalse(point.contact);
      do {
        device.set(quadric.position(random, -random.nextDouble(1, 3)));
      } while (device.sub(start, new Vec3()).length() > 15);
      solver.follow(scene, device, point);
      assertTrue(point.contact, "n=" + n);
      straight += point.legs.slid(0) ? 0 : 1;
      first += offset(field);
      heights += Math.abs(field.sample().heightEdges());
      while (point.legs.count() > 0) {
        solver.follow(scene, device, point);
        frames++;
      }
      double offset = offset(field);
      offsets += offset;
      assertTrue(offset < 0.05, "n=" + n + " offset " + offset);
      solver.reset();
      solver.follow(scene, start, point);
      assertTrue(!point.position.sameBits(start) || !point.contact);
    }
    assertTrue(straight > 0.97 * falls, "it falls first: " + straight);
    assertTrue(heights < 0.2 * falls, "mean height after a frame " + heights / falls);
    assertTrue(first < 2.1 * falls, "mean offset after a frame " + first / falls);
    assertTrue(frames < 3 * falls, "frames until rest " + frames);
    assertTrue(offsets < 0.001 * falls, "mean offset at rest " + offsets / falls);
  }

  @Test
  void aVisibleDeviceBeyondTheLongestPathIsReachedFrameByFrameWithoutContact() {
    GridMetric metric = new GridMetric(1, 1, 2);
    BitCube bits = Floor.bits();
    CollisionScene scene = new CollisionScene(List.of(bits));
    SmoothSolver solver = new SmoothSolver(metric, 2);
    point.position.set(4.5, 16.5, 20);
    device.set(24.5, 16.5, 20);
    for (int n = 1; n <= 9; n++) {
      solver.follow(scene, device, point);
      assertEquals(4.5 + 2 * n, point.position.x, 1e-6, "frame " + n);
      assertFalse(point.contact);
    }
    solver.follow(scene, device, point);
    solver.follow(scene, device, point);
    assertTrue(point.position.sameBits(device));
    device.set(24.5, 16.5, 6.5); // in the floor, more than a frame away
    solver.follow(scene, device, point);
    assertEquals(19, point.position.z, 1e-6);
    assertTrue(point.contact, "the floor hides the device");
    for (int n = 0; n < 20; n++) {
      solver.follow(scene, device, point);
    }
    assertTrue(
        point.position.z > Floor.TOP && point.position.z < Floor.TOP + 1, "" + point.position);
    assertEquals(0, point.legs.count());
    SkipCounters counts = new SkipCounters();
    solver.addSkips(counts);
    assertTrue(counts.of(SkipKind.BESIDE_BOUNDS) > 0, "its rays, over the floor");
  }

  private void approach(Vec3 goal, double step) {
    goal.sub(device, toDevice);
    double length = toDevice.length();
    toDevice.mul(length > step ? step / length : 1, toDevice);
    device.add(toDevice, device);
  }

  /** Returns how far the device lies beside the normal at the point. */
  private double offset(OccupancyField field) {
    field.evaluate(seed.set(point.position), point.position);
    assertTrue(field.sample().hasNormal());
    device.sub(point.position, toDevice);
    Vec3 normal = field.sample().normal();
    return toDevice.sub(normal.mul(toDevice.dot(normal), new Vec3()), toDevice).length();
  }
}
