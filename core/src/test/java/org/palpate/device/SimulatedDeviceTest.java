package org.palpate.device;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

class SimulatedDeviceTest {
  private static final long MS = 1_000_000;
  private static final int FRAMES = 60_000;

  private final DeviceState state = new DeviceState();

  @Test
  void theSameSeedGivesTheSameBits() {
    SimulatedDevice one = new SimulatedDevice(7, ball(), MS);
    SimulatedDevice two = new SimulatedDevice(7, ball(), MS);
    DeviceState other = new DeviceState();
    for (int frame = 0; frame < FRAMES; frame++) {
      one.read(state);
      two.read(other);
      assertTrue(state.positionMm.sameBits(other.positionMm), "frame=" + frame);
      assertEquals(frame * MS, state.timeNanos);
    }
  }

  @Test
  void forcesDoNotMoveTheHand() {
    SimulatedDevice pushed = new SimulatedDevice(7, ball(), MS);
    SimulatedDevice free = new SimulatedDevice(7, ball(), MS);
    DeviceState other = new DeviceState();
    for (int frame = 0; frame < 1000; frame++) {
      pushed.read(state);
      free.read(other);
      assertTrue(pushed.write(new Vec3(frame, -1, 2), new Vec3(0, frame, 0)));
      assertTrue(state.positionMm.sameBits(other.positionMm));
    }
  }

  @Test
  void aHandThatTurnsMovesAsOneThatDoesNot() {
    SimulatedDevice plain = new SimulatedDevice(7, ball(), MS);
    SimulatedDevice turning = SimulatedDevice.withOrientation(7, ball(), MS);
    assertFalse(plain.specification().hasOrientation());
    assertTrue(turning.specification().hasOrientation());
    DeviceState other = new DeviceState();
    Quaternion last = new Quaternion();
    double widest = 0;
    double fastest = 0;
    for (int frame = 0; frame < FRAMES; frame++) {
      plain.read(state);
      turning.read(other);
      assertTrue(state.positionMm.sameBits(other.positionMm), "frame=" + frame);
      assertTrue(state.orientation.sameBits(new Quaternion()));
      assertEquals(1, other.orientation.norm(), 1e-15);
      widest = Math.max(widest, other.orientation.angle());
      fastest = Math.max(fastest, last.conjugate(last).multiply(other.orientation, last).angle());
      last.set(other.orientation);
    }
    assertTrue(widest > 1 && widest < 1.7, "widest=" + widest);
    assertTrue(fastest > 0.05 && fastest < 0.7, "fastest=" + fastest);
  }

  @Test
  void anotherSeedGivesAnotherMotion() {
    new SimulatedDevice(1, ball(), MS).read(state);
    Vec3 first = new Vec3().set(state.positionMm);
    new SimulatedDevice(2, ball(), MS).read(state);
    assertFalse(first.sameBits(state.positionMm));
  }

  @Test
  void pressesAndLeavesAndTearsAtFiveToFiftyVoxelsASample() {
    HandTarget target = ball();
    SimulatedDevice device = new SimulatedDevice(3, target, MS);
    Vec3 last = new Vec3();
    int inside = 0;
    int fast = 0;
    double fastest = 0;
    for (int frame = 0; frame < FRAMES; frame++) {
      device.read(state);
      assertTrue(state.positionMm.isFinite());
      inside += state.positionMm.length() < 50 ? 1 : 0;
      double step = frame == 0 ? 0 : state.positionMm.sub(last, new Vec3()).length();
      fast += step > 5 ? 1 : 0;
      fastest = Math.max(fastest, step);
      last.set(state.positionMm);
    }
    assertTrue(inside > FRAMES / 5 && inside < FRAMES * 9 / 10, "inside=" + inside);
    assertTrue(fast > 50, "fast=" + fast);
    assertTrue(fastest > 20 && fastest < 100, "fastest=" + fastest);
  }

  @Test
  void entersATargetWithoutSurfacePoints() {
    HandTarget box = HandTarget.ofBox(new Vec3(-50, -50, -50), new Vec3(50, 50, 50), 1);
    SimulatedDevice device = new SimulatedDevice(3, box, MS);
    int inside = 0;
    for (int frame = 0; frame < FRAMES; frame++) {
      device.read(state);
      inside += state.positionMm.length() < 50 ? 1 : 0;
    }
    assertTrue(inside > FRAMES / 5, "inside=" + inside);
  }

  @Test
  void touchesATargetOfOneVoxel() {
    HandTarget one = HandTarget.ofBox(new Vec3(3, 3, 3), new Vec3(3, 3, 3), 0.25);
    SimulatedDevice device = new SimulatedDevice(3, one, MS / 8);
    for (int frame = 0; frame < FRAMES; frame++) {
      assertEquals(ReadStatus.FRESH, device.read(state));
      assertTrue(state.positionMm.isFinite());
    }
  }

  @Test
  void aClosedDeviceIsDisconnected() {
    SimulatedDevice device = new SimulatedDevice(3, ball(), MS);
    device.close();
    device.close();
    assertEquals(ReadStatus.DISCONNECTED, device.read(state));
    assertFalse(device.write(new Vec3(), new Vec3()));
  }

  @Test
  void aReplayDeliversEachSampleOnceAndThenDisconnects() {
    Trajectory trajectory = new Trajectory();
    for (int i = 0; i < 3000; i++) {
      trajectory.add(i * 0.5, i, Double.NaN, -i);
    }
    ReplayDevice device = new ReplayDevice("replay", trajectory);
    for (int pass = 0; pass < 2; pass++) {
      for (int i = 0; i < 3000; i++) {
        assertEquals(ReadStatus.FRESH, device.read(state));
        assertEquals(i, state.positionMm.x);
        assertTrue(Double.isNaN(state.positionMm.y));
        assertEquals(i * MS / 2, state.timeNanos);
      }
      assertEquals(ReadStatus.DISCONNECTED, device.read(state));
      device.rewind();
    }
  }

  @Test
  void targetsOutOfRangeAreRefused() {
    Vec3 zero = new Vec3();
    assertThrows(
        IllegalArgumentException.class, () -> HandTarget.ofBox(new Vec3(1, 0, 0), zero, 1));
    assertThrows(IllegalArgumentException.class, () -> HandTarget.ofBox(zero, zero, 0));
    assertThrows(IllegalArgumentException.class, () -> new SimulatedDevice(1, ball(), 0));
  }

  /** Returns a ball of radius 50 mm with points all over its surface. */
  private static HandTarget ball() {
    List<Vec3> points = new ArrayList<>();
    for (int i = 0; i < 500; i++) {
      double z = (i + 0.5) / 250 - 1;
      double around = i * 2.399963;
      double r = StrictMath.sqrt(1 - z * z);
      points.add(
          new Vec3(50 * r * StrictMath.cos(around), 50 * r * StrictMath.sin(around), 50 * z));
    }
    return new HandTarget(new Vec3(-50, -50, -50), new Vec3(50, 50, 50), 1, points);
  }
}
