package org.palpate.force.guide;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.force.EffectSite;
import org.palpate.force.HandState;
import org.palpate.force.HapticEffect;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/** Pulls a body in hand to a fit that determines some directions and not others. */
class FitGuideTest {
  private static final double STIFFNESS = 0.25;
  private static final double LEVER = 10;
  private static final double DEVICE_NEWTON = 1.5;
  private static final GuideStrength STRONG =
      new GuideStrength(
          OptionalDouble.of(STIFFNESS), OptionalDouble.of(1000), Double.POSITIVE_INFINITY);

  private static final double MOST_NEWTON_A_MS = STIFFNESS * PositionGuide.LEAST_STEP_MM;

  private final FitExchange exchange = new FitExchange();
  private final HapticEffect guide =
      Guides.fit(exchange, STRONG)
          .make(
              new EffectSite(
                  RigidTransform.identity(), 0.5, 0, DEVICE_NEWTON, List.of(new Vec3())));
  private final HandState hand = new HandState();
  private final Vec3 force = new Vec3();
  private final Vec3 torque = new Vec3();

  FitGuideTest() {
    hand.isRigid = true;
    hand.heldBody = 3;
  }

  private void feel(int frames) {
    for (int n = 0; n < frames; n++) {
      force.set(0, 0, 0);
      torque.set(0, 0, 0);
      guide.add(hand, force, torque);
    }
  }

  /** Returns a fit that determines the displacement along x in full and half of it along y. */
  private static FitTarget fitAt(int body, Vec3 position) {
    double[] pull = new double[36];
    pull[0] = 1;
    pull[7] = 0.5;
    pull[35] = 1;
    Pose pose = new Pose();
    pose.translation.set(position);
    pose.rotation.setRotationVector(new Vec3(0.1, 0, 0.2));
    return new FitTarget(body, pose, LEVER, pull);
  }

  @Test
  void pullsOnlyInTheDirectionsThatTheFitDetermines() {
    exchange.offer(fitAt(3, new Vec3(1, 1, 1)));
    feel(1000);
    assertEquals(STIFFNESS, force.x, 1e-9);
    assertEquals(STIFFNESS / 2, force.y, 1e-9);
    assertEquals(0, force.z, 1e-12);
    assertEquals(0, torque.x, 1e-12);
    assertEquals(0.2 * LEVER * LEVER * STIFFNESS, torque.z, 0.01);
  }

  @Test
  void doesNotPullAnotherBodyOrTheTool() {
    exchange.offer(fitAt(2, new Vec3(1, 1, 1)));
    feel(1000);
    assertEquals(0, force.length() + torque.length());
    hand.heldBody = -1;
    exchange.offer(fitAt(-1, new Vec3(1, 1, 1)));
    feel(1000);
    assertEquals(0, force.length() + torque.length());
  }

  @Test
  void aFitThatAppearsJumpsOrEndsMakesNoStepOfTheForce() {
    double mostNewton = MOST_NEWTON_A_MS + 1e-12;
    Vec3 last = new Vec3();
    double largest = 0;
    for (int n = 0; n < 2000; n++) {
      if (n % 400 == 100) {
        exchange.offer(fitAt(3, new Vec3(n % 3, 1 - n % 2, 0)));
      } else if (n % 400 == 0) {
        exchange.offer(null);
      }
      feel(1);
      double step = force.sub(last, new Vec3()).length();
      assertTrue(step <= mostNewton, "frame " + n + ": " + step + " N");
      largest = Math.max(largest, force.length());
      last.set(force);
    }
    assertTrue(largest > 0.2, "it pulled by " + largest + " N");
  }

  @ParameterizedTest
  @ValueSource(doubles = {1000, 5000, 10_000})
  void theForceGrowsAsFastAtEveryRate(double hertz) {
    hand.seconds = 1 / hertz;
    exchange.offer(fitAt(3, new Vec3(100, 0, 0)));
    feel(1);
    double pull = Math.hypot(force.length(), torque.length() / LEVER);
    assertEquals(MOST_NEWTON_A_MS, pull * hertz / 1000, 1e-12);
  }

  @Test
  void neverPullsHarderThanTheDevice() {
    exchange.offer(fitAt(3, new Vec3(100, 0, 0)));
    feel(10_000);
    double pull = Math.hypot(force.length(), torque.length() / LEVER);
    assertEquals(DEVICE_NEWTON, pull, 1e-9);
  }

  @Test
  void aMatrixOfAnotherSizeIsRefused() {
    assertThrows(
        IllegalArgumentException.class, () -> new FitTarget(0, new Pose(), 1, new double[35]));
  }
}
