package org.palpate.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class RigidTransformTest {
  /** A rotation by a right angle about z, then a translation. */
  private static final RigidTransform QUARTER_TURN =
      new RigidTransform(
          new Vec3(0, 1, 0), new Vec3(-1, 0, 0), new Vec3(0, 0, 1), new Vec3(5, 6, 7));

  @Test
  void rotatesThenTranslates() {
    Vec3 image = QUARTER_TURN.transform(new Vec3(1, 2, 3), new Vec3());
    assertTrue(image.sameBits(new Vec3(3, 7, 10)), "" + image);
    Vec3 direction = QUARTER_TURN.rotate(new Vec3(1, 2, 3), new Vec3());
    assertTrue(direction.sameBits(new Vec3(-2, 1, 3)), "" + direction);
  }

  @Test
  void inverseRestoresThePointInPlace() {
    Vec3 point = new Vec3(1, 2, 3);
    QUARTER_TURN.transform(point, point);
    QUARTER_TURN.inverseTransform(point, point);
    assertTrue(point.sameBits(new Vec3(1, 2, 3)), "in place: " + point);
  }

  @Test
  void appliesTheFirstOfAProductFirst() {
    RigidTransform twice = QUARTER_TURN.multiply(QUARTER_TURN);
    Vec3 once = QUARTER_TURN.transform(new Vec3(1, 2, 3), new Vec3());
    assertTrue(
        twice
            .transform(new Vec3(1, 2, 3), new Vec3())
            .sameBits(QUARTER_TURN.transform(once, new Vec3())));
    assertFalse(twice.sameBits(QUARTER_TURN));
    assertTrue(twice.sameBits(QUARTER_TURN.multiply(QUARTER_TURN)));
  }

  @Test
  void boundsTheChangeOfLengths() {
    assertEquals(0, QUARTER_TURN.distortion());
    Vec3 stretched = new Vec3(2, 0, 0); // 2^2 - 1 = 3
    Vec3 skewed = new Vec3(0, 1, 1); // 2 - 1 = 1, and 1 with the next
    Vec3 z = new Vec3(0, 0, 1);
    assertEquals(
        Math.sqrt(9 + 1 + 2),
        new RigidTransform(stretched, skewed, z, new Vec3()).distortion(),
        1e-12);
  }

  @Test
  void recognizesOrthonormalAxes() {
    assertTrue(QUARTER_TURN.isOrthonormal());
    assertTrue(RigidTransform.identity().isOrthonormal());
    Vec3 x = new Vec3(1, 0, 0);
    Vec3 skewed = new Vec3(0.1, 0.995, 0);
    assertFalse(new RigidTransform(x, skewed, new Vec3(0, 0, 1), x).isOrthonormal());
    Vec3 tooLong = new Vec3(0, 1.01, 0);
    assertFalse(new RigidTransform(x, tooLong, new Vec3(0, 0, 1), x).isOrthonormal());
  }

  @Test
  void mirrorsIfTheAxesAreLeftHanded() {
    Vec3 x = new Vec3(0, 0, 1);
    Vec3 y = new Vec3(1, 0, 0);
    assertTrue(x.cross(y, new Vec3()).sameBits(new Vec3(0, 1, 0)));
    assertFalse(QUARTER_TURN.isMirrored());
    assertFalse(new RigidTransform(x, y, new Vec3(0, 1, 0), x).isMirrored());
    assertTrue(new RigidTransform(x, y, new Vec3(0, -1, 0), x).isMirrored());
  }

  @Test
  void sameBitsDistinguishesNegativeZeroAndEqualsNan() {
    assertFalse(new Vec3(0, 0, 0).sameBits(new Vec3(-0.0, 0, 0)));
    assertTrue(new Vec3(Double.NaN, 0, 0).sameBits(new Vec3(Double.NaN, 0, 0)));
    assertEquals(3, new Vec3(1, 2, 2).length());
    assertFalse(new Vec3(0, Double.NEGATIVE_INFINITY, 0).isFinite());
  }

  @Test
  void getsAndSetsComponentsByAxis() {
    Vec3 vector = new Vec3();
    for (int axis = 0; axis < 3; axis++) {
      vector.set(axis, axis + 1);
      assertEquals(axis + 1, vector.get(axis));
    }
    assertTrue(vector.sameBits(new Vec3(1, 2, 3)));
  }
}
