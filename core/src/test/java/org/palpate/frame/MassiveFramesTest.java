package org.palpate.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;
import static org.palpate.testing.ScriptedDevice.fresh;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.collision.CollisionScene;
import org.palpate.edit.EditQueue;
import org.palpate.edit.VoxelEdit;
import org.palpate.force.ForceSettings;
import org.palpate.force.MassSettings;
import org.palpate.force.MassiveContact;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.loop.ManualClock;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.testing.Floor;
import org.palpate.testing.HostileWorld;
import org.palpate.testing.LegJudge;
import org.palpate.testing.ScriptedDevice;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/** A point with mass in whole frames. */
class MassiveFramesTest {
  private static final long MS = ManualClock.MS;

  private final long seed = Seeds.seed();
  private final SplittableRandom random = new SplittableRandom(seed);
  private final Vec3 hand = new Vec3();
  private final ScriptedDevice device =
      new ScriptedDevice((read, state) -> fresh(state, read, hand.x, hand.y, hand.z));
  private long nowNanos = 1;

  private PointFrame frame(BitCube bits, ProxySolver solver, double kg, Vec3 gravity) {
    ForceSettings force = Floor.settings().force();
    MassSettings held = new MassSettings(kg, gravity);
    return frame(bits, solver, Floor.settings(), new MassiveContact(Floor.METRIC, force, held));
  }

  private PointFrame frame(
      BitCube bits, ProxySolver solver, FrameSettings settings, MassiveContact mass) {
    PointFrame frame =
        new PointFrame(
            GridDevice.inGridCoordinates(device),
            solver,
            new CollisionScene(List.of(bits)),
            Floor.METRIC,
            settings,
            new EditQueue(VoxelGrid.ofUnitVoxels(bits.sizeX(), bits.sizeY(), bits.sizeZ()), 1),
            FramePublisher.NONE);
    frame.give(mass);
    return frame;
  }

  private void run(PointFrame frame, int frames) {
    for (int n = 0; n < frames; n++) {
      frame.run(nowNanos);
      nowNanos += MS;
    }
  }

  private static List<ProxySolver> solvers() {
    GridMetric metric = Floor.METRIC;
    return List.of(new GuardedSolver(metric, 8), new SmoothSolver(metric, 8));
  }

  @Test
  void noLegOfAPointWithMassTouchesASolid() {
    long legs = 0;
    for (int scene = 0; scene < 40; scene++) {
      for (ProxySolver solver : solvers()) {
        legs += touch(HostileWorld.scene(random), solver, "seed " + seed + " scene " + scene);
      }
    }
    assertTrue(legs > 20_000, "legs " + legs);
  }

  private long touch(BitCube bits, ProxySolver solver, String name) {
    double kg = Math.exp(random.nextDouble() * 5 - 5);
    Vec3 gravity = new Vec3(0, random.nextInt(2) * 9810, 0);
    PointFrame frame = frame(bits, solver, kg, gravity);
    LegJudge judge = null;
    for (int n = 0; n < 400; n++) {
      if (random.nextInt(8) == 0) {
        hand.set(
            (random.nextDouble() * 1.4 - 0.2) * bits.sizeX(),
            (random.nextDouble() * 1.4 - 0.2) * bits.sizeY(),
            (random.nextDouble() * 1.4 - 0.2) * bits.sizeZ());
      }
      frame.run(nowNanos);
      nowNanos += random.nextInt(7) * MS;
      if (judge != null && !frame.wasFreed()) {
        assertNull(judge.faultOf(frame.point()), name + " frame " + n);
      } else {
        judge = new LegJudge(bits, frame.point().position);
      }
    }
    return judge.legCount();
  }

  @Test
  void restsBitForBitOnAFloorWithEverySolver() {
    for (ProxySolver solver : solvers()) {
      PointFrame frame = frame(Floor.bits(), solver, 0.05, new Vec3(0, 0, -9810));
      hand.set(16.2, 15.7, 12);
      run(frame, 5);
      hand.set(15.3, 16.1, 5.5);
      run(frame, 8000);
      Vec3 rested = new Vec3().set(frame.point().position);
      Vec3 felt = device.lastForce();
      // The hand is 2.5 mm deep and carries a quarter of the weight of 0.4905 N.
      assertEquals(0.5 * 2.5 - 0.4905 / 4, felt.z, 0.02, "pressed " + felt);
      for (int n = 0; n < 500; n++) {
        run(frame, 1);
        assertTrue(frame.point().position.sameBits(rested), "frame " + n + " of " + solver);
        assertTrue(device.lastForce().sameBits(felt));
      }
    }
  }

  /** Returns a ball that is cut to a wide terrace above, and has steps of one voxel elsewhere. */
  private static BitCube hill() {
    BitCube bits = new BitCube(Floor.EDGE, Floor.EDGE, Floor.EDGE);
    for (int n = 0; n < Floor.EDGE * Floor.EDGE * Floor.EDGE; n++) {
      int i = n % Floor.EDGE;
      int j = n / Floor.EDGE % Floor.EDGE;
      int k = n / (Floor.EDGE * Floor.EDGE);
      if (Math.hypot(Math.hypot(i - 15.5, j - 15.5), k - 3.5) < 13.2 && k < 13) {
        bits.set(i, j, k);
      }
    }
    return bits;
  }

  /** A hand may get back what it gave, and no more, but for what the observer has not paid yet. */
  @Test
  void aHandThatWandersOverACurvedHillGetsNoEnergyFromTheMass() {
    long frames = Long.getLong("palpate.massFrames", 60_000);
    for (double kg : new double[] {0.005, 0.05, 1}) {
      for (ProxySolver solver : solvers()) {
        ForceSettings force = ForceSettings.of(2, random.nextInt(2) * 0.2);
        FrameSettings unlimited =
            new FrameSettings(
                force,
                Double.POSITIVE_INFINITY,
                Double.POSITIVE_INFINITY,
                0,
                FrameSettings.NO_SILENCE,
                1);
        MassiveContact mass =
            new MassiveContact(Floor.METRIC, force, new MassSettings(kg, new Vec3()));
        PointFrame frame = frame(hill(), solver, unlimited, mass);
        hand.set(16, 16, 18);
        run(frame, 1);
        Vec3 speed = new Vec3();
        Vec3 last = new Vec3();
        double given = 0;
        long touching = 0;
        for (long n = 0; n < frames; n++) {
          device.forgetWritten();
          last.set(hand);
          for (int axis = 0; axis < 3; axis++) {
            double home = axis == 2 ? 12 : 16;
            double jolt = random.nextInt(500) == 0 ? 1 : 0.02;
            double pull = 0.001 * (home - hand.get(axis));
            speed.set(axis, 0.98 * speed.get(axis) + pull + jolt * (random.nextDouble() - 0.5));
            hand.set(axis, hand.get(axis) + speed.get(axis));
          }
          run(frame, 1);
          given -= frame.forceNewton().dot(hand.sub(last, last));
          touching += frame.point().contact ? 1 : 0;
          if (given < -mass.debtMillijoule() - 1e-9 * n) {
            String where = solver + " " + kg + " kg, seed " + seed + " frame " + n;
            fail(where + ": " + given + " mJ");
          }
        }
        assertTrue(given > 1 && touching > frames / 10, "it touched: " + touching);
        assertEquals(0, mass.debtMillijoule(), 1, "a debt is paid soon");
      }
    }
  }

  @Test
  void aHandThatStartsInASolidBeginsWithoutAForce() {
    PointFrame frame = frame(Floor.bits(), new GuardedSolver(Floor.METRIC, 8), 0.05, new Vec3());
    hand.set(16, 16, 4);
    run(frame, 1);
    assertTrue(frame.wasFreed());
    assertEquals(0, device.lastForce().length());
    run(frame, 3000);
    assertEquals(0.5 * 4, device.lastForce().length(), 0.05);
  }

  @Test
  void aFloorThatComesToThePointSetsItFreeWithItsMass() {
    Floor floor = Floor.make();
    PointFrame frame = floor.frame(device);
    MassSettings held = new MassSettings(0.05, new Vec3());
    frame.give(new MassiveContact(Floor.METRIC, Floor.settings().force(), held));
    hand.set(16.5, 16.5, 10.5);
    run(frame, 50);
    floor.edits.offer(new VoxelEdit(0, 16, 16, 10, true));
    run(frame, 1);
    assertTrue(frame.wasFreed());
    assertEquals(0, device.lastForce().length());
    run(frame, 2000);
    assertEquals(1, frame.statistics().freed());
  }
}
