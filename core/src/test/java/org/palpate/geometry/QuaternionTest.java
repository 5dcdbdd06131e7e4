package org.palpate.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;

class QuaternionTest {
  private static final double TOLERANCE = 1e-12;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());

  @Test
  void rotatesLikeTheMatrixOfTheSameAxisAndAngle() {
    for (int n = 0; n < 1000; n++) {
      Vec3 rotation = RandomGeometry.vector(random, 3.2);
      Quaternion q = new Quaternion().setRotationVector(rotation);
      Vec3 v = RandomGeometry.vector(random, 5);
      Vec3 expected = rodrigues(rotation, v);
      assertNear(expected, q.rotate(v, new Vec3()));
      assertNear(v, q.inverseRotate(expected, new Vec3()));
      assertEquals(1, q.norm(), TOLERANCE);
    }
  }

  @Test
  void theAxesOfARotationGiveItBack() {
    for (int n = 0; n < 1000; n++) {
      Quaternion q = randomRotation();
      if (n < 8) { // half turns and others for which some sums vanish
        q.set(n == 0 ? 1 : 0, n & 1, n & 2, n & 4);
        q.normalize();
      }
      Vec3 x = q.rotate(new Vec3(1, 0, 0), new Vec3());
      Vec3 y = q.rotate(new Vec3(0, 1, 0), new Vec3());
      Vec3 z = q.rotate(new Vec3(0, 0, 1), new Vec3());
      Quaternion back = new Quaternion().setAxes(x, y, z);
      assertEquals(1, Math.abs(back.dot(q)), TOLERANCE, () -> Seeds.seed() + " " + q);
      assertEquals(1, back.norm(), TOLERANCE);
    }
  }

  @Test
  void multipliesLikeRotationsOneAfterTheOther() {
    for (int n = 0; n < 1000; n++) {
      Quaternion a = randomRotation();
      Quaternion b = randomRotation();
      Vec3 v = RandomGeometry.vector(random, 5);
      Vec3 expected = a.rotate(b.rotate(v, new Vec3()), new Vec3());
      assertNear(expected, a.multiply(b, new Quaternion()).rotate(v, new Vec3()));
      Quaternion inPlace = new Quaternion().set(a);
      inPlace.multiply(b, inPlace);
      assertTrue(inPlace.sameBits(a.multiply(b, new Quaternion())));
    }
  }

  @Test
  void normalizingTwiceChangesNoBit() {
    for (int n = 0; n < 100_000; n++) {
      Quaternion q =
          new Quaternion(
              random.nextDouble(-1, 1),
              random.nextDouble(-1, 1),
              random.nextDouble(-1, 1),
              random.nextDouble(-1, 1));
      assertTrue(q.normalize());
      Quaternion again = new Quaternion().set(q);
      assertTrue(again.normalize());
      assertTrue(again.sameBits(q), () -> Seeds.seed() + " " + q);
    }
  }

  @Test
  void obeysHamiltonsRules() {
    Quaternion i = new Quaternion(0, 1, 0, 0);
    Quaternion j = new Quaternion(0, 0, 1, 0);
    Quaternion k = new Quaternion(0, 0, 0, 1);
    assertTrue(k.sameBits(i.multiply(j, new Quaternion())));
    assertEquals(-1, i.multiply(j, new Quaternion()).multiply(k, new Quaternion()).w);
  }

  @Test
  void theLogarithmUndoesTheExponentialTheShortWayAround() {
    for (int n = 0; n < 1000; n++) {
      Vec3 rotation = RandomGeometry.vector(random, 1.8); // at most 3.12 rad
      Quaternion q = new Quaternion().setRotationVector(rotation);
      if (n % 2 == 0) {
        q.negate(q);
      }
      assertNear(rotation, q.rotationVector(new Vec3()));
      assertEquals(rotation.length(), q.angle(), 1e-11);
    }
  }

  @Test
  void tinyRotationsKeepTheirRelativePrecision() {
    Vec3 rotation = new Vec3(1e-13, -3e-14, 2e-160);
    Quaternion q = new Quaternion().setRotationVector(rotation);
    Vec3 back = q.rotationVector(new Vec3());
    assertEquals(1e-13, back.x, 1e-27);
    assertEquals(-3e-14, back.y, 1e-27);
  }

  @Test
  void normalizesOnlyWhatHasADirection() {
    Quaternion q = new Quaternion(3, 0, 4, 0);
    assertTrue(q.normalize());
    assertEquals(0.6, q.w, TOLERANCE);
    assertFalse(new Quaternion(0, 0, 0, 0).normalize());
    assertFalse(new Quaternion(Double.NaN, 0, 0, 1).normalize());
    assertFalse(new Quaternion(Double.POSITIVE_INFINITY, 0, 0, 1).normalize());
    assertFalse(new Quaternion(1e200, 0, 0, 0).normalize());
  }

  @Test
  void comparesAndChecksEveryComponent() {
    Quaternion q = new Quaternion(0.5, -0.5, 0.5, 0.5);
    assertTrue(q.isFinite() && q.isUnit() && q.isNearUnit());
    for (int n = 0; n < 4; n++) {
      for (double wrong : new double[] {Double.NaN, 0.501, 0.6}) {
        Quaternion other = withComponent(q, n, wrong);
        assertFalse(other.sameBits(q));
        assertEquals(!Double.isNaN(wrong), other.isFinite());
        assertFalse(other.isUnit());
        assertEquals(wrong == 0.501, other.isNearUnit());
      }
    }
    Quaternion negative = new Quaternion();
    assertSame(negative, q.negate(negative));
    assertTrue(negative.sameBits(new Quaternion(-0.5, 0.5, -0.5, -0.5)));
    assertTrue(negative.setIdentity().sameBits(new Quaternion(1, 0, 0, 0)));
  }

  private static Quaternion withComponent(Quaternion q, int n, double value) {
    return new Quaternion(
        n == 0 ? value : q.w, n == 1 ? value : q.x, n == 2 ? value : q.y, n == 3 ? value : q.z);
  }

  private Quaternion randomRotation() {
    return new Quaternion().setRotationVector(RandomGeometry.vector(random, 3));
  }

  /** Rotates by Rodrigues' formula, written without a quaternion. */
  static Vec3 rodrigues(Vec3 rotation, Vec3 v) {
    double angle = rotation.length();
    Vec3 u = rotation.mul(1 / angle, new Vec3());
    double along = u.dot(v) * (1 - Math.cos(angle));
    return new Vec3(
        v.x * Math.cos(angle) + (u.y * v.z - u.z * v.y) * Math.sin(angle) + u.x * along,
        v.y * Math.cos(angle) + (u.z * v.x - u.x * v.z) * Math.sin(angle) + u.y * along,
        v.z * Math.cos(angle) + (u.x * v.y - u.y * v.x) * Math.sin(angle) + u.z * along);
  }

  static void assertNear(Vec3 expected, Vec3 actual) {
    double off = expected.sub(actual, new Vec3()).length();
    assertTrue(off <= 1e-11 * (1 + expected.length()), expected + " but " + actual);
  }
}
