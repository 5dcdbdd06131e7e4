package org.palpate.proxy.smooth;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.FreePlace;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.Metric;
import org.palpate.proxy.Obstacles;
import org.palpate.testing.HostileWorld;
import org.palpate.testing.LegJudge;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

/** What holds for the guarded solver under hostile numbers holds for the smooth one. */
class SmoothSolverHostileTest {
  private static final Metric UNIT = new Metric(1, 1, 1);

  private final InteractionPoint point = new InteractionPoint();

  @Test
  void keepsTheGuaranteeInHostileScenes() {
    long seed = Seeds.seed();
    SplittableRandom random = new SplittableRandom(seed);
    long legs = 0;
    for (int scene = 0; scene < 300; scene++) {
      legs += touchScene(random, "seed=" + seed + " scene=" + scene);
    }
    assertTrue(legs > 20_000, "too few legs to mean anything: " + legs);
  }

  private long touchScene(SplittableRandom random, String what) {
    BitCube bits = HostileWorld.scene(random);
    Metric metric = new Metric(1, 1, random.nextBoolean() ? 1 : random.nextDouble(0.05, 20));
    double maxStepMm = random.nextInt(4) == 0 ? 1e-3 : random.nextDouble(0.5, 60);
    SmoothSolver solver = new SmoothSolver(metric, maxStepMm);
    Obstacles obstacles = new Obstacles(List.of(bits));
    place(obstacles, metric, HostileWorld.point(random, bits));
    LegJudge judge = new LegJudge(bits, point.position);
    Vec3 device = new Vec3().set(point.position);
    for (int frame = 0; frame < 200; frame++) {
      HostileWorld.moveDevice(random, bits, device);
      solver.follow(obstacles, device, point);
      String frameName = what + " frame=" + frame + " device=" + device;
      assertNull(judge.faultOf(point), frameName);
      assertTrue(point.legs.lengthMm() <= maxStepMm, frameName);
    }
    return judge.legCount();
  }

  @Test
  void comesToRestWhenTheDeviceRests() {
    long seed = Seeds.seed();
    SplittableRandom random = new SplittableRandom(seed);
    for (int scene = 0; scene < 200; scene++) {
      SmoothSolver solver = new SmoothSolver(UNIT, 8);
      Obstacles obstacles = new Obstacles(List.of(HostileWorld.scene(random)));
      place(obstacles, UNIT, new Vec3(random.nextInt(-4, 20), random.nextInt(-4, 20) + 0.5, 1));
      Vec3 device =
          new Vec3(random.nextDouble(-4, 20), random.nextDouble(-4, 20), random.nextDouble(-4, 20));
      int frames = 0;
      do {
        solver.follow(obstacles, device, point);
        frames++;
      } while (point.legs.count() > 0 && frames < 200);
      assertTrue(frames < 200, "still moves: seed=" + seed + " scene=" + scene);
      boolean contact = point.contact;
      solver.follow(obstacles, device, point);
      assertEquals(0, point.legs.count());
      assertEquals(contact, point.contact);
    }
  }

  private void place(Obstacles obstacles, Metric metric, Vec3 start) {
    point.position.set(start);
    if (obstacles.touches(start.x, start.y, start.z)) {
      new FreePlace(metric).find(obstacles, start, point.position);
    }
  }
}
