package org.palpate.force.guide;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.force.EffectPlan;
import org.palpate.force.EffectSite;
import org.palpate.force.HandState;
import org.palpate.force.HapticEffect;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;

class GuidesTest {
  private static final long SEED = Seeds.seed();
  private static final double STIFFNESS = 0.25;
  private static final double RADIUS = 4;
  private static final GuideStrength STRONG =
      new GuideStrength(
          OptionalDouble.of(STIFFNESS), OptionalDouble.of(1000), Double.POSITIVE_INFINITY);
  private static final EffectSite WORLD =
      new EffectSite(
          RigidTransform.identity(),
          0.5,
          0.5 * RADIUS * RADIUS,
          Double.POSITIVE_INFINITY,
          List.of(new Vec3()));

  private final SplittableRandom random = new SplittableRandom(SEED);
  private final HandState hand = new HandState();
  private final Vec3 force = new Vec3();
  private final Vec3 torque = new Vec3();

  private Vec3 feel(HapticEffect guide, double x, double y, double z) {
    hand.device.translation.set(x, y, z);
    return feel(guide);
  }

  private Vec3 feel(HapticEffect guide) {
    force.set(0, 0, 0);
    torque.set(0, 0, 0);
    guide.add(hand, force, torque);
    return force;
  }

  private Vec3 randomVector(double largest) {
    return RandomGeometry.vector(random, largest);
  }

  /** The hand crosses the middle between two limbs, and then rests. */
  @ParameterizedTest
  @ValueSource(doubles = {1000, 5000, 10_000})
  void aJumpOfTheNearestPositionArrivesInTheSameTimeAtEveryRate(double hertz) {
    List<Vec3> bent = List.of(new Vec3(0, 0, 0), new Vec3(50, 0, 0), new Vec3(50, 2, 0));
    List<Vec3> limbs = new ArrayList<>(bent);
    limbs.add(new Vec3(0, 2, 0));
    HapticEffect path = Guides.path(limbs, STRONG).make(WORLD);
    hand.seconds = 1 / hertz;
    assertEquals(-0.99 * STIFFNESS, feel(path, 10, 0.99, 0).y, 1e-12);
    int frames = 0;
    for (double y = 0; y < 0.98 * STIFFNESS; frames++) {
      y = feel(path, 10, 1.01, 0).y;
    }
    assertEquals(2 / PositionGuide.LEAST_STEP_MM, frames * 1000 / hertz, 3, "ms");
  }

  @Test
  void anAxisPullsAtRightAnglesToItself() {
    HapticEffect axis = Guides.axis(new Vec3(1, 2, 3), new Vec3(0, 0, 8), STRONG).make(WORLD);
    assertEquals("(-0.75, 1.0, 0.0)", feel(axis, 4, -2, 77).toString());
    assertEquals(0, feel(axis, 1, 2, -900).length());
  }

  @Test
  void aPlanePullsAlongItsNormal() {
    HapticEffect plane = Guides.plane(new Vec3(0, 0, 2), new Vec3(0, 0, -1), STRONG).make(WORLD);
    assertEquals("(0.0, 0.0, -1.0)", feel(plane, 40, -9, 6).toString());
    assertEquals("(0.0, 0.0, 0.5)", feel(plane, 40, -9, 0).toString());
  }

  @Test
  void aBallPullsBackFromOutsideAlone() {
    HapticEffect ball = Guides.ball(new Vec3(1, 0, 0), 5, STRONG).make(WORLD);
    assertEquals(0, feel(ball, 5.9, 0, 0).length());
    ball.reset();
    assertEquals("(-0.5, 0.0, 0.0)", feel(ball, 8, 0, 0).toString());
  }

  @Test
  void thePullIsBoundedAndEndsAtItsRange() {
    GuideSpring spring = new GuideSpring(0.5, 2, 20);
    assertEquals(1, spring.newton(2));
    assertEquals(2, spring.newton(9));
    assertEquals(1, spring.newton(15));
    assertEquals(0, spring.newton(20));
    assertEquals(0, spring.newton(1e9));
    double last = 0;
    for (int n = 0; n <= 3000; n++) {
      double now = spring.newton(0.01 * n);
      assertTrue(Math.abs(now - last) <= 0.5 * 0.01 + 1e-12);
      last = now;
    }
    assertThrows(IllegalArgumentException.class, () -> new GuideSpring(-1, 2, 3));
    assertThrows(IllegalArgumentException.class, () -> new GuideSpring(1, 2, Double.NaN));
  }

  @Test
  void thePullNeverExceedsTheForceOfTheDevice() {
    EffectSite weak = new EffectSite(RigidTransform.identity(), 0.5, 0, 0.7, List.of(new Vec3()));
    HapticEffect plane =
        Guides.plane(new Vec3(), new Vec3(0, 0, 1), GuideStrength.STANDARD).make(weak);
    assertEquals(0.7, feel(plane, 0, 0, 50).length());
  }

  @Test
  void thePathFindsTheNearestPositionOfAllItsPieces() {
    List<Vec3> positions = new ArrayList<>();
    for (int n = 0; n < 12; n++) {
      positions.add(randomVector(20));
    }
    positions.add(positions.get(11)); // a piece without length
    PathShape path = new PathShape(positions);
    Vec3 nearest = new Vec3();
    for (int n = 0; n < 200; n++) {
      Vec3 at = randomVector(30);
      path.nearest(at, nearest);
      double found = nearest.sub(at, new Vec3()).length();
      double sampled = leastOfSamples(positions, at);
      assertTrue(found <= sampled + 1e-9, "seed " + SEED);
      assertEquals(sampled, found, 1e-2, "seed " + SEED);
    }
  }

  private static double leastOfSamples(List<Vec3> positions, Vec3 at) {
    double least = Double.POSITIVE_INFINITY;
    for (int piece = 0; piece + 1 < positions.size(); piece++) {
      Vec3 from = positions.get(piece);
      Vec3 along = positions.get(piece + 1).sub(from, new Vec3());
      for (int n = 0; n <= 2000; n++) {
        Vec3 on = along.mul(n / 2000.0, new Vec3()).add(from, new Vec3());
        least = Math.min(least, on.sub(at, on).length());
      }
    }
    return least;
  }

  @Test
  void aPathNeedsTwoPositionsAndAtMostAThousand() {
    assertThrows(IllegalArgumentException.class, () -> new PathShape(List.of(new Vec3())));
    List<Vec3> many = new ArrayList<>();
    for (int n = 0; n <= PathShape.MOST_POSITIONS; n++) {
      many.add(new Vec3(n, 0, 0));
    }
    assertThrows(IllegalArgumentException.class, () -> new PathShape(many));
  }

  @Test
  void aHandThatPassesFromLimbToLimbOfABentPathFeelsNoStep() {
    List<Vec3> bent = List.of(new Vec3(-10, 10, 0), new Vec3(0, 0, 0), new Vec3(10, 10, 0));
    HapticEffect guide = Guides.path(bent, STRONG).make(WORLD);
    Vec3 last = new Vec3().set(feel(guide, -5, 9, 0));
    double stepMm = 0.1;
    for (int n = 1; n <= 100; n++) {
      Vec3 now = feel(guide, -5 + n * stepMm, 9, 0);
      double change = now.sub(last, new Vec3()).length();
      assertTrue(change <= STIFFNESS * 3 * stepMm + 1e-12, "frame " + n + " changed by " + change);
      last.set(now);
    }
    for (int n = 0; n < 2000; n++) {
      feel(guide); // The anchor arrives at the other limb even if the hand rests.
    }
    assertEquals(STIFFNESS * 2 * Math.sqrt(2), force.length(), 1e-9);
    assertTrue(force.x > 0);
  }

  @Test
  void guidesGiveBackNoMoreEnergyThanTheyTook() {
    GuideStrength ranged =
        new GuideStrength(OptionalDouble.of(STIFFNESS), OptionalDouble.of(1), 12);
    List<EffectPlan> plans =
        List.of(
            Guides.axis(randomVector(3), randomVector(1), ranged),
            Guides.plane(randomVector(3), randomVector(1), ranged),
            Guides.ball(randomVector(3), 2, ranged));
    for (EffectPlan plan : plans) {
      double moved = 0;
      for (int loop = 0; loop < 20; loop++) {
        double[] work = workOfClosedLoop(plan.make(WORLD));
        assertEquals(0, work[0], 1e-4, "seed " + SEED);
        moved += work[1];
      }
      assertTrue(moved > 10, "seed " + SEED + ": " + moved + " mJ went to and fro");
    }
  }

  /**
   * Returns the work that a guide does on a hand that moves around an ellipse, and the sum of its
   * amounts.
   */
  private double[] workOfClosedLoop(HapticEffect guide) {
    Vec3 centre = randomVector(8);
    Vec3 u = randomVector(6);
    Vec3 v = randomVector(6);
    int steps = 20_000;
    double[] work = new double[2];
    Vec3 last = new Vec3();
    Vec3 at = new Vec3();
    for (int n = 0; n <= steps; n++) {
      double angle = 2 * Math.PI * n / steps;
      at.set(centre);
      at.add(u.mul(Math.cos(angle), new Vec3()), at).add(v.mul(Math.sin(angle), new Vec3()), at);
      if (n > 0) {
        Vec3 middle = at.add(last, new Vec3()).mul(0.5, new Vec3());
        double done = feel(guide, middle.x, middle.y, middle.z).dot(at.sub(last, new Vec3()));
        work[0] += done;
        work[1] += Math.abs(done);
      }
      last.set(at);
    }
    return work;
  }

  @Test
  void aHingeLetsAPointMoveOnItsCircleAlone() {
    EffectSite point =
        new EffectSite(
            RigidTransform.identity(), 0.5, 0, Double.POSITIVE_INFINITY, List.of(new Vec3()));
    HapticEffect hinge = Guides.hinge(new Vec3(0, 0, 5), new Vec3(0, 0, 2), STRONG).make(point);
    assertEquals(0, feel(hinge, 3, 0, 1).length());
    for (int n = 0; n <= 100; n++) {
      double angle = 0.02 * n;
      feel(hinge, 3 * Math.cos(angle), 3 * Math.sin(angle), 1);
      assertEquals(0, force.length(), 1e-12);
    }
    feel(hinge, 5 * Math.cos(2), 5 * Math.sin(2), 2);
    assertEquals(-STIFFNESS, force.z, 1e-12);
    assertEquals(STIFFNESS * 2, Math.hypot(force.x, force.y), 1e-12);
    assertEquals(0, torque.length());
  }

  @Test
  void aHingeLetsAToolTurnAboutItsAxisAlone() {
    hand.isRigid = true;
    Vec3 through = randomVector(5);
    Vec3 axis = randomVector(1);
    axis.mul(1 / axis.length(), axis);
    HapticEffect hinge = Guides.hinge(through, axis, STRONG).make(WORLD);
    Pose first = new Pose();
    first.translation.set(randomVector(10));
    first.rotation.setRotationVector(randomVector(2));
    for (int n = 0; n <= 120; n++) {
      turn(first, through, axis, 0.02 * n, hand.device);
      feel(hinge);
      assertEquals(0, force.length(), 1e-9, "angle " + 0.02 * n);
      assertEquals(0, torque.length(), 1e-9, "angle " + 0.02 * n);
    }
    turn(first, through, axis, 2.4, hand.device);
    hand.device.translation.add(axis.mul(2, new Vec3()), hand.device.translation);
    feel(hinge);
    assertEquals(-2 * STIFFNESS, force.dot(axis), 1e-9);
    assertEquals(2 * STIFFNESS, force.length(), 1e-9);
    assertEquals(0, torque.length(), 1e-9);
  }

  private static void turn(Pose first, Vec3 through, Vec3 axis, double angle, Pose dest) {
    Quaternion rotation = new Quaternion().setRotationVector(axis.mul(angle, new Vec3()));
    rotation.rotate(first.translation.sub(through, new Vec3()), dest.translation);
    dest.translation.add(through, dest.translation);
    rotation.multiply(first.rotation, dest.rotation);
    dest.rotation.normalize();
  }

  @Test
  void aHingeTurnsBackAToolThatIsTwistedAboutAnotherAxis() {
    hand.isRigid = true;
    HapticEffect hinge = Guides.hinge(new Vec3(), new Vec3(0, 0, 1), STRONG).make(WORLD);
    hand.device.translation.set(3, 0, 0);
    feel(hinge);
    hand.device.rotation.setRotationVector(new Vec3(0.1, 0, 0));
    feel(hinge);
    assertEquals(0, force.length(), 1e-12);
    assertEquals(-STIFFNESS * RADIUS * RADIUS * 0.1, torque.x, 1e-9);
  }

  @Test
  void aHandThatCrossesTheHingeFeelsNoStep() {
    HapticEffect hinge = Guides.hinge(new Vec3(), new Vec3(0, 0, 1), STRONG).make(WORLD);
    Vec3 last = new Vec3().set(feel(hinge, 3, 0.001, 0));
    double stepMm = 0.05;
    for (int n = 1; n <= 100; n++) {
      Vec3 now = feel(hinge, 3 - n * stepMm, 0.001, 0);
      double change = now.sub(last, new Vec3()).length();
      assertTrue(change <= STIFFNESS * 3 * stepMm + 1e-9, "frame " + n + " changed by " + change);
      last.set(now);
    }
  }

  @Test
  void aToolIsTurnedAlongALineByTheShorterWay() {
    hand.isRigid = true;
    HapticEffect align = Guides.align(new Vec3(0, 0, 3), STRONG).make(WORLD);
    double stiffness = STIFFNESS * RADIUS * RADIUS;
    for (int degrees = 0; degrees <= 360; degrees += 15) {
      double angle = Math.toRadians(degrees);
      hand.device.rotation.setRotationVector(new Vec3(angle, 0, 0));
      feel(align);
      assertEquals(-stiffness * Math.sin(2 * angle) / 2, torque.x, 1e-9, degrees + " degrees");
      assertEquals(0, force.length());
    }
    hand.isRigid = false;
    assertEquals(0, feel(align).length());
    assertEquals(0, torque.length());
  }

  @Test
  void guidesArePlacedInTheWorldWhateverTheAxesOfTheFrame() {
    Quaternion q = new Quaternion().setRotationVector(new Vec3(0.3, -1, 0.5));
    RigidTransform frameToWorld =
        new RigidTransform(
            q.rotate(new Vec3(1, 0, 0), new Vec3()),
            q.rotate(new Vec3(0, 1, 0), new Vec3()),
            q.rotate(new Vec3(0, 0, -1), new Vec3()), // mirrored, as a file may be
            new Vec3(7, -3, 20));
    EffectSite turned =
        new EffectSite(frameToWorld, 0.5, 0, Double.POSITIVE_INFINITY, List.of(new Vec3()));
    EffectPlan[] plans = {
      Guides.axis(randomVector(9), randomVector(1), STRONG),
      Guides.plane(randomVector(9), randomVector(1), STRONG),
      Guides.path(List.of(randomVector(9), randomVector(9)), STRONG)
    };
    for (EffectPlan plan : plans) {
      Vec3 world = randomVector(15);
      Vec3 inWorld = new Vec3().set(feel(plan.make(WORLD), world.x, world.y, world.z));
      Vec3 in = frameToWorld.inverseTransform(world, new Vec3());
      Vec3 back = frameToWorld.rotate(feel(plan.make(turned), in.x, in.y, in.z), new Vec3());
      assertEquals(0, back.sub(inWorld, back).length(), 1e-12, "seed " + SEED);
    }
  }

  @Test
  void aDirectionWithoutLengthIsRefused() {
    assertThrows(IllegalArgumentException.class, () -> Guides.axis(new Vec3(), new Vec3(), STRONG));
  }
}
