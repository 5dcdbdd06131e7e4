package org.palpate.accuracy;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

/**
 * The point ends within a voxel of the free point nearest to the device, for axis-aligned boxes and
 * a hand that enters by the nearest face. The reference tests every voxel of the grid in exact
 * arithmetic.
 */
class NearestFreePointTest {
  private static final int EDGE = 30;
  private static final int BOXES = 80;
  private static final int POSITIONS = 3;
  private static final int FRAMES_TO_REST = 100;
  private static final double ONE_VOXEL = 1;

  /** The smooth solver's surface is rounded within this distance of an edge. */
  private static final double ROUNDED_VOXELS = 5;

  private static final double MAX_STEP_MM = 8;
  private static final Vec3[] SPACINGS = {
    new Vec3(1, 1, 1), new Vec3(1, 1, 2), new Vec3(0.5, 0.75, 3)
  };

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final Vec3 low = new Vec3();
  private final Vec3 high = new Vec3();
  private final Vec3 device = new Vec3();
  private Vec3 spacingMm;
  private int axis;
  private boolean fromAbove;

  /** The least distance of the resting device from an edge. */
  private double edgeMm;

  @Test
  void guardedEndsAtTheNearestFreePointOfABox() {
    for (int box = 0; box < BOXES; box++) {
      spacingMm = SPACINGS[box % SPACINGS.length];
      assertEndsWithinAVoxel(metric -> new GuardedSolver(metric, MAX_STEP_MM), 0);
    }
  }

  @Test
  void smoothEndsThereUpToTheHeightOfItsSurfaceAwayFromEdges() {
    spacingMm = SPACINGS[0];
    edgeMm = ROUNDED_VOXELS;
    for (int box = 0; box < BOXES; box++) {
      assertEndsWithinAVoxel(metric -> new SmoothSolver(metric, MAX_STEP_MM), 1);
    }
  }

  private void assertEndsWithinAVoxel(Function<GridMetric, ProxySolver> factory, double heights) {
    CollisionScene scene = new CollisionScene(List.of(box()));
    ProxySolver solver = factory.apply(GridMetric.of(spacingMm));
    InteractionPoint point = new InteractionPoint();
    startAboveTheFace();
    point.position.set(device);
    for (int place = 0; place < POSITIONS; place++) {
      pressIn(solver, scene, point);
      double within = ONE_VOXEL + heights * point.surfaceHeightMm;
      assertTrue(
          new ExactNearest(scene.cube(0), spacingMm, device).isWithin(point.position, within),
          () -> "box " + low + " " + high + " device " + device + " " + point.position + seed());
    }
  }

  private BitCube box() {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int n = 0; n < 3; n++) {
      low.set(n, random.nextInt(2, 5));
      high.set(n, random.nextInt(EDGE - 6, EDGE - 1));
    }
    for (int k = (int) low.z; k < high.z; k++) {
      for (int j = (int) low.y; j < high.y; j++) {
        for (int i = (int) low.x; i < high.x; i++) {
          bits.set(i, j, k);
        }
      }
    }
    return bits;
  }

  private void startAboveTheFace() {
    axis = random.nextInt(3);
    fromAbove = random.nextBoolean();
    anywhereInside();
    double height = 5 * random.nextDouble() + 0.1;
    device.set(axis, fromAbove ? high.get(axis) + height : low.get(axis) - height);
  }

  private void anywhereInside() {
    for (int n = 0; n < 3; n++) {
      device.set(n, low.get(n) + (high.get(n) - low.get(n)) * random.nextDouble());
    }
  }

  /** Moves in some steps to a position for which this face is the nearest, and rests there. */
  private void pressIn(ProxySolver solver, CollisionScene scene, InteractionPoint point) {
    Vec3 from = new Vec3().set(device);
    do {
      anywhereInside();
    } while (!isFaceNearest());
    Vec3 to = new Vec3().set(device);
    int steps = random.nextInt(1, 80);
    Vec3 path = to.sub(from, new Vec3());
    for (int step = 1; step < steps; step++) {
      from.add(path.mul(step / (double) steps, new Vec3()), device);
      solver.follow(scene, device, point);
    }
    device.set(to);
    for (int frame = 0; frame < FRAMES_TO_REST; frame++) {
      solver.follow(scene, device, point);
    }
  }

  private boolean isFaceNearest() {
    double mine = depthMm(axis, fromAbove);
    boolean nearest = mine < depthMm(axis, !fromAbove);
    for (int n = 1; n < 3; n++) {
      int other = (axis + n) % 3;
      double side = Math.min(depthMm(other, true), depthMm(other, false));
      nearest &= mine < side && edgeMm <= side;
    }
    return nearest;
  }

  private double depthMm(int of, boolean belowHigh) {
    double voxels = belowHigh ? high.get(of) - device.get(of) : device.get(of) - low.get(of);
    return voxels * spacingMm.get(of);
  }

  private static String seed() {
    return " seed " + Seeds.seed();
  }
}
