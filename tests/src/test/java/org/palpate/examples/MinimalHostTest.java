package org.palpate.examples;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.DeviceState;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.geometry.Vec3;
import org.palpate.loop.LoopReport;

/** Runs the port to volume platforms under a second host, besides ImageJ. */
class MinimalHostTest {
  private static final int EDGE = 16;
  private static final int BONE = 7;
  private static final Vec3 SPACING_MM = new Vec3(0.5, 0.5, 1);

  /** A device that moves evenly from one position to another and rests there. */
  private static final class MovingDevice implements HapticDevice {
    private static final int STEPS = 500;

    private final Vec3 from;
    private final Vec3 to;
    private final Vec3 lastForce = new Vec3(1, 1, 1);
    private int reads;
    private boolean closed;

    private MovingDevice(Vec3 from, Vec3 to) {
      this.from = from;
      this.to = to;
    }

    @Override
    public DeviceSpecification specification() {
      return new DeviceSpecification("moving", "", 10, 2, 20, 0);
    }

    @Override
    public synchronized ReadStatus read(DeviceState state) {
      double fraction = Math.min(1, reads / (double) STEPS);
      state.positionMm.set(
          from.x + (to.x - from.x) * fraction,
          from.y + (to.y - from.y) * fraction,
          from.z + (to.z - from.z) * fraction);
      state.timeNanos = reads++ * 1_000_000L;
      return ReadStatus.FRESH;
    }

    @Override
    public synchronized boolean write(Vec3 forceNewton, Vec3 torqueNewtonMm) {
      lastForce.set(forceNewton);
      return true;
    }

    @Override
    public synchronized void close() {
      closed = true;
    }
  }

  @Test
  void thePointStopsAtASolidOfThePlatformAndTheEndSendsZeroForce() {
    MovingDevice device = new MovingDevice(new Vec3(4, 4, 1), new Vec3(4, 4, 12));
    LoopReport report;
    try (MinimalHost host = new MinimalHost(floor(), BONE, EDGE, SPACING_MM, device)) {
      host.start();
      while (host.tick() && host.frames() < 2 * MovingDevice.STEPS) {
        Thread.onSpinWait();
      }
      host.tick();
      assertTrue(host.pointWorldMm().z < 8, "above the floor at 8 mm: " + host.pointWorldMm());
      double reach = SPACING_MM.length() / 2 * 1.15; // The isosurface runs at most so far outside.
      assertTrue(host.pointWorldMm().z > 8 - reach, "and on it: " + host.pointWorldMm());
      report = host.end();
    }
    assertTrue(report.statistics().contactFrames() > 0);
    assertTrue(
        report.statistics().maxForceNewton() > 1, "N: " + report.statistics().maxForceNewton());
    assertEquals("(0.0, 0.0, 0.0)", device.lastForce.toString());
    assertTrue(device.closed);
  }

  @Test
  void aVoxelThatThePlatformPaintsSetsThePointFree() {
    Vec3 positionMm = new Vec3(4.25, 4.25, 2.5);
    try (MinimalHost host =
        new MinimalHost(
            floor(), BONE, EDGE, SPACING_MM, new MovingDevice(positionMm, positionMm))) {
      host.start();
      while (host.tick() && host.frames() < 10) {
        Thread.onSpinWait();
      }
      assertTrue(host.paint(8, 8, 2, true));
      while (host.tick() && !host.isPainted()) {
        Thread.onSpinWait();
      }
      assertEquals(1, host.end().statistics().freed());
    }
  }

  /** Returns labels that are solid in the upper half. */
  private static byte[] floor() {
    byte[] labels = new byte[EDGE * EDGE * EDGE];
    for (int n = labels.length / 2; n < labels.length; n++) {
      labels[n] = BONE;
    }
    return labels;
  }
}
