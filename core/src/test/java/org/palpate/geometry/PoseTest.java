package org.palpate.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.palpate.geometry.QuaternionTest.assertNear;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;

class PoseTest {
  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final Quaternion scratch = new Quaternion();

  @Test
  void mapsPointsLikeItsAffineMap() {
    for (int n = 0; n < 1000; n++) {
      Pose pose = RandomGeometry.pose(random, 50);
      Vec3 p = RandomGeometry.vector(random, 20);
      Vec3 image = pose.transform(p, new Vec3());
      assertNear(image, new AffineMap().set(pose).transform(p, new Vec3()));
      assertNear(image, pose.transform(RigidTransform.identity()).transform(p, new Vec3()));
      assertNear(p, pose.inverseTransform(image, new Vec3()));
      assertNear(p, new AffineMap().setInverse(pose).transform(image, new Vec3()));
    }
  }

  @Test
  void productsOfPosesAndOfMapsApplyTheRightOneFirst() {
    for (int n = 0; n < 1000; n++) {
      Pose a = RandomGeometry.pose(random, 50);
      Pose b = RandomGeometry.pose(random, 50);
      Vec3 p = RandomGeometry.vector(random, 20);
      Vec3 expected = a.transform(b.transform(p, new Vec3()), new Vec3());
      Pose ab = a.multiply(b, new Pose());
      assertNear(expected, ab.transform(p, new Vec3()));
      assertNear(
          b.transform(p, new Vec3()), a.inverseMultiply(ab, new Pose()).transform(p, new Vec3()));
      AffineMap product = new AffineMap().set(a).multiply(new AffineMap().set(b), new AffineMap());
      assertNear(expected, product.transform(p, new Vec3()));
      b.multiply(a, b);
      assertTrue(b.isFinite());
    }
  }

  @Test
  void aMapOfAGridKeepsItsAxesEvenIfTheyAreMirrored() {
    RigidTransform mirrored =
        new RigidTransform(
            new Vec3(0, 1, 0), new Vec3(-1, 0, 0), new Vec3(0, 0, -1), new Vec3(3, 4, 5));
    Vec3 p = new Vec3(1, 2, 3);
    assertNear(
        mirrored.transform(p, new Vec3()), new AffineMap().set(mirrored).transform(p, new Vec3()));
  }

  @Test
  void isFiniteAndTheSameOnlyIfBothPartsAre() {
    Pose pose = RandomGeometry.pose(random, 50);
    for (int part = 0; part < 2; part++) {
      Pose other = new Pose().set(pose);
      assertTrue(other.sameBits(pose) && other.isFinite());
      if (part == 0) {
        other.translation.x = Double.NaN;
      } else {
        other.rotation.x = Double.NaN;
      }
      assertFalse(other.sameBits(pose) || other.isFinite());
    }
    Pose ofAxes = new Pose().set(pose.transform(RigidTransform.identity()));
    assertNear(pose.translation, ofAxes.translation);
    assertEquals(1, Math.abs(ofAxes.rotation.dot(pose.rotation)), 1e-12);
    assertTrue(ofAxes.setIdentity().sameBits(new Pose()));
  }

  @Test
  void displacesByTheDifferenceToAnotherPose() {
    Vec3 displacement = new Vec3();
    Vec3 rotation = new Vec3();
    for (int n = 0; n < 1000; n++) {
      Pose a = RandomGeometry.pose(random, 50);
      Pose b = RandomGeometry.pose(random, 50);
      a.differenceTo(b, displacement, rotation, scratch);
      Pose reached = a.displace(displacement, rotation, 1, scratch, new Pose());
      assertNear(b.translation, reached.translation);
      assertEquals(1, Math.abs(b.rotation.dot(reached.rotation)), 1e-12);
    }
  }

  @Test
  void interpolatesStraightAndAtAConstantRate() {
    Pose.Scratch room = new Pose.Scratch();
    for (int n = 0; n < 300; n++) {
      Pose a = RandomGeometry.pose(random, 50);
      Pose b = RandomGeometry.pose(random, 50);
      double t = random.nextDouble();
      Pose between = a.interpolate(b, t, room, new Pose());
      assertEquals(t * distance(a, b), distance(a, between), 1e-10 * (1 + distance(a, b)));
      assertEquals(t * angle(a, b), angle(a, between), 1e-7);
      Pose inPlace = new Pose().set(a);
      assertTrue(inPlace.interpolate(b, t, room, inPlace).sameBits(between));
    }
  }

  private static double distance(Pose a, Pose b) {
    return a.translation.sub(b.translation, new Vec3()).length();
  }

  private static double angle(Pose a, Pose b) {
    Quaternion q = a.rotation.conjugate(new Quaternion());
    return b.rotation.multiply(q, q).angle();
  }
}
