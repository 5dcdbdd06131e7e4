package org.palpate.volume.phantom;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;
import org.palpate.testing.Seeds;

/** The shapes of phantoms against their definitions, point by point. */
class ShapeTest {
  private final SplittableRandom random = new SplittableRandom(Seeds.seed());

  private Vec3 anywhere() {
    return new Vec3(
        random.nextDouble(-5, 25), random.nextDouble(-5, 25), random.nextDouble(-5, 25));
  }

  private static double at(Shape shape, Vec3 p) {
    return shape.at(p.x, p.y, p.z);
  }

  /** A shape is at most 0 exactly where its definition says, and changes no faster than a point. */
  private void check(Shape shape, Predicate<Vec3> isInside) {
    int inside = 0;
    for (int n = 0; n < 4_000; n++) {
      Vec3 p = anywhere();
      double value = at(shape, p);
      if (Math.abs(value) > 1e-9) {
        assertEquals(isInside.test(p), value < 0, () -> p + " has the value " + value);
      }
      inside += value < 0 ? 1 : 0;
      Vec3 q = anywhere();
      double distance = q.sub(p, new Vec3()).length();
      assertTrue(Math.abs(at(shape, q) - value) <= distance + 1e-9, () -> p + " and " + q);
    }
    assertTrue(inside > 40 && inside < 3_960, "inside: " + inside);
  }

  private static boolean isNear(Vec3 p, Vec3 centre, double radius) {
    return p.sub(centre, new Vec3()).length() <= radius;
  }

  @Test
  void aBallHoldsThePointsWithinItsRadius() {
    Vec3 centre = new Vec3(9, 11, 7);
    check(Shape.ball(centre, 6), p -> isNear(p, centre, 6));
    assertEquals(-6, Shape.ball(centre, 6).at(9, 11, 7));
    assertEquals(4, Shape.ball(centre, 6).at(9, 11, 17));
  }

  @Test
  void anEllipsoidIsABallOfStretchedAxes() {
    check(
        Shape.ellipsoid(new Vec3(9, 11, 7), new Vec3(8, 5, 6)),
        p -> {
          double x = (p.x - 9) / 8;
          double y = (p.y - 11) / 5;
          double z = (p.z - 7) / 6;
          return x * x + y * y + z * z <= 1;
        });
  }

  @Test
  void aHalfSpaceLiesBehindItsPlane() {
    Vec3 normal = new Vec3(1 / 3.0, -2 / 3.0, 2 / 3.0);
    Shape half = Shape.halfSpace(new Vec3(10, 9, 8), normal);
    check(half, p -> (p.x - 10) - 2 * (p.y - 9) + 2 * (p.z - 8) <= 0);
    assertEquals(3, at(half, new Vec3(10 + 1, 9 - 2, 8 + 2)), 1e-12, "3 along the normal");
  }

  /** The nearest of many points of the ring has the distance to it. */
  @Test
  void aTorusHoldsThePointsNearItsRing() {
    Vec3 centre = new Vec3(10, 9, 11);
    Shape torus = Shape.torus(centre, 7, 2.5);
    for (int n = 0; n < 300; n++) {
      Vec3 p = anywhere();
      double nearest = Double.POSITIVE_INFINITY;
      for (int step = 0; step < 3_600; step++) {
        double angle = Math.toRadians(0.1 * step);
        Vec3 q = new Vec3(10 + 7 * Math.cos(angle), 9 + 7 * Math.sin(angle), 11);
        nearest = Math.min(nearest, q.sub(p, q).length());
      }
      assertEquals(nearest - 2.5, at(torus, p), 1e-3, p::toString);
    }
  }

  /** The nearest of many points of the axis has the distance to it. */
  @Test
  void aCapsuleHoldsThePointsNearItsAxis() {
    Vec3 a = new Vec3(3, 5, 7);
    Vec3 b = new Vec3(14, 9, 2);
    Shape capsule = Shape.capsule(a, b, 3);
    int beyond = 0;
    for (int n = 0; n < 400; n++) {
      Vec3 p = anywhere();
      double nearest = Double.POSITIVE_INFINITY;
      int at = 0;
      for (int step = 0; step <= 2_000; step++) {
        Vec3 q = b.sub(a, new Vec3());
        q.mul(step / 2_000.0, q).add(a, q);
        double distance = q.sub(p, q).length();
        at = distance < nearest ? step : at;
        nearest = Math.min(nearest, distance);
      }
      beyond += at == 0 || at == 2_000 ? 1 : 0;
      assertEquals(nearest - 3, at(capsule, p), 1e-3, p::toString);
    }
    assertTrue(beyond > 50 && beyond < 350, "beyond the ends: " + beyond);
  }

  @Test
  void aCylinderStandsOnItsBottom() {
    Shape cylinder = Shape.cylinder(new Vec3(9, 11, 4), 8, 6);
    check(
        cylinder,
        p -> {
          double x = p.x - 9;
          double y = p.y - 11;
          return x * x + y * y <= 36 && p.z >= 4 && p.z <= 12;
        });
    assertEquals(-4, cylinder.at(9, 11, 8));
    assertEquals(-1, cylinder.at(9, 11, 5));
    assertEquals(2, cylinder.at(9, 11, 14));
    assertEquals(-1, cylinder.at(9 + 5, 11, 8));
  }

  @Test
  void aBoxLiesBetweenItsCorners() {
    Shape box = Shape.box(new Vec3(2, 4, 6), new Vec3(12, 10, 20));
    check(box, p -> p.x >= 2 && p.x <= 12 && p.y >= 4 && p.y <= 10 && p.z >= 6 && p.z <= 20);
    assertEquals(-3, box.at(7, 7, 13), "the middle is 3 below the nearest faces");
    for (double[] face :
        List.of(
            new double[] {1, 7, 13},
            new double[] {13, 7, 13},
            new double[] {7, 3, 13},
            new double[] {7, 11, 13},
            new double[] {7, 7, 5},
            new double[] {7, 7, 21})) {
      assertEquals(1, box.at(face[0], face[1], face[2]), "1 outside a face");
    }
    for (double[] face :
        List.of(
            new double[] {2.5, 7, 13},
            new double[] {11.5, 7, 13},
            new double[] {7, 4.5, 13},
            new double[] {7, 9.5, 13},
            new double[] {7, 7, 6.5},
            new double[] {7, 7, 19.5})) {
      assertEquals(-0.5, box.at(face[0], face[1], face[2]), "half below a face");
    }
  }

  @Test
  void aShrunkShapeLosesADepth() {
    Shape ball = Shape.ball(new Vec3(9, 11, 7), 9).shrunk(2);
    check(ball, p -> isNear(p, new Vec3(9, 11, 7), 7));
  }
}
