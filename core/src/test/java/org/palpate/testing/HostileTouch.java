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

/** A solver in a {@link HostileWorld}: what every one with the guarantee has to stand. */
public final class HostileTouch {
  private static final GridMetric UNIT = new GridMetric(1, 1, 1);

  /** Makes a fresh solver. */
  @FunctionalInterface
  public interface SolverFactory {
    ProxySolver make(GridMetric metric, double maxStepMm);
  }

  /** What a solver promises of a frame beside the guarantee. */
  @FunctionalInterface
  public interface FramePromise {
    /** Whether the frame that led from {@code before} to {@code after} kept it. */
    boolean isKept(GridMetric metric, Vec3 device, Vec3 before, Vec3 after);
  }

  private final SolverFactory maker;
  private final long seed = Seeds.seed();
  private final SplittableRandom random = new SplittableRandom(seed);
  private final InteractionPoint point = new InteractionPoint();

  public HostileTouch(SolverFactory maker) {
    this.maker = maker;
  }

  /**
   * Touches scene after scene; every leg is judged exactly, every path held against w_max.
   *
   * @return the number of legs
   */
  public long keepsTheGuarantee(int scenes, FramePromise promise) {
    long legs = 0;
    for (int scene = 0; scene < scenes; scene++) {
      legs += touchScene("seed=" + seed + " scene=" + scene, promise);
    }
    return legs;
  }

  private long touchScene(String what, FramePromise promise) {
    BitCube bits = HostileWorld.scene(random);
    GridMetric metric =
        new GridMetric(1, 1, random.nextBoolean() ? 1 : random.nextDouble(0.05, 20));
    double maxStepMm = random.nextInt(4) == 0 ? 1e-3 : random.nextDouble(0.5, 60);
    ProxySolver solver = maker.make(metric, maxStepMm);
    CollisionScene obstacles = new CollisionScene(List.of(bits));
    place(obstacles, metric, HostileWorld.point(random, bits), point);
    LegJudge judge = new LegJudge(bits, point.position);
    Vec3 device = new Vec3().set(point.position);
    Vec3 before = new Vec3();
    for (int frame = 0; frame < 200; frame++) {
      HostileWorld.moveDevice(random, bits, device);
      before.set(point.position);
      solver.follow(obstacles, device, point);
      String frameName = what + " frame=" + frame + " device=" + device;
      assertNull(judge.faultOf(point), frameName);
      assertTrue(point.legs.lengthMm() <= maxStepMm, frameName);
      assertTrue(promise.isKept(metric, device, before, point.position), frameName);
    }
    return judge.legCount();
  }

  /**
   * Holds a device still in scene after scene: the point has to rest, and to stay with the same
   * contact in the frame after that.
   *
   * @param atRest what is done to the solver that rests, before that last frame
   */
  public void comesToRest(int scenes, int mostFrames, Consumer<ProxySolver> atRest) {
    for (int scene = 0; scene < scenes; scene++) {
      ProxySolver solver = maker.make(UNIT, 8);
      CollisionScene obstacles = startInScene();
      Vec3 device =
          new Vec3(random.nextDouble(-4, 20), random.nextDouble(-4, 20), random.nextDouble(-4, 20));
      int frames = 0;
      do {
        solver.follow(obstacles, device, point);
        frames++;
      } while (point.legs.count() > 0 && frames < mostFrames);
      assertTrue(frames < mostFrames, "still moves: seed=" + seed + " scene=" + scene);
      boolean contact = point.contact;
      atRest.accept(solver);
      solver.follow(obstacles, device, point);
      assertEquals(0, point.legs.count(), "seed=" + seed + " scene=" + scene);
      assertEquals(contact, point.contact, "seed=" + seed + " scene=" + scene);
    }
  }

  /** Lets a device drift in scene after scene, then rest: a fresh solver must rest there too. */
  public void restsWhereAFreshSolverWouldRest(int scenes) {
    for (int scene = 0; scene < scenes; scene++) {
      ProxySolver solver = maker.make(UNIT, 8);
      CollisionScene obstacles = startInScene();
      Vec3 device = new Vec3().set(point.position);
      for (int frame = 0; frame < 80; frame++) {
        if (frame < 40) {
          drift(device);
        }
        solver.follow(obstacles, device, point);
      }
      maker.make(UNIT, 8).follow(obstacles, device, point);
      assertEquals(0, point.legs.count(), "seed=" + seed + " scene=" + scene);
    }
  }

  private CollisionScene startInScene() {
    CollisionScene obstacles = new CollisionScene(List.of(HostileWorld.scene(random)));
    Vec3 start = new Vec3(random.nextInt(-4, 20), random.nextInt(-4, 20) + 0.5, 1);
    place(obstacles, UNIT, start, point);
    return obstacles;
  }

  private void drift(Vec3 device) {
    for (int axis = 0; axis < 3; axis++) {
      device.set(axis, device.get(axis) + random.nextDouble(-0.2, 0.21));
    }
  }

  private static void place(
      CollisionScene obstacles, GridMetric metric, Vec3 start, InteractionPoint dest) {
    dest.position.set(start);
    if (obstacles.touches(start.x, start.y, start.z)) {
      new NearestFreeVoxel(metric).find(obstacles, start, dest.position);
    }
  }
}
