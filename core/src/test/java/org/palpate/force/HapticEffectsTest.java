package org.palpate.force;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;

class HapticEffectsTest {
  private static final long MS = 1_000_000;

  private final HapticEffects effects = new HapticEffects();
  private final HandState hand = new HandState();
  private final Vec3 force = new Vec3();
  private final Vec3 torque = new Vec3();

  private static HapticEffect push(double x) {
    return (hand, force, torque) -> {
      force.x += x;
      torque.z += x;
    };
  }

  /** Returns the force of a frame on top of a contact force of 1 N along y. */
  private double frame() {
    force.set(0, 1, 0);
    torque.set(0, 0, 0);
    effects.add(hand, MS, force, torque);
    assertEquals(1, force.y);
    assertEquals(force.x, torque.z);
    return force.x;
  }

  @Test
  void areInactiveWithoutEffects() {
    assertFalse(effects.areActive());
    effects.use(List.of());
    assertFalse(effects.areActive());
  }

  @Test
  void anEffectRisesFromZeroWithinTheRamp() {
    effects.use(List.of(push(2)));
    assertTrue(effects.areActive());
    double last = 0;
    for (int n = 1; n <= 200; n++) {
      double now = frame();
      assertEquals(2 * n / 200.0, now, 1e-12);
      assertTrue(now - last <= 2 / 200.0 + 1e-12);
      last = now;
    }
    assertEquals(2, frame());
  }

  @Test
  void effectsAddUp() {
    effects.use(List.of(push(2), push(-0.5)));
    for (int n = 0; n < 200; n++) {
      frame();
    }
    assertEquals(1.5, frame());
  }

  @Test
  void otherEffectsTakeOverWithoutAStep() {
    effects.use(List.of(push(2)));
    for (int n = 0; n < 200; n++) {
      frame();
    }
    effects.use(List.of(push(-1)));
    double last = 2;
    for (int n = 0; n < 200; n++) {
      double now = frame();
      assertTrue(Math.abs(now - last) <= 3 / 200.0 + 1e-12, "step from " + last + " to " + now);
      last = now;
    }
    assertEquals(-1, last, 1e-12);
    effects.use(List.of());
    for (int n = 0; n < 200; n++) {
      assertTrue(effects.areActive());
      double now = frame();
      assertTrue(Math.abs(now - last) <= 1 / 200.0 + 1e-12);
      last = now;
    }
    assertEquals(0, last);
    assertFalse(effects.areActive());
  }

  @Test
  void aDroppedForceReturnsFromZero() {
    effects.use(List.of(push(2)));
    for (int n = 0; n < 200; n++) {
      frame();
    }
    effects.drop();
    effects.beginAnew();
    assertEquals(2 / 200.0, frame(), 1e-12);
  }

  @Test
  void aForceThatIsNotFiniteCountsAsZero() {
    effects.use(List.of(push(Double.NaN)));
    for (int n = 0; n < 300; n++) {
      assertEquals(0, frame());
    }
    effects.use(List.of(push(Double.POSITIVE_INFINITY)));
    assertEquals(0, frame());
  }

  @Test
  void effectsForgetBeforeTheirFirstFrame() {
    int[] resets = {0};
    HapticEffect counting =
        new HapticEffect() {
          @Override
          public void add(HandState state, Vec3 forceNewton, Vec3 torqueNewtonMm) {
            assertEquals(1, resets[0]);
          }

          @Override
          public void reset() {
            resets[0]++;
          }
        };
    effects.use(List.of(counting));
    frame();
    effects.beginAnew();
    assertEquals(2, resets[0]);
  }

  @Test
  void theSpeedOfTheHandIsThatOfASteadyMotion() {
    for (int n = 0; n < 100; n++) {
      hand.device.translation.set(0.05 * n, 0, -0.1 * n);
      hand.device.rotation.setRotationVector(new Vec3(0, 0.001 * n, 0));
      hand.advance(MS);
    }
    assertEquals(50, hand.velocityMmPerSecond.x, 1e-6);
    assertEquals(-100, hand.velocityMmPerSecond.z, 1e-6);
    assertEquals(1, hand.spinRadPerSecond.y, 1e-6);
    assertEquals(0.001, hand.seconds);
    hand.forget();
    hand.device.translation.set(1e6, 0, 0);
    hand.advance(MS);
    assertEquals(0, hand.velocityMmPerSecond.length());
  }
}
