package org.palpate.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.palpate.testing.ScriptedDevice.fresh;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.device.ReadStatus;
import org.palpate.force.guide.NearestApproach;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.loop.ManualClock;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.testing.Floor;
import org.palpate.testing.ScriptedDevice;

/** The records that an observer of a frame receives. The voxels of the floor are 4 x 2 x 3 mm. */
class FrameObserverTest {
  private static final GridMetric METRIC = new GridMetric(4, 2, 3);

  /** A copy of what the tests read. */
  private record Seen(
      long timeNanos,
      Vec3 deviceMm,
      Vec3 toolMm,
      Vec3 forceNewton,
      boolean contact,
      int contacts,
      boolean freed,
      boolean relocated) {
    static Seen of(FrameRecord record) {
      return new Seen(
          record.timeNanos,
          new Vec3().set(record.deviceMm),
          new Vec3().set(record.tool.translation),
          new Vec3().set(record.forceNewton),
          record.contact,
          record.contacts(),
          record.freed,
          record.relocated);
    }
  }

  private final Floor floor = Floor.make();
  private final List<Seen> seen = new ArrayList<>();
  private final ScriptedDevice device = ScriptedDevice.at(16, 17, 12);
  private final PointFrame frame =
      new PointFrame(
          GridDevice.inGridCoordinates(device),
          new GuardedSolver(METRIC, 100),
          floor.scene,
          METRIC,
          Floor.settings(),
          floor.edits,
          FramePublisher.NONE);
  private long nowNanos = 1;

  @Test
  void positionsAreMillimetresAlongTheAxesOfTheGrid() {
    frame.observe(record -> seen.add(Seen.of(record)));
    run(1);
    assertTrue(last().deviceMm.sameBits(new Vec3(64, 34, 36)));
    assertTrue(last().toolMm.sameBits(new Vec3(64, 34, 36)));
    assertEquals(0, last().timeNanos);
    assertFalse(last().contact);
    assertEquals(0, last().contacts);
  }

  @Test
  void aContactNamesTheObjectThatStopsThePoint() {
    frame.observe(
        record -> {
          seen.add(Seen.of(record));
          for (int n = 0; n < record.contacts(); n++) {
            assertEquals(0, record.object(n));
            assertEquals(1, record.share(n));
          }
        });
    press();
    assertTrue(last().contact);
    assertEquals(1, last().contacts);
    assertTrue(last().deviceMm.sameBits(new Vec3(64, 34, 15)));
    assertEquals(Floor.TOP * 3, last().toolMm.z, 1e-5);
    assertTrue(last().forceNewton.sameBits(device.lastForce()));
  }

  @Test
  void aFrameThatFollowsNoSampleIsNotSeen() {
    frame.observe(record -> seen.add(Seen.of(record)));
    run(3);
    device.script = (read, state) -> ReadStatus.REPEATED;
    run(2);
    assertEquals(3, seen.size());
    assertEquals(2 * ManualClock.MS, last().timeNanos);
  }

  @Test
  void aJumpOfTheDeviceIsNoPath() {
    frame.observe(record -> seen.add(Seen.of(record)));
    run(1);
    assertFalse(last().relocated || last().freed);
    device.script =
        (read, state) -> {
          state.relocated = read == 1;
          return fresh(state, read, 16, 17, 20);
        };
    run(1);
    assertTrue(last().relocated && last().freed);
    run(1);
    assertFalse(last().relocated || last().freed);
  }

  @Test
  void aPointThatNoSampleHasPlacedComesNearNothing() {
    NearestApproach nearest = new NearestApproach("floor", 1, floor.bits, Floor.GRID, 5);
    frame.watch(List.of(nearest));
    ScriptedDevice.Script above = device.script;
    device.script = (read, state) -> ReadStatus.REPEATED;
    run(1);
    assertTrue(nearest.nearestMm().isEmpty());
    device.script = above;
    run(1);
    assertEquals(1, nearest.frame());
    assertEquals(12 - Floor.TOP, nearest.nearestMm().orElseThrow());
  }

  private void press() {
    run(1);
    device.script = (read, state) -> fresh(state, read, 16, 17, 5);
    run(3);
    assertTrue(frame.point().contact);
  }

  private Seen last() {
    return seen.get(seen.size() - 1);
  }

  private void run(int frames) {
    for (int n = 0; n < frames; n++) {
      assertEquals(FrameOutcome.RUNNING, frame.run(nowNanos));
      nowNanos += ManualClock.MS;
    }
  }
}
