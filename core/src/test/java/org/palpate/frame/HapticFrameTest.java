package org.palpate.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.palpate.testing.ScriptedDevice.fresh;

import org.junit.jupiter.api.Test;
import org.palpate.device.ReadStatus;
import org.palpate.edit.BrushEdit;
import org.palpate.edit.SwapEdit;
import org.palpate.edit.VoxelEdit;
import org.palpate.force.ForceSettings;
import org.palpate.geometry.Vec3;
import org.palpate.loop.ManualClock;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.proxy.reference.CollisionOnlySolver;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.statistics.SkipKind;
import org.palpate.sync.Accumulator;
import org.palpate.sync.TouchProperties;
import org.palpate.testing.Floor;
import org.palpate.testing.ScriptedDevice;

class HapticFrameTest {
  private static final long MS = ManualClock.MS;

  private final Floor floor = Floor.make();
  private long nowNanos = 1;

  @Test
  void theForceIsStiffnessTimesDepth() {
    ScriptedDevice device = descendsTo(5);
    PointFrame frame = floor.frame(device);
    run(frame, 20);
    assertEquals(1.5, device.lastForce().z, 1e-5);
    assertEquals(0, device.lastForce().x);
    assertTrue(frame.point().contact);
    FrameStatistics counts = frame.statistics();
    assertEquals(20, counts.frames());
    assertEquals(10, counts.contactFrames());
    assertEquals(0, counts.freed());
    assertEquals(device.lastForce().length(), counts.maxForceNewton());
  }

  @Test
  void aRepeatedSampleHoldsTheForceBitForBit() {
    ScriptedDevice device = descendsTo(5);
    PointFrame frame = floor.frame(device);
    run(frame, 20);
    device.script = (read, state) -> ReadStatus.REPEATED;
    Vec3 held = device.lastForce();
    run(frame, 20);
    assertTrue(device.lastForce().sameBits(held));
    assertEquals(20, frame.statistics().faults().held());
    assertFalse(frame.followed());
    assertEquals(0, frame.point().legs.count());
  }

  @Test
  void afterTwentyMillisecondsOfSilenceTheForceIsZeroAndThenRampedBack() {
    ScriptedDevice device = descendsTo(5);
    PointFrame frame = floor.frame(device);
    run(frame, 20);
    ScriptedDevice.Script speaking = device.script;
    device.script = (read, state) -> ReadStatus.REPEATED;
    run(frame, 21);
    assertEquals(0, device.lastForce().length());
    device.script = speaking;
    run(frame, 1);
    assertEquals(0, device.lastForce().length(), "the ramp begins at zero");
    run(frame, 25);
    assertEquals(0.25 * 1.5, device.lastForce().z, 1e-5);
    run(frame, 75);
    assertEquals(1.5, device.lastForce().z, 1e-5);
    assertEquals(1, frame.statistics().faults().silences());
  }

  @Test
  void aSlowDeviceMayBeSilentForThreeReportIntervals() {
    assertEquals(20 * MS, Watchdog.silenceNanosFor(slow(8 * MS / 2)));
    assertEquals(48 * MS, Watchdog.silenceNanosFor(slow(16 * MS)));
  }

  @Test
  void samplesThatAreNotFiniteAreIgnored() {
    double[] bad = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY};
    ScriptedDevice device = descendsTo(5);
    PointFrame frame = floor.frame(device);
    run(frame, 20);
    Vec3 held = device.lastForce();
    Vec3 position = new Vec3().set(frame.point().position);
    device.script = (read, state) -> fresh(state, read, 16, bad[read % 3], 16);
    run(frame, 15);
    assertTrue(device.lastForce().sameBits(held));
    assertTrue(frame.point().position.sameBits(position));
    assertEquals(15, frame.statistics().faults().notFinite());
    run(frame, 10);
    assertEquals(0, device.lastForce().length());
  }

  @Test
  void samplesOfABackwardTimeAreIgnoredUntilASilenceHasPassed() {
    ScriptedDevice device = descendsTo(5);
    PointFrame frame = floor.frame(device);
    run(frame, 20);
    device.script = (read, state) -> fresh(state, read - 1000, 16, 16, 20);
    run(frame, 20);
    assertEquals(20, frame.statistics().faults().badTimes());
    assertEquals(Floor.TOP, frame.point().position.z, 1e-5);
    run(frame, 4);
    assertEquals(20, frame.point().position.z, "a clock that was set back counts after a silence");
  }

  @Test
  void aDeviceWithAStoppedClockIsSilentButADeviceWithoutAClockIsNot() {
    ScriptedDevice stuck = descendsTo(5);
    PointFrame frame = floor.frame(stuck);
    run(frame, 20);
    stuck.script = (read, state) -> fresh(state, 19, 16, 16, 5);
    run(frame, 21);
    assertEquals(0, stuck.lastForce().length());
    ScriptedDevice clockless = new ScriptedDevice((read, state) -> fresh(state, 0, 16, 16, 5));
    PointFrame other = floor.frame(clockless);
    run(other, 200);
    assertEquals(0, other.statistics().faults().held());
  }

  @Test
  void afterAMachineWasSuspendedTheForceStartsFromZero() {
    ScriptedDevice device = descendsTo(5);
    PointFrame frame = floor.frame(device);
    run(frame, 20);
    nowNanos += 3_600_000 * MS;
    run(frame, 1);
    assertEquals(0, device.lastForce().length());
    run(frame, 50);
    assertEquals(0.75, device.lastForce().z, 1e-5);
    assertEquals(1, frame.statistics().faults().clockJumps());
  }

  @Test
  void aFrameClockThatGoesBackIsCountedAndChangesNoForce() {
    ScriptedDevice device = descendsTo(5);
    PointFrame frame = floor.frame(device);
    run(frame, 20);
    nowNanos -= 3_600_000 * MS;
    run(frame, 30);
    assertEquals(1.5, device.lastForce().z, 1e-5);
    assertEquals(1, frame.statistics().faults().clockJumps());
  }

  @Test
  void aFrameClockThatStandsStillKeepsTheForceUntilTimePasses() {
    ScriptedDevice device = descendsTo(5);
    PointFrame frame = floor.frame(device);
    run(frame, 20);
    for (int n = 0; n < 50; n++) {
      assertEquals(FrameOutcome.RUNNING, frame.run(nowNanos));
      assertEquals(1.5, device.lastForce().z, 1e-5);
    }
    assertEquals(0, frame.statistics().faults().clockJumps());
    device.script = (read, state) -> ReadStatus.REPEATED;
    run(frame, 22);
    assertEquals(0, device.lastForce().length(), "a silence ends when time passes again");
  }

  @Test
  void aDeviceThatDisappearsBetweenReadAndWriteGetsZeroForceLast() {
    ScriptedDevice device = descendsTo(5);
    PointFrame frame = floor.frame(device);
    run(frame, 20);
    ScriptedDevice.Script speaking = device.script;
    device.script =
        (read, state) -> {
          device.reachable = false;
          return read == 20 ? speaking.read(read, state) : ReadStatus.DISCONNECTED;
        };
    run(frame, 1);
    device.reachable =
        true; // It is plugged in again, and the frame that finds it gone still sends zero.
    ScriptedDevice.Script gone = (read, state) -> ReadStatus.DISCONNECTED;
    device.script = gone;
    assertEquals(FrameOutcome.DEVICE_GONE, frame.run(nowNanos));
    assertEquals(0, device.lastForce().length());
  }

  @Test
  void aPointThatStartsInASolidIsSetFreeAndTheForceIsRamped() {
    ScriptedDevice device = ScriptedDevice.at(16.25, 16.25, 6.5);
    PointFrame frame = floor.frame(device);
    run(frame, 1);
    assertTrue(frame.wasFreed());
    assertEquals(0, device.lastForce().length());
    run(frame, 10);
    assertFalse(frame.wasFreed());
    assertEquals(0.1 * 0.75, device.lastForce().z, 1e-5);
    run(frame, 100);
    assertEquals(0.75, device.lastForce().z, 1e-5);
    assertEquals(1, frame.statistics().freed());
  }

  @Test
  void aPointToWhichASolidComesIsSetFreeAndTheForceIsRamped() {
    ScriptedDevice device = descendsTo(5);
    PointFrame frame = floor.frame(device);
    run(frame, 20);
    Vec3 p = frame.point().position;
    floor.edits.offer(
        new VoxelEdit(0, (int) Math.floor(p.x), (int) Math.floor(p.y), Floor.TOP, true));
    run(frame, 1);
    assertTrue(frame.wasFreed());
    assertFalse(floor.scene.touches(p.x, p.y, p.z));
    assertEquals(0, device.lastForce().length());
    run(frame, 50);
    assertTrue(device.lastForce().length() > 0.1);
    assertEquals(1, frame.statistics().freed());
  }

  @Test
  void aRemovedSolidLetsThePointFollow() {
    ScriptedDevice device = descendsTo(5);
    PointFrame frame = floor.frame(device);
    run(frame, 20);
    floor.edits.offer(new BrushEdit(0, new Vec3(16, 16, 6), 3, false));
    run(frame, 20);
    assertEquals(5, frame.point().position.z);
    assertFalse(frame.point().contact);
    assertEquals(0, device.lastForce().length());
  }

  @Test
  void aLargeBrushTakesABoundedNumberOfVoxelsAFrame() {
    ScriptedDevice device = ScriptedDevice.at(2, 2, 30);
    PointFrame frame = floor.frame(device);
    BrushEdit brush = new BrushEdit(0, new Vec3(16, 16, 20), 5, true);
    floor.edits.offer(brush);
    int frames = 0;
    long solid = floor.bits.solidCount();
    while (!brush.isDone()) {
      run(frame, 1);
      frames++;
      assertTrue(floor.bits.solidCount() - solid <= Floor.settings().editVoxelsAFrame());
      solid = floor.bits.solidCount();
    }
    assertEquals((11 * 11 * 11 + 63) / 64, frames, "11^3 voxels, 64 a frame");
    assertEquals(ballVoxels(16, 16, 20, 5), solid - (long) Floor.TOP * Floor.EDGE * Floor.EDGE);
    assertTrue(floor.edits.isIdle());
  }

  @Test
  void aSwapTakesOneFrameAndReturnsTheReplacedCube() {
    ScriptedDevice device = descendsTo(5);
    PointFrame frame = floor.frame(device);
    run(frame, 20);
    SwapEdit swap = new SwapEdit(0, new org.palpate.volume.BitCube(32, 32, 32));
    assertThrows(IllegalStateException.class, swap::replaced);
    floor.edits.offer(swap);
    run(frame, 1);
    assertEquals(floor.bits, swap.replaced());
    assertEquals(5, frame.point().position.z);
  }

  @Test
  void aDeviceThatDisconnectsGetsZeroForceLast() {
    ScriptedDevice device = descendsTo(5);
    PointFrame frame = floor.frame(device);
    run(frame, 20);
    device.script = (read, state) -> ReadStatus.DISCONNECTED;
    assertEquals(FrameOutcome.DEVICE_GONE, frame.run(nowNanos));
    assertEquals(0, device.lastForce().length());
    assertEquals(20, frame.statistics().frames());
  }

  @Test
  void aDeviceThatCannotBeWrittenToForTwentyMillisecondsIsGone() {
    ScriptedDevice device = descendsTo(5);
    PointFrame frame = floor.frame(device);
    run(frame, 20);
    device.reachable = false;
    run(frame, 20);
    assertEquals(FrameOutcome.DEVICE_GONE, frame.run(nowNanos));
    assertEquals(21, frame.statistics().faults().unreached());
  }

  @Test
  void theForceIsLimitedToTheMaximumAndTheSlew() {
    ScriptedDevice device = descendsTo(1);
    FrameSettings limited = new FrameSettings(ForceSettings.of(0.5, 0.2), 2, 0.25, 0, 20 * MS, 64);
    PointFrame frame = floor.frame(device, limited);
    Vec3 last = new Vec3();
    for (int i = 0; i < 40; i++) {
      run(frame, 1);
      assertTrue(device.lastForce().length() <= 2);
      assertTrue(device.lastForce().sub(last, new Vec3()).length() <= 0.25 * (1 + 1e-12));
      last.set(device.lastForce());
    }
    assertEquals(2, last.z, 1e-12);
  }

  @Test
  void stiffnessAndSolverCanBeChangedWhileFramesRun() {
    ScriptedDevice device = descendsTo(5);
    PointFrame frame = floor.frame(device);
    run(frame, 20);
    frame.requestForce(ForceSettings.of(1, 0));
    frame.requestSolver(new GuardedSolver(Floor.METRIC, 8));
    run(frame, 1);
    assertEquals(3, device.lastForce().z, 1e-5);
  }

  @Test
  void skipsCountOnceIfSolversTakeTurns() {
    ScriptedDevice device = descendsTo(5);
    PointFrame frame = floor.frame(device);
    CollisionOnlySolver none = new CollisionOnlySolver(new ExactRayCaster(), Floor.METRIC);
    for (int turn = 0; turn < 3; turn++) {
      frame.requestSolver(none);
      run(frame, 10);
      frame.requestSolver(new GuardedSolver(Floor.METRIC, 8));
      run(frame, 10);
    }
    assertEquals(30, frame.statistics().skipped().get(SkipKind.RESPONSE.key()));
  }

  @Test
  void aSolverThatReceivesAPointInASolidStartsFromAFreePoint() {
    ScriptedDevice device = descendsTo(5);
    PointFrame frame = floor.frame(device);
    frame.requestSolver((scene, d, point) -> point.position.set(d)); // enters the floor
    run(frame, 20);
    assertTrue(isBuried(frame));
    frame.requestSolver(new GuardedSolver(Floor.METRIC, 8));
    run(frame, 1);
    assertTrue(frame.wasFreed());
    assertFalse(isBuried(frame));
  }

  @Test
  void whatOneSolverSaysOfItsSurfaceDoesNotHoldForTheNext() {
    PointFrame frame = floor.frame(descendsTo(5));
    frame.requestSolver(
        (scene, d, point) -> {
          point.surfaceHeightMm = 0.3;
          point.limitsForceRate = true;
        });
    run(frame, 5);
    assertEquals(0.3, frame.point().surfaceHeightMm);
    frame.requestSolver((scene, d, point) -> {});
    run(frame, 1);
    assertEquals(0, frame.point().surfaceHeightMm);
    assertFalse(frame.point().limitsForceRate);
  }

  private boolean isBuried(PointFrame frame) {
    Vec3 p = frame.point().position;
    return floor.scene.touches(p.x, p.y, p.z);
  }

  @Test
  void publishesDevicePointForceAndContactOfTheSameFrame() {
    Accumulator accumulator = new Accumulator();
    TouchProperties touch = new TouchProperties(accumulator);
    ScriptedDevice device = descendsTo(5);
    PointFrame frame =
        new PointFrame(
            GridDevice.inGridCoordinates(device),
            new GuardedSolver(Floor.METRIC, 8),
            floor.scene,
            Floor.METRIC,
            Floor.settings(),
            floor.edits,
            touch::publish);
    run(frame, 20);
    assertTrue(accumulator.take());
    assertEquals("(16.0, 16.0, 5.0)", touch.touch().device(new Vec3()).toString());
    assertTrue(touch.touch().interactionPoint(new Vec3()).sameBits(frame.point().position));
    assertTrue(touch.touch().force(new Vec3()).sameBits(device.lastForce()));
    assertTrue(touch.touch().contact());
  }

  @Test
  void afterAMotionToAFreePositionThePointIsThereBitForBit() {
    ScriptedDevice device =
        new ScriptedDevice(
            (read, state) ->
                fresh(
                    state,
                    read,
                    16 + 9 * StrictMath.sin(read * 0.01),
                    16,
                    12 + 10 * StrictMath.cos(read % 1000 * 0.006)));
    PointFrame frame = floor.frame(device);
    run(frame, 5000);
    device.script = (read, state) -> fresh(state, read, 16.125, 16.25, 20.375);
    run(frame, 10);
    assertTrue(frame.point().position.sameBits(new Vec3(16.125, 16.25, 20.375)));
    assertEquals(0, device.lastForce().length());
  }

  private void run(PointFrame frame, int frames) {
    for (int i = 0; i < frames; i++) {
      assertEquals(FrameOutcome.RUNNING, frame.run(nowNanos));
      nowNanos += MS;
    }
  }

  /** Returns a device that rests above the floor for ten samples, and then at height z. */
  private static ScriptedDevice descendsTo(double z) {
    return new ScriptedDevice((read, state) -> fresh(state, read, 16, 16, read < 10 ? 12 : z));
  }

  private static org.palpate.device.DeviceSpecification slow(long intervalNanos) {
    return new org.palpate.device.DeviceSpecification("slow", "", 1, 1, 1, intervalNanos);
  }

  private static long ballVoxels(double x, double y, double z, double radius) {
    long count = 0;
    for (int k = 0; k < Floor.EDGE; k++) {
      for (int j = 0; j < Floor.EDGE; j++) {
        for (int i = 0; i < Floor.EDGE; i++) {
          double square =
              (i + 0.5 - x) * (i + 0.5 - x)
                  + (j + 0.5 - y) * (j + 0.5 - y)
                  + (k + 0.5 - z) * (k + 0.5 - z);
          count += square <= radius * radius ? 1 : 0;
        }
      }
    }
    return count;
  }
}
