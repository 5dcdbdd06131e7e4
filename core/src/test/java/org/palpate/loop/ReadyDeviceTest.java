package org.palpate.loop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;
import org.palpate.device.DeviceDecorator;
import org.palpate.device.DeviceState;
import org.palpate.device.ReadStatus;
import org.palpate.geometry.Vec3;
import org.palpate.testing.Floor;
import org.palpate.testing.ScriptedDevice;

/** Tests how a loop waits until its device is ready. */
class ReadyDeviceTest {
  private static final long MS = ManualClock.MS;

  private final Floor floor = Floor.make();
  private final ManualClock clock = new ManualClock();
  private final ScriptedDevice device = ScriptedDevice.at(16, 16, 20);

  /** A device that tells what the haptic thread does with it. */
  private final class Prepared extends DeviceDecorator {
    private final List<String> steps = new ArrayList<>();
    private final CountDownLatch asked = new CountDownLatch(1);
    private final BooleanSupplier ready;

    private Prepared(BooleanSupplier ready) {
      super(ReadyDeviceTest.this.device);
      this.ready = ready;
    }

    @Override
    public boolean isReady() {
      boolean isReady = ready.getAsBoolean();
      steps.add(isReady ? "ready" : "not ready");
      asked.countDown();
      return isReady;
    }

    @Override
    public ReadStatus read(DeviceState state) {
      steps.add("read");
      return ReadStatus.DISCONNECTED;
    }

    @Override
    public boolean write(Vec3 forceNewton, Vec3 torqueNewtonMm) {
      steps.add(forceNewton.length() == 0 ? "zero force" : "force");
      steps.add(Thread.currentThread().isInterrupted() ? "interrupted" : "");
      return true;
    }

    private List<String> steps() {
      steps.removeIf(String::isEmpty);
      return steps;
    }
  }

  @Test
  void theFirstFrameWaitsUntilTheWarmUpIsOverAndTheDeviceIsReady() {
    int[] questions = new int[1];
    Prepared prepared = new Prepared(() -> ++questions[0] == 3);
    LoopSettings settings = settings().withWarmUp(() -> prepared.steps.add("warm-up"));
    HapticLoop loop = new HapticLoop(floor.frame(prepared), settings, end -> {});
    loop.run();
    assertEquals(LoopEnd.Cause.DEVICE_GONE, loop.end().cause());
    assertEquals(
        List.of("warm-up", "not ready", "not ready", "ready", "read"),
        prepared.steps().subList(0, 5));
  }

  @Test
  void stopEndsTheWaitForADeviceWithZeroForceAndInterruptsNothingAfterIt()
      throws InterruptedException {
    Prepared prepared = new Prepared(() -> false);
    HapticLoop loop = new HapticLoop(floor.frame(prepared), settings(), end -> {});
    loop.start();
    assertTrue(prepared.asked.await(1, TimeUnit.MINUTES), "nobody asks the device");
    assertEquals(LoopEnd.Cause.STOPPED, loop.stop().cause());
    prepared.steps.removeIf("not ready"::equals);
    assertEquals(List.of("zero force"), prepared.steps(), "no frame reads the device");
    assertEquals(0, device.closed);
  }

  @Test
  void whoeverInterruptsTheWaitForADeviceEndsTheLoopBeforeItsFirstFrame() {
    Prepared prepared = new Prepared(() -> false);
    HapticLoop loop = new HapticLoop(floor.frame(prepared), settings(), end -> {});
    Thread.currentThread().interrupt();
    loop.run();
    assertTrue(Thread.interrupted(), "the caller's interrupt stays");
    assertEquals(LoopEnd.Cause.STOPPED, loop.end().cause());
    assertEquals(List.of("not ready", "zero force", "interrupted"), prepared.steps());
  }

  @Test
  void aDeviceThatCannotBeMadeReadyEndsTheLoopBeforeAnyForce() {
    IllegalStateException fault = new IllegalStateException("no plan");
    Prepared prepared =
        new Prepared(
            () -> {
              throw fault;
            });
    HapticLoop loop = new HapticLoop(floor.frame(prepared), settings(), end -> {});
    loop.run();
    assertEquals(LoopEnd.Cause.FAILED, loop.end().cause());
    assertSame(fault, loop.end().failure());
    assertEquals(List.of("zero force"), prepared.steps());
  }

  private LoopSettings settings() {
    return new LoopSettings(MS, clock, clock, ThreadSetup.NONE, () -> {}, 1000 * MS);
  }
}
