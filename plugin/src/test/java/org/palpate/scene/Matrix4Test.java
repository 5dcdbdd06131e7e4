package org.palpate.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;

class Matrix4Test {
  private static final long SEED = Seeds.seed();

  private final SplittableRandom random = new SplittableRandom(SEED);

  private RigidTransform randomPose() {
    return RandomGeometry.pose(random, 50).transform(RigidTransform.identity());
  }

  @Test
  void aPoseMovesPointsAsItsTransformDoes() {
    for (int round = 0; round < 100; round++) {
      RigidTransform pose = randomPose();
      Vec3 point = RandomGeometry.vector(random, 30);
      Vec3 moved = new Vec3();
      assertEquals(1, Matrix4.of(pose).project(point, moved));
      Vec3 expected = pose.transform(point, new Vec3());
      assertEquals(0, expected.sub(moved, moved).length(), 1e-12, "seed=" + SEED);
    }
  }

  @Test
  void aProductAppliesItsSecondFactorFirst() {
    for (int round = 0; round < 100; round++) {
      RigidTransform a = randomPose();
      RigidTransform b = randomPose();
      Matrix4 product = Matrix4.of(a).times(Matrix4.of(b));
      Matrix4 expected = Matrix4.of(a.multiply(b));
      for (int n = 0; n < 16; n++) {
        assertEquals(expected.at(n / 4, n % 4), product.at(n / 4, n % 4), 1e-12, "seed=" + SEED);
      }
    }
  }

  @Test
  void floatsStandColumnByColumn() {
    RigidTransform pose = randomPose();
    pose.origin().set(7, 8, 9);
    Matrix4 matrix = Matrix4.of(pose);
    float[] floats = matrix.toFloats();
    assertEquals(7, floats[12]);
    assertEquals(8, floats[13]);
    assertEquals(9, floats[14]);
    assertEquals(1, floats[15]);
    for (int n = 0; n < 16; n++) {
      assertEquals((float) matrix.at(n % 4, n / 4), floats[n]);
    }
  }

  @Test
  void aPerspectivePutsItsPlanesAtMinusOneAndOne() {
    Matrix4 projection = Matrix4.perspective(0.5, 2, 3, 12, 0);
    Vec3 seen = new Vec3();
    assertEquals(3, projection.project(new Vec3(0, 0, -3), seen));
    assertEquals(-1, seen.z, 1e-12);
    assertEquals(12, projection.project(new Vec3(0, 0, -12), seen));
    assertEquals(1, seen.z, 1e-12);
    projection.project(new Vec3(0, 2.5, -10), seen);
    assertEquals(1, seen.y, 1e-12, "half the height of 5 at a distance of 10");
    projection.project(new Vec3(5, 0, -10), seen);
    assertEquals(1, seen.x, 1e-12, "twice as wide as high");
    assertTrue(projection.project(new Vec3(0, 0, 1), seen) < 0, "behind the eye");
  }

  @Test
  void aShiftMovesThePictureSideways() {
    Vec3 straight = new Vec3();
    Vec3 shifted = new Vec3();
    Vec3 point = new Vec3(1, 1, -7);
    Matrix4.perspective(0.5, 1, 1, 20, 0).project(point, straight);
    Matrix4.perspective(0.5, 1, 1, 20, 0.25).project(point, shifted);
    assertEquals(-0.25, shifted.x - straight.x, 1e-12);
    assertEquals(straight.y, shifted.y);
  }
}
