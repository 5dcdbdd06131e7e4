package org.palpate.testing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import org.palpate.collision.CollisionScene;
import org.palpate.collision.NearestFreeVoxel;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.volume.BitCube;

/** Tests a solver with the guarantee in scenes of {@link HostileWorld}. */
public final class HostileTouch {
  private static final GridMetric UNIT = new GridMetric(1, 1, 1);

  /** Makes new solvers. */
  @FunctionalInterface
  public interface SolverFactory {
    /** Makes a solver with its longest path per frame, w_max. */
    ProxySolver make(GridMetric metric, double maxStepMm);
  }

  /** A property that a solver promises of every frame beside the guarantee. */
  @FunctionalInterface
  public interface FramePromise {
    /** Whether the frame that moved the point from {@code before} to {@code after} has it. */
    boolean holds(GridMetric metric, Vec3 device, Vec3 before, Vec3 after);
  }

  private final SolverFactory factory;
  private final long seed = Seeds.seed();
  private final SplittableRandom random = new SplittableRandom(seed);
  private final InteractionPoint point = new InteractionPoint();

  /** Makes tests of the solvers that {@code factory} makes. */
  public HostileTouch(SolverFactory factory) {
    this.factory = factory;
  }

  /**
   * Moves a device through many scenes, and checks every leg exactly and every path against w_max.
   *
   * @return number of legs
   */
  public long keepsTheGuarantee(int scenes, FramePromise promise) {
    long legs = 0;
    for (int number = 0; number < RandomCases.of(scenes); number++) {
      legs += touchScene("seed=" + seed + " scene=" + number, promise);
    }
    return legs;
  }

  private long touchScene(String name, FramePromise promise) {
    BitCube bits = HostileWorld.scene(random);
    GridMetric metric =
        new GridMetric(1, 1, random.nextBoolean() ? 1 : random.nextDouble(0.05, 20));
    double maxStepMm = random.nextInt(4) == 0 ? 1e-3 : random.nextDouble(0.5, 60);
    ProxySolver solver = factory.make(metric, maxStepMm);
    CollisionScene scene = new CollisionScene(List.of(bits));
    place(scene, metric, HostileWorld.point(random, bits), point);
    LegJudge judge = new LegJudge(bits, point.position);
    Vec3 device = new Vec3().set(point.position);
    Vec3 before = new Vec3();
    for (int frame = 0; frame < 200; frame++) {
      HostileWorld.moveDevice(random, bits, device);
      before.set(point.position);
      solver.follow(scene, device, point);
      String frameName = name + " frame=" + frame + " device=" + device;
      assertNull(judge.faultOf(point), frameName);
      assertTrue(point.legs.lengthMm() <= maxStepMm, frameName);
      assertTrue(promise.holds(metric, device, before, point.position), frameName);
    }
    return judge.legCount();
  }

  /**
   * Holds a device still in many scenes. The point must come to rest, and must keep its contact in
   * the next frame.
   *
   * @param atRest called with the resting solver before that next frame
   */
  public void comesToRest(int scenes, int maxFrames, Consumer<ProxySolver> atRest) {
    for (int number = 0; number < scenes; number++) {
      ProxySolver solver = factory.make(UNIT, 8);
      CollisionScene scene = startInScene();
      Vec3 device =
          new Vec3(random.nextDouble(-4, 20), random.nextDouble(-4, 20), random.nextDouble(-4, 20));
      int frames = 0;
      do {
        solver.follow(scene, device, point);
        frames++;
      } while (point.legs.count() > 0 && frames < maxFrames);
      assertTrue(frames < maxFrames, "still moves: seed=" + seed + " scene=" + number);
      boolean contact = point.contact;
      atRest.accept(solver);
      solver.follow(scene, device, point);
      assertEquals(0, point.legs.count(), "seed=" + seed + " scene=" + number);
      assertEquals(contact, point.contact, "seed=" + seed + " scene=" + number);
    }
  }

  /** Lets a device drift and then rest in many scenes. A new solver must rest there too. */
  public void restsWhereAFreshSolverWouldRest(int scenes) {
    for (int number = 0; number < scenes; number++) {
      ProxySolver solver = factory.make(UNIT, 8);
      CollisionScene scene = startInScene();
      Vec3 device = new Vec3().set(point.position);
      for (int frame = 0; frame < 80; frame++) {
        if (frame < 40) {
          drift(device);
        }
        solver.follow(scene, device, point);
      }
      factory.make(UNIT, 8).follow(scene, device, point);
      assertEquals(0, point.legs.count(), "seed=" + seed + " scene=" + number);
    }
  }

  private CollisionScene startInScene() {
    CollisionScene scene = new CollisionScene(List.of(HostileWorld.scene(random)));
    Vec3 start = new Vec3(random.nextInt(-4, 20), random.nextInt(-4, 20) + 0.5, 1);
    place(scene, UNIT, start, point);
    return scene;
  }

  private void drift(Vec3 device) {
    for (int axis = 0; axis < 3; axis++) {
      device.set(axis, device.get(axis) + random.nextDouble(-0.2, 0.21));
    }
  }

  private static void place(
      CollisionScene scene, GridMetric metric, Vec3 start, InteractionPoint dest) {
    dest.position.set(start);
    if (scene.touches(start.x, start.y, start.z)) {
      new NearestFreeVoxel(metric).find(scene, start, dest.position);
    }
  }
}
