package org.palpate.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.device.DeviceState;
import org.palpate.device.HandTarget;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

class MouseDeviceTest {
  private static final HandTarget REGION =
      new HandTarget(new Vec3(), new Vec3(10, 10, 10), 1, List.of());

  private final MouseDevice mouse = new MouseDevice(REGION, 1_000_000);
  private final DeviceState state = new DeviceState();

  @Test
  void turnsAboutTheAxesOfTheWorldOneTurnAfterTheOther() {
    mouse.turn(new Vec3(0, 0, Math.PI / 2));
    mouse.turn(new Vec3(Math.PI / 2, 0, 0));
    read(2000);
    Vec3 x = state.orientation.rotate(new Vec3(1, 0, 0), new Vec3());
    assertEquals(1, x.z, 1e-9, "x went to y by the first turn, and to z by the second");
    assertTrue(state.orientation.isUnit());
  }

  @Test
  void approachesAnOrientationByAFiftiethOfTheWayWithEachSample() {
    mouse.turn(new Vec3(0, 1, 0));
    read(1);
    assertEquals(0.02, state.orientation.angle(), 1e-12);
    read(1);
    assertEquals(0.02 + 0.02 * 0.98, state.orientation.angle(), 1e-12);
  }

  @ParameterizedTest
  @ValueSource(ints = {1000, 5000, 10_000})
  void isAsFastAtEveryRate(int hertz) {
    MouseDevice fast = new MouseDevice(REGION, 1_000_000_000 / hertz);
    fast.read(state);
    double from = state.positionMm.x;
    fast.moveTo(new Vec3(from + 10, state.positionMm.y, state.positionMm.z));
    for (int n = 0; n < hertz / 20; n++) {
      fast.read(state);
    }
    assertEquals(10 * (1 - Math.exp(-1)), state.positionMm.x - from, 0.05, "after 50 ms");
  }

  @Test
  void keepsItsOrientationWhenItMovesAndJumps() {
    mouse.turn(new Vec3(0, 1, 0));
    read(2000);
    Quaternion turned = new Quaternion().set(state.orientation);
    mouse.moveTo(new Vec3(1, 2, 3));
    mouse.jump(new Vec3(4, 5, 6), new Vec3(4, 5, 7));
    read(1);
    assertTrue(state.relocated);
    assertTrue(state.positionMm.sameBits(new Vec3(4, 5, 6)));
    assertTrue(state.orientation.sameBits(turned));
  }

  private void read(int samples) {
    for (int n = 0; n < samples; n++) {
      mouse.read(state);
    }
  }
}
