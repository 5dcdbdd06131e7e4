package org.palpate.opencl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.collision.CollisionDevice;
import org.palpate.collision.LegBatch;
import org.palpate.collision.LegVerdict;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.opencl.FailingDriver.Failure;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.ToolMotion;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.phantom.Phantom;

/** Tests that a device which fails at any call changes no bit of what a tool does. */
class OpenClFailureTest {
  private static final int FRAMES = 24;
  private static final long DEADLINE_NANOS = 20_000_000;

  /** The pose after each frame, and its work. */
  private record Run(List<Pose> poses, List<Long> work, long slowestNanos) {}

  private final RigidTool tool = ToolSampler.ofShape(RodShape.capsule(2, 4), 0.8);

  /** Runs frames of a hand that presses and turns, with an edit, always the same. */
  private Run run(CollisionDevice device) {
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    BitCube bits = Phantom.parse("sphere:32").segments().segments().get(0).bits();
    Body body = new Body("ball", bits, VoxelGrid.ofUnitVoxels(32, 32, 32), Mobility.FIXED);
    BodyScene scene = new BodyScene(List.of(body));
    RigidSettings settings =
        new RigidSettings(8, List.of(Clearance.POINTS), List.of(), true, device);
    RigidSolver solver = new RigidSolver(scene, tool, settings);
    ToolMotion motion = solver.newMotion();
    Pose hand = new Pose();
    hand.translation.set(16, 16, -4);
    solver.place(hand, motion);
    Quaternion scratch = new Quaternion();
    List<Pose> poses = new ArrayList<>();
    List<Long> work = new ArrayList<>();
    long slowest = 0;
    for (int frame = 0; frame < FRAMES; frame++) {
      Vec3 push = RandomGeometry.vector(random, 0.4);
      push.z += 0.5;
      hand.displace(push, RandomGeometry.vector(random, 0.1), 1, scratch, hand);
      if (frame == FRAMES / 2) {
        fillVoxelsAhead(body);
      }
      long start = System.nanoTime();
      solver.follow(hand, motion);
      slowest = Math.max(slowest, System.nanoTime() - start);
      poses.add(new Pose().set(motion.pose()));
      work.add(solver.work());
    }
    return new Run(poses, work, slowest);
  }

  private static void fillVoxelsAhead(Body body) {
    IntBox box = new IntBox();
    for (int n = 0; n < 64; n++) {
      body.bits().set(4 + n % 4, 4 + n / 4 % 4, 2 + n / 16);
      box.include(4 + n % 4, 4 + n / 4 % 4, 2 + n / 16);
    }
    body.voxelsChanged(box);
  }

  private static void assertSame(Run expected, Run actual, String where) {
    for (int frame = 0; frame < FRAMES; frame++) {
      assertTrue(
          expected.poses().get(frame).sameBits(actual.poses().get(frame)),
          where + " frame " + frame);
    }
    assertEquals(expected.work(), actual.work(), where);
  }

  @ParameterizedTest
  @EnumSource(Failure.class)
  void aFailureAtAnyCallIsSurvivedWithTheSameResult(Failure failure) {
    Run expected = run(CollisionDevice.CPU);
    FailingDriver sound = new FailingDriver(new SimulatedDriver(), failure, Long.MAX_VALUE);
    OpenClDevice device = OpenClOnCpu.device(sound, OpenClOnCpu.PATIENT_NANOS);
    assertSame(expected, run(device), "no failure");
    long batches = device.batches();
    assertTrue(batches > FRAMES, "batches " + batches);
    int failed = 0;
    long every = failure == Failure.HANGS ? 29 : 1; // each of them waits for the deadline
    for (long last = 0; last < sound.calls(); last += every) {
      SimulatedDriver simulated = new SimulatedDriver();
      FailingDriver driver = new FailingDriver(simulated, failure, last);
      OpenClDevice failing = OpenClOnCpu.device(driver, DEADLINE_NANOS);
      assertSame(expected, run(failing), failure + " after " + last + " calls");
      failed += failing.failure().isPresent() ? 1 : 0;
      assertTrue(failing.batches() < batches);
      failing.close();
      assertFalse(simulated.isReleased, "memory that a failed driver may still write to");
    }
    System.out.println(failure + " survived at " + failed + " of " + sound.calls() + " calls");
    assertEquals((sound.calls() + every - 1) / every, failed);
  }

  @Test
  void anOpenClDeviceMovesTheToolToTheBitsOfTheCpu() {
    try (OpenClDevice device = OpenClOnCpu.open(JoclDriver.source())) {
      assertSame(run(CollisionDevice.CPU), run(device), device.name());
      assertTrue(device.batches() > FRAMES, "batches " + device.batches());
    }
  }

  @Test
  void aKernelThatTakesTooLongIsGivenUpAndTheCpuGoesOn() {
    String slow =
        OpenClOnCpu.sourceWith(
            "  int id = get_global_id(0);",
            """
              int id = get_global_id(0);
              double work = id + 1.0;
              for (int n = 0; id == 0 && n < 100000000; n++) {
                work = work * 1.0000001 + 1e-9; // each step waits for the one before
              }
              if (work == 0) {
                return; // never; but the compiler cannot leave the steps out
              }
            """);
    Run expected = run(CollisionDevice.CPU);
    OpenClDevice device =
        OpenClOnCpu.device(new JoclDriver(OpenClOnCpu.device(), slow), DEADLINE_NANOS);
    assertSame(expected, run(device), "slow kernel");
    assertEquals("it did not answer in time", device.failure().orElseThrow());
    assertEquals(0, device.batches());
  }

  @Test
  void aDeviceWhoseVerdictsTurnWrongIsGivenUp() {
    assertGivenUp(driver -> driver.lies = true);
  }

  @Test
  void aDeviceThatCallsFullSpaceEmptyIsGivenUp() {
    assertGivenUp(driver -> driver.liesAboutCubes = true);
  }

  @Test
  void anAnswerThatTheKernelNeverGivesPromisesNothing() {
    SimulatedDriver simulated = new SimulatedDriver();
    OpenClDevice device = OpenClOnCpu.device(simulated, OpenClOnCpu.PATIENT_NANOS);
    NearBall ball = new NearBall(400);
    LegBatch batch = device.keep(ball.voxels()).newBatch(ball);
    simulated.talksNonsense = true;
    assertTrue(batch.judge(ball.motions(1)));
    for (int n = 0; n < ball.count(); n++) {
      assertEquals(LegVerdict.DOUBT, batch.verdict(0, n));
      assertEquals(0, batch.emptyAround(n));
    }
  }

  private static void assertGivenUp(Consumer<SimulatedDriver> fault) {
    SimulatedDriver simulated = new SimulatedDriver();
    OpenClDevice device = OpenClOnCpu.device(simulated, OpenClOnCpu.PATIENT_NANOS);
    NearBall ball = new NearBall(400);
    LegBatch batch = device.keep(ball.voxels()).newBatch(ball);
    assertTrue(batch.judge(ball.motions(1)));
    fault.accept(simulated);
    int motions = 0;
    while (batch.judge(ball.motions(1))) {
      motions++;
    }
    assertEquals("it was wrong about a leg", device.failure().orElseThrow());
    assertTrue(motions < 400 / 16, "motions " + motions);
  }

  @Test
  void aHangingDeviceCostsOneFrameItsDeadline() {
    run(CollisionDevice.CPU);
    long deadline = 5_000_000;
    FailingDriver driver = new FailingDriver(new SimulatedDriver(), Failure.HANGS, 60);
    OpenClDevice device = OpenClOnCpu.device(driver, deadline);
    Run run = run(device);
    assertEquals("it did not answer in time", device.failure().orElseThrow());
    assertTrue(run.slowestNanos() >= deadline, "ns " + run.slowestNanos());
  }

  @Test
  void aDeviceThatIsClosedJudgesNothingAndTheCpuGoesOn() {
    SimulatedDriver simulated = new SimulatedDriver();
    OpenClDevice device = OpenClOnCpu.device(simulated, DEADLINE_NANOS);
    device.close();
    device.close();
    assertTrue(simulated.isReleased);
    assertSame(run(CollisionDevice.CPU), run(device), "closed");
    assertEquals(0, device.batches());
  }

  @Test
  void aDeviceThatFailsInTheSelfTestIsRefused() {
    for (Failure failure : new Failure[] {Failure.EXCEPTION, Failure.LINKAGE}) {
      OpenClException refusal =
          assertThrows(
              OpenClException.class,
              () ->
                  OpenClDevice.open(
                      () -> new FailingDriver(new SimulatedDriver(), failure, 20),
                      DEADLINE_NANOS,
                      new LaunchCost(OpenClOnCpu.PATIENT_NANOS)));
      assertFalse(refusal.isWrongChoice());
    }
  }

  @Test
  void aSlowDeviceIsNotUsed() {
    OpenClDevice device =
        new OpenClDevice(
            new SimulatedDriver(),
            OpenClOnCpu.PATIENT_NANOS,
            new LaunchCost(OpenClOnCpu.PATIENT_NANOS));
    assertSame(run(CollisionDevice.CPU), run(device), "slow");
    assertEquals(0, device.batches());
  }
}
