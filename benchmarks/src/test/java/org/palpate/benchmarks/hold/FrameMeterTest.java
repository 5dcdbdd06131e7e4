package org.palpate.benchmarks.hold;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.benchmarks.hold.FrameMeter.Measured;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.device.DeviceDecorator;
import org.palpate.device.DeviceState;
import org.palpate.device.GuidedHand;
import org.palpate.device.HandStop;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.device.Tremor;
import org.palpate.edit.EditQueue;
import org.palpate.force.ForceSettings;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.ToolFrame;
import org.palpate.frame.ToolFramePublisher;
import org.palpate.geometry.Pose;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

class FrameMeterTest {
  private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
  private static final long FRAME_NANOS = 3_000_000;
  private static final long WAIT_NANOS = 40_000_000;

  @Test
  void aFrameLastsFromTheEndOfAWaitToTheBeginningOfTheNext() {
    ToolFrame frame = frame();
    FrameMeter meter = new FrameMeter(deadline -> spin(WAIT_NANOS), 10);
    meter.measure(frame);
    meter.awaitUntil(System.nanoTime()); // as after the warm-up, before any frame
    long deadline = System.nanoTime();
    for (int n = 0; n < 3; n++) {
      meter.awaitUntil(deadline);
      frame.run(n * 1_000_000L);
    }
    meter.awaitUntil(deadline);

    Measured all = meter.from(0);
    assertEquals(3, all.processorMicros().length);
    for (double micros : all.processorMicros()) {
      assertTrue(micros >= FRAME_NANOS / 1e3 && micros < WAIT_NANOS / 1e3, micros + " us");
    }
    for (int n = 0; n < 3; n++) {
      double leastMicros = (n + 1) * WAIT_NANOS / 1e3 + n * FRAME_NANOS / 1e3;
      assertTrue(all.lateMicros()[n] >= leastMicros, n + ": " + all.lateMicros()[n] + " us");
    }
    assertEquals(0, all.held());
    assertEquals(0, all.touching());
  }

  @Test
  void framesOfTheWarmUpAreLeftOut() {
    ToolFrame frame = frame();
    FrameMeter meter = new FrameMeter(deadline -> spin(WAIT_NANOS), 4);
    meter.measure(frame);
    for (int n = 0; n < 6; n++) {
      meter.awaitUntil(System.nanoTime());
      frame.run(n * 1_000_000L);
    }

    assertEquals(4, meter.from(0).work().length, "there is room for so many");
    double afterOne = (WAIT_NANOS + FRAME_NANOS) * 1.5e-9;
    int left = meter.from(afterOne).work().length;
    assertTrue(left == 2 || left == 3, left + " frames");
    assertEquals(0, meter.from(1e6).work().length);
  }

  /** Keeps the processor busy for some time of this thread. */
  private static void spin(long nanos) {
    long end = THREADS.getCurrentThreadCpuTime() + nanos;
    while (THREADS.getCurrentThreadCpuTime() < end) {
      Thread.onSpinWait();
    }
  }

  /** Returns a frame whose device keeps the processor busy, far from the one solid voxel. */
  private static ToolFrame frame() {
    VoxelGrid grid = VoxelGrid.ofUnitVoxels(32, 32, 32);
    BitCube bits = new BitCube(32, 32, 32);
    bits.set(2, 2, 2);
    BodyScene bodies = new BodyScene(List.of(new Body("voxel", bits, grid, Mobility.FIXED)));
    RigidTool point = ToolSampler.point();
    HapticDevice hand = new BusyHand(new HandStop(Pose.at(16, 16, 16), 0, 0, true));
    return new ToolFrame(
        hand,
        bodies,
        new RigidSolver(bodies, point, RigidSettings.of(8, Clearance.POINTS)),
        RigidCoupling.of(point, 0.5),
        FrameSettings.live(hand.specification(), ForceSettings.of(0.5, 0)),
        EditQueue.ofBodies(bodies.grids()),
        ToolFramePublisher.NONE);
  }

  /** A hand that stays and keeps the processor busy at each reading. */
  private static final class BusyHand extends DeviceDecorator {
    BusyHand(HandStop place) {
      super(new GuidedHand(List.of(place), Tremor.NONE, 100, 1_000_000));
    }

    @Override
    public ReadStatus read(DeviceState state) {
      spin(FRAME_NANOS);
      return super.read(state);
    }
  }
}
