package org.palpate.loop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.palpate.testing.ScriptedDevice.fresh;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.palpate.device.DeviceDecorator;
import org.palpate.device.DeviceState;
import org.palpate.device.ReadStatus;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.PointFrame;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.ProxySolver;
import org.palpate.testing.Floor;
import org.palpate.testing.ScriptedDevice;

class HapticLoopTest {
  private static final long MS = ManualClock.MS;

  private final Floor floor = Floor.make();
  private final ManualClock clock = new ManualClock();
  private final List<LoopEnd> ends = new ArrayList<>();
  private final ScriptedDevice device = new ScriptedDevice((read, state) -> pressed(state, read));

  @Test
  void aFrameBeginsAtEachDeadline() {
    List<Long> starts = starts(20, frame -> 0);
    for (int i = 0; i < 20; i++) {
      assertEquals((5 + i) * MS, starts.get(i));
    }
    LoopReport report = loopReport;
    assertEquals(1000, report.rateHz(), 1e-9);
    assertEquals(0, report.lateFrames());
    assertEquals(1000, report.periodMicros().p50(), 1);
    assertEquals(1000, report.periodMicros().max(), 1);
    assertEquals(0, report.workMicros().max());
  }

  @Test
  void aSmallLatenessDoesNotMoveTheDeadlines() {
    List<Long> starts = starts(20, frame -> frame == 4 ? MS * 2 / 5 : 0);
    assertEquals(9 * MS + MS * 2 / 5, starts.get(4));
    assertEquals(10 * MS, starts.get(5));
    assertEquals(0, loopReport.lateFrames());
  }

  @Test
  void aLateFrameIsCountedAndItsMissedDeadlinesAreSkipped() {
    List<Long> starts = starts(20, frame -> frame == 4 ? MS * 57 / 10 : 0);
    assertEquals(9 * MS + MS * 57 / 10, starts.get(4));
    assertEquals(
        16 * MS, starts.get(5), "the next deadline of the grid that is half a period away");
    assertEquals(17 * MS, starts.get(6));
    assertEquals(1, loopReport.lateFrames());
  }

  @Test
  void theGapAfterALateFrameIsNeverBelowHalfAPeriod() {
    for (long late = 0; late < 5 * MS; late += 10_007) {
      long lateness = late;
      clock.nowNanos = 5 * MS;
      List<Long> starts = starts(6, frame -> frame == 3 ? lateness : 0);
      long gap = starts.get(4) - starts.get(3);
      assertTrue(gap >= MS / 2 && gap <= MS * 3 / 2, "late=" + late + " gap=" + gap);
      assertEquals(0, (starts.get(4) - starts.get(0)) % MS);
    }
  }

  @Test
  void aDeviceThatDisconnectsEndsTheLoopWithZeroForce() {
    endAfter(50, ReadStatus.DISCONNECTED, null);
    HapticLoop loop = loop();
    loop.run();
    assertEquals(LoopEnd.Cause.DEVICE_GONE, loop.end().cause());
    assertEquals(0, device.lastForce().length());
    assertEquals(50, loop.report().statistics().frames());
    assertEquals(1, ends.size());
  }

  @Test
  void aReadThatThrowsEndsTheLoopWithZeroForceAndIsReportedOnce() {
    IllegalStateException fault = new IllegalStateException("the cable");
    endAfter(50, ReadStatus.FRESH, fault);
    HapticLoop loop = loop();
    loop.run();
    assertFailed(loop, fault);
    assertTrue(device.forces.get(device.forces.size() - 2).length() > 1, "force was on");
  }

  @Test
  void aWriteThatThrowsEndsTheLoopAndTheSecondFailureIsSuppressed() {
    IllegalStateException fault = new IllegalStateException("write");
    device.script =
        (read, state) -> {
          device.onWrite = read == 50 ? fault : null;
          return pressed(state, read);
        };
    HapticLoop loop = loop();
    loop.run();
    assertSame(fault, loop.end().failure());
    assertEquals(1, ends.size());
  }

  @Test
  void aSolverThatThrowsEndsTheLoopWithZeroForceWithoutSlewLimit() {
    StackOverflowError fault = new StackOverflowError();
    ProxySolver broken =
        (scene, d, point) -> {
          throw fault;
        };
    PointFrame frame = slewed();
    device.script =
        (read, state) -> {
          if (read == 50) {
            frame.requestSolver(broken);
          }
          return pressed(state, read);
        };
    HapticLoop loop = new HapticLoop(frame, settings(), ends::add);
    loop.run();
    assertFailed(loop, fault);
    assertTrue(device.forces.get(device.forces.size() - 2).length() > 1);
  }

  @Test
  void aSetUpOrWarmUpThatThrowsEndsTheLoopBeforeAnyForce() {
    IllegalStateException fault = new IllegalStateException("no memory to lock");
    LoopSettings failing =
        settings()
            .withWarmUp(
                () -> {
                  throw fault;
                });
    HapticLoop loop = new HapticLoop(floor.frame(device), failing, ends::add);
    loop.run();
    assertFailed(loop, fault);
    assertEquals(1, device.forces.size());
  }

  @Test
  void aReadThatHangsForTenSecondsIsFollowedByZeroForceAndARamp() {
    device.script =
        (read, state) -> {
          clock.nowNanos += read == 50 ? 10_000 * MS : 0;
          return read == 100 ? ReadStatus.DISCONNECTED : pressed(state, read);
        };
    HapticLoop loop = loop();
    loop.run();
    assertEquals(0, device.forces.get(51).length());
    assertTrue(device.forces.get(99).length() > 0.3);
    assertEquals(1, loop.report().statistics().faults().clockJumps());
    assertEquals(1, loop.report().lateFrames());
  }

  @Test
  void aFrameThatDoesNotReturnIsEndedByForceAndWritesNothingMore() {
    for (int hanging : new int[] {0, 50}) {
      ends.clear();
      ScriptedDevice stuck = new ScriptedDevice(null);
      HapticLoop loop = new HapticLoop(floor.frame(stuck), settings(), ends::add);
      stuck.script =
          (read, state) -> {
            boolean ended = loop.supervise(clock.nowNanos);
            for (int tick = 1; read == hanging && !ended; tick++) {
              assertEquals(tick > 10, loop.supervise(clock.nowNanos += 100 * MS));
              ended = loop.end() != null;
            }
            return pressed(state, read);
          };
      loop.run();
      assertEquals(LoopEnd.Cause.HUNG, loop.end().cause());
      assertEquals(1, stuck.closed);
      assertEquals(0, stuck.lastForce().length());
      assertEquals(1, ends.size());
    }
  }

  @Test
  void aThreadThatIsNotRunIsNotEndedWhileTheDeviceHasZeroForce() {
    LoopEnd end = endAfterStandingStill(16, 16, 12);
    assertEquals(LoopEnd.Cause.DEVICE_GONE, end.cause());
    assertEquals(0, device.closed);
  }

  @Test
  void aThreadThatIsNotRunIsEndedWhileTheDeviceExertsForce() {
    LoopEnd end = endAfterStandingStill(16, 16, 5);
    assertEquals(LoopEnd.Cause.HUNG, end.cause());
    assertEquals(1, device.closed);
  }

  @Test
  void aThreadThatIsNotRunIsEndedWhileTheDeviceMayHoldAForceThatZeroDidNotReplace() {
    device.reachable = false;
    LoopEnd end = endAfterStandingStill(16, 16, 12);
    assertEquals(LoopEnd.Cause.HUNG, end.cause());
    assertEquals(1, device.closed);
  }

  @Test
  void aLastWriteThatDoesNotReturnIsEndedByForceEvenIfTheDeviceHasZeroForce() {
    HapticLoop[] loops = new HapticLoop[1];
    ScriptedDevice gone =
        new ScriptedDevice(
            (read, state) -> read == 20 ? ReadStatus.DISCONNECTED : fresh(state, read, 16, 16, 12));
    DeviceDecorator stuck =
        new DeviceDecorator(gone) {
          private int writes;

          @Override
          public boolean write(Vec3 forceNewton, Vec3 torqueNewtonMm) {
            boolean isLast = writes++ == 21; // after 20 frames and the one that found it gone
            boolean ended = false;
            for (int tick = 0; tick < 100 && isLast && !ended; tick++) {
              ended = loops[0].supervise(clock.nowNanos += 100 * MS);
            }
            return super.write(forceNewton, torqueNewtonMm);
          }
        };
    loops[0] = new HapticLoop(floor.frame(stuck), settings(), ends::add);
    loops[0].run();
    assertEquals(LoopEnd.Cause.HUNG, loops[0].end().cause());
    assertEquals(1, gone.closed);
    assertEquals(1, ends.size());
  }

  /** Lets the thread stand still for ten seconds before its eleventh frame, and returns the end. */
  private LoopEnd endAfterStandingStill(double x, double y, double z) {
    device.script =
        (read, state) ->
            read == 20 ? ReadStatus.DISCONNECTED : fresh(state, read, x, y, read < 5 ? 12 : z);
    HapticLoop[] loops = new HapticLoop[1];
    int[] waits = new int[1];
    Pacer pacer =
        deadline -> {
          clock.awaitUntil(deadline);
          boolean still = waits[0]++ == 10;
          for (int tick = 0; tick < 100 && still && !loops[0].supervise(clock.nowNanos); tick++) {
            clock.nowNanos += 100 * MS;
          }
        };
    loops[0] =
        new HapticLoop(floor.frame(device), settings().with(pacer, ThreadSetup.NONE), ends::add);
    loops[0].run();
    assertEquals(1, ends.size());
    return loops[0].end();
  }

  @Test
  void aStoppedProcessIsNoHang() {
    HapticLoop[] loops = new HapticLoop[1];
    device.script =
        (read, state) -> {
          assertFalse(loops[0].supervise(clock.nowNanos));
          if (read == 50) {
            clock.nowNanos += 10_000 * MS;
            assertFalse(loops[0].supervise(clock.nowNanos));
          }
          return read == 100 ? ReadStatus.DISCONNECTED : pressed(state, read);
        };
    loops[0] = loop();
    loops[0].run();
    assertEquals(LoopEnd.Cause.DEVICE_GONE, loops[0].end().cause());
  }

  @Test
  void stoppingAThreadThatIsStuckInADriverClosesTheDeviceUnderIt() throws InterruptedException {
    CountDownLatch stuck = new CountDownLatch(1);
    CountDownLatch never = new CountDownLatch(1);
    device.script =
        (read, state) -> {
          if (read == 50) {
            stuck.countDown();
            awaitUninterruptibly(never);
          }
          return pressed(state, read);
        };
    LoopSettings short_ = new LoopSettings(MS, clock, clock, ThreadSetup.NONE, () -> {}, 10 * MS);
    HapticLoop loop = new HapticLoop(floor.frame(device), short_, ends::add);
    loop.start();
    stuck.await();
    assertEquals(LoopEnd.Cause.HUNG, loop.stop().cause());
    assertEquals(1, device.closed);
    assertEquals(0, device.lastForce().length());
    never.countDown();
  }

  @Test
  void stopWaitsForTheFrameAndLeavesZeroForce() throws InterruptedException {
    CountDownLatch running = new CountDownLatch(100);
    device.script =
        (read, state) -> {
          running.countDown();
          return pressed(state, read);
        };
    HapticLoop loop = loop();
    loop.start();
    running.await();
    assertEquals(LoopEnd.Cause.STOPPED, loop.stop().cause());
    assertEquals(LoopEnd.Cause.STOPPED, loop.stop().cause());
    assertTrue(loop.awaitEnd(1, TimeUnit.MILLISECONDS));
    int written = device.forces.size();
    assertEquals(0, device.lastForce().length());
    assertEquals(written - 1, loop.report().frames());
    assertEquals(1, ends.size());
    assertEquals(0, device.closed, "the loop leaves the device open");
  }

  @Test
  void stopWaitsForAWarmUpThatIsLongerThanAHang() throws InterruptedException {
    long hangNanos = 200 * MS;
    CountDownLatch warm = new CountDownLatch(1);
    LoopSettings slow =
        new LoopSettings(
            MS, clock, clock, ThreadSetup.NONE, () -> awaitUninterruptibly(warm), hangNanos);
    HapticLoop loop = new HapticLoop(floor.frame(device), slow, ends::add);
    loop.start();
    Thread later =
        new Thread(
            () -> {
              assertFalse(loop.awaitEnd(hangNanos * 3 / 2, TimeUnit.NANOSECONDS));
              warm.countDown();
            });
    later.start();
    assertEquals(LoopEnd.Cause.STOPPED, loop.stop().cause());
    later.join();
    assertEquals(0, device.closed);
  }

  @Test
  void stopEndsAWarmUpAndInterruptsNothingAfterIt() throws InterruptedException {
    CountDownLatch warming = new CountDownLatch(1);
    List<Boolean> interrupted = new ArrayList<>();
    Runnable warmUp =
        () -> {
          SteadyWarmUp steady =
              new SteadyWarmUp(NanoClock.SYSTEM, () -> true, () -> false, nanos -> {});
          steady.run(warming::countDown, 0, Long.MAX_VALUE);
        };
    DeviceDecorator watched =
        new DeviceDecorator(device) {
          @Override
          public boolean write(Vec3 forceNewton, Vec3 torqueNewtonMm) {
            interrupted.add(Thread.currentThread().isInterrupted());
            return super.write(forceNewton, torqueNewtonMm);
          }
        };
    HapticLoop loop =
        new HapticLoop(floor.frame(watched), settings().withWarmUp(warmUp), ends::add);
    loop.start();
    warming.await();
    assertEquals(LoopEnd.Cause.STOPPED, loop.stop().cause());
    assertEquals(List.of(false), interrupted, "zero force at the end");
    assertEquals(0, device.closed);
  }

  @Test
  void aWarmUpDoesNotBeginAfterAStop() throws InterruptedException {
    CountDownLatch stopped = new CountDownLatch(1);
    List<String> steps = new ArrayList<>();
    ThreadSetup setup =
        () -> {
          awaitUninterruptibly(stopped);
          return ThreadSetup.Granted.NOTHING;
        };
    LoopSettings settings = settings().with(clock, setup).withWarmUp(() -> steps.add("warm-up"));
    HapticLoop loop = new HapticLoop(floor.frame(device), settings, ends::add);
    loop.start();
    Thread stopping = new Thread(loop::stop);
    stopping.start();
    while (stopping.getState() != Thread.State.TIMED_WAITING) {
      Thread.onSpinWait();
    }
    stopped.countDown();
    stopping.join();
    assertEquals(LoopEnd.Cause.STOPPED, loop.end().cause());
    assertEquals(List.of(), steps);
  }

  @Test
  void aLoopThatNeverStartedStopsAtOnce() {
    assertEquals(LoopEnd.Cause.STOPPED, loop().stop().cause());
    assertEquals(1, ends.size());
    assertEquals(0, device.forces.size());
  }

  @Test
  void theStatusReportsFramesContactAndForceWhileTheLoopRuns() {
    List<LoopStatus> seen = new ArrayList<>();
    HapticLoop[] loops = new HapticLoop[1];
    device.script =
        (read, state) -> {
          seen.add(loops[0].status());
          return read == 60 ? ReadStatus.DISCONNECTED : pressed(state, read);
        };
    loops[0] = loop();
    loops[0].run();
    LoopStatus last = seen.get(60);
    assertEquals(60, last.frames());
    assertTrue(last.contact());
    assertEquals(1.5, last.forceNewton(), 1e-5);
  }

  private LoopReport loopReport;

  /** Runs frames whose wake-ups are late by the given times, and returns their starts. */
  private List<Long> starts(int frames, java.util.function.IntToLongFunction lateNanos) {
    List<Long> starts = new ArrayList<>();
    int[] waits = new int[1];
    Pacer pacer =
        deadline -> {
          clock.wakeUpLateNanos = lateNanos.applyAsLong(waits[0]++);
          clock.awaitUntil(deadline);
        };
    ScriptedDevice counted = ScriptedDevice.at(16, 16, 20);
    ScriptedDevice.Script still = counted.script;
    counted.script =
        (read, state) -> {
          if (read == frames) {
            return ReadStatus.DISCONNECTED;
          }
          starts.add(clock.nowNanos);
          return still.read(read, state);
        };
    HapticLoop loop =
        new HapticLoop(floor.frame(counted), settings().with(pacer, ThreadSetup.NONE), end -> {});
    loop.run();
    loopReport = loop.report();
    return starts;
  }

  private void assertFailed(HapticLoop loop, Throwable fault) {
    assertEquals(LoopEnd.Cause.FAILED, loop.end().cause());
    assertSame(fault, loop.end().failure());
    assertEquals(0, device.lastForce().length());
    assertEquals(1, ends.size());
  }

  private void endAfter(int frames, ReadStatus status, RuntimeException fault) {
    device.script =
        (read, state) -> {
          if (read == frames && fault != null) {
            throw fault;
          }
          return read == frames ? status : pressed(state, read);
        };
  }

  private static ReadStatus pressed(DeviceState state, int read) {
    return fresh(state, read, 16, 16, read < 10 ? 12 : 5);
  }

  private static void awaitUninterruptibly(CountDownLatch latch) {
    boolean waiting = true;
    while (waiting) {
      try {
        latch.await();
        waiting = false;
      } catch (InterruptedException e) {
        // A driver that is stuck ignores interrupts.
        waiting = true;
      }
    }
  }

  private PointFrame slewed() {
    FrameSettings settings = new FrameSettings(Floor.settings().force(), 10, 0.25, 0, 20 * MS, 64);
    return floor.frame(device, settings);
  }

  private LoopSettings settings() {
    return new LoopSettings(MS, clock, clock, ThreadSetup.NONE, () -> {}, 1000 * MS);
  }

  private HapticLoop loop() {
    return new HapticLoop(floor.frame(device), settings(), ends::add);
  }
}
