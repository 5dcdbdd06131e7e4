package org.palpate.device;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.testing.ScriptedDevice;

class TurnedDeviceTest {
  private static final double QUARTER = Math.PI / 2;

  /** The turn in a millisecond. */
  private static final double STEP = TurnedDevice.RADIANS_PER_SECOND / 1000;

  private boolean held = true;
  private boolean fresh = true;
  private final Quaternion own = new Quaternion();
  private final TurnedDevice device =
      new TurnedDevice(new ScriptedDevice(this::sample), () -> held);
  private final DeviceState state = new DeviceState();

  private ReadStatus sample(int read, DeviceState dest) {
    dest.orientation.set(own);
    ReadStatus status = ScriptedDevice.fresh(dest, read, 1, 2, 3);
    return fresh ? status : ReadStatus.REPEATED;
  }

  /** Reads for some milliseconds; no read turns by more than a step. */
  private void read(int milliseconds) {
    Quaternion before = new Quaternion();
    for (int n = 0; n < milliseconds; n++) {
      before.set(state.orientation);
      device.read(state);
      Quaternion turned = state.orientation.multiply(before.conjugate(before), before);
      assertTrue(turned.angle() <= STEP * (1 + 1e-9), "turned by " + turned.angle());
      assertTrue(state.orientation.isUnit());
    }
  }

  private void assertTurned(Vec3 rotationVector, double tolerance) {
    Vec3 turned = state.orientation.rotationVector(new Vec3());
    assertEquals(0, turned.sub(rotationVector, turned).length(), tolerance);
  }

  @Test
  void aGoalIsApproachedAtABoundedRateAndReached() {
    read(2);
    device.turn(new Vec3(0, QUARTER, 0));
    read(500);
    assertTurned(new Vec3(0, QUARTER / 2, 0), 1e-9);
    read(501);
    assertTurned(new Vec3(0, QUARTER, 0), 1e-12);
    read(100);
    assertTurned(new Vec3(0, QUARTER, 0), 1e-12);
  }

  @Test
  void laterTurnsAreAboutTheAxesOfTheWorld() {
    read(1);
    device.turn(new Vec3(0, QUARTER, 0));
    device.turn(new Vec3(0.3, 0, 0));
    read(1300);
    device.turn(new Vec3(0, 0, 0.2));
    read(300);
    Vec3 x = state.orientation.rotate(new Vec3(1, 0, 0), new Vec3());
    Quaternion last = new Quaternion().setRotationVector(new Vec3(0, 0, 0.2));
    Vec3 expected = last.rotate(new Vec3(0, Math.sin(0.3), -Math.cos(0.3)), new Vec3());
    assertEquals(0, x.sub(expected, x).length(), 1e-9);
  }

  @Test
  void theOrientationThatTheDeviceGivesIsTurnedAndKeptToTheBitBefore() {
    own.setRotationVector(new Vec3(0.4, 0.1, 0));
    device.read(state);
    assertTrue(state.orientation.sameBits(own));
    device.turn(new Vec3(0, 0, 0.1));
    read(200);
    Quaternion turn = new Quaternion().setRotationVector(new Vec3(0, 0, 0.1));
    Quaternion expected = turn.multiply(own, new Quaternion());
    assertEquals(1, Math.abs(expected.dot(state.orientation)), 1e-12);
  }

  @Test
  void whileNothingIsHeldRequestsAndTheRestOfATurnAreDropped() {
    held = false;
    device.turn(new Vec3(1, 0, 0));
    read(100);
    held = true;
    read(100);
    assertTurned(new Vec3(), 0);
    device.turn(new Vec3(1, 0, 0));
    read(100);
    held = false;
    read(100);
    held = true;
    read(100);
    assertTurned(new Vec3(100 * STEP, 0, 0), 1e-9);
  }

  @Test
  void aGoalIsNeverSoFarAheadThatTheShortestWayIsAnother() {
    read(1);
    for (int n = 0; n < 100; n++) {
      device.turn(new Vec3(0, 0, 0.1));
      read(1);
    }
    read(2000);
    double angle = state.orientation.angle();
    double most = TurnedDevice.LARGEST_LEAD + 100 * STEP;
    assertTrue(angle > most - 0.1 && angle < most, "turned by " + angle);
  }

  @Test
  void aTurnThatWouldLeadAroundTheOtherWayIsDropped() {
    read(1);
    device.turn(new Vec3(0, 0, 1.9));
    read(1);
    device.turn(new Vec3(0, 0, 3)); // together, 4.9 rad look like -1.38
    read(2000);
    assertTurned(new Vec3(0, 0, 1.9), 1e-9);
  }

  @Test
  void ofManyTurnsBeforeASampleTheFirstOnesCount() {
    read(1);
    for (int n = 0; n < 50; n++) {
      device.turn(new Vec3(0.11, 0, 0));
    }
    read(2000);
    double turned = state.orientation.rotationVector(new Vec3()).x;
    assertTrue(turned > TurnedDevice.LARGEST_LEAD - 0.15, "turned by " + turned);
    assertTrue(turned < TurnedDevice.LARGEST_LEAD, "turned by " + turned);
  }

  @Test
  void withoutANewSampleNothingTurns() {
    read(1);
    device.turn(new Vec3(0, 0, 1));
    fresh = false;
    read(100);
    assertTurned(new Vec3(), 0);
    fresh = true;
    device.read(state);
    assertTurned(new Vec3(0, 0, 20 * STEP), 1e-9);
    assertEquals(2, state.positionMm.y);
  }
}
