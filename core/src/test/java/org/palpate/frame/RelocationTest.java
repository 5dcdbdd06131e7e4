package org.palpate.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.palpate.testing.ScriptedDevice.fresh;

import org.junit.jupiter.api.Test;
import org.palpate.device.ReadStatus;
import org.palpate.geometry.Vec3;
import org.palpate.loop.ManualClock;
import org.palpate.testing.Floor;
import org.palpate.testing.LegJudge;
import org.palpate.testing.ScriptedDevice;

/** A device that jumps without a motion, as a mouse does. */
class RelocationTest {
  private final Floor floor = Floor.make();
  private final ScriptedDevice device = ScriptedDevice.at(16, 16, 5);
  private final PointFrame frame = floor.frame(device);
  private long nowNanos = 1;
  private int reads;

  @Test
  void setsThePointFreeAtTheDeviceWithoutALegThroughTheFloor() {
    pressFromAbove();
    jumpTo(16, 16, -3);
    assertTrue(frame.wasFreed());
    assertTrue(frame.point().position.sameBits(new Vec3(16, 16, -3)));
    assertEquals(0, frame.point().legs.count());
    assertEquals(1, frame.statistics().freed());
  }

  @Test
  void theChainOfLegsBeginsAnewOnTheOtherSideAndTouchesNothing() {
    pressFromAbove();
    jumpTo(16, 16, -3);
    LegJudge judge = new LegJudge(floor.bits, new Vec3(16, 16, -3));
    assertNull(judge.faultOf(frame.point()));
    for (int n = 0; n < 100; n++) {
      moveTo(16 + 0.01 * n, 16, -3 + 0.1 * n);
      assertNull(judge.faultOf(frame.point()));
    }
    assertTrue(judge.legCount() > 20);
    assertTrue(frame.point().contact);
    assertEquals(0, frame.point().position.z, 1e-5, "the floor's lower face stops the point");
    assertTrue(device.lastForce().z < 0, "the force points away from the lower face");
  }

  @Test
  void theForceRisesFromZeroAfterTheJump() {
    pressFromAbove();
    double pressed = device.lastForce().z;
    jumpTo(16, 16, 9);
    assertEquals(0, device.lastForce().length());
    moveTo(16, 16, 5);
    assertTrue(device.lastForce().z < 0.1 * pressed, "the ramp has just begun");
    for (int n = 0; n < 100; n++) {
      moveTo(16, 16, 5);
    }
    assertEquals(pressed, device.lastForce().z, 1e-9);
  }

  @Test
  void aJumpIntoTheFloorSetsThePointFreeAtTheNearestEmptyVoxel() {
    pressFromAbove();
    jumpTo(3.4, 3.4, 6.2);
    assertTrue(frame.wasFreed());
    assertTrue(frame.point().legs.count() == 0 || frame.point().contact);
    assertFalse(floor.scene.touches(3.5, 3.5, frame.point().position.z));
  }

  @Test
  void aMotionOfTheSameLengthThatIsNoJumpStaysAboveTheFloor() {
    pressFromAbove();
    moveTo(16, 16, -3);
    assertFalse(frame.wasFreed());
    assertEquals(Floor.TOP, frame.point().position.z, 1e-5);
  }

  @Test
  void theFirstSampleMayBeAJump() {
    jumpTo(16, 16, 12);
    assertTrue(frame.point().position.sameBits(new Vec3(16, 16, 12)));
    moveTo(16, 16, 11);
    assertFalse(frame.wasFreed());
  }

  private void pressFromAbove() {
    for (int n = 0; n <= 120; n++) {
      moveTo(16, 16, 20 - 0.125 * n);
    }
    assertTrue(frame.point().contact);
  }

  private void moveTo(double x, double y, double z) {
    run(x, y, z, false);
  }

  private void jumpTo(double x, double y, double z) {
    run(x, y, z, true);
  }

  private void run(double x, double y, double z, boolean relocated) {
    device.script =
        (read, state) -> {
          ReadStatus status = fresh(state, reads, x, y, z);
          if (relocated) {
            state.relocated = true;
          }
          return status;
        };
    reads++;
    nowNanos += ManualClock.MS;
    frame.run(nowNanos);
  }
}
