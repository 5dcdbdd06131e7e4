package org.palpate.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class Vec3Test {
  private final Vec3 a = new Vec3(1, 2, 3);
  private final Vec3 b = new Vec3(-5, 7, 11);

  private static void assertVector(double x, double y, double z, Vec3 vector) {
    assertTrue(vector.sameBits(new Vec3(x, y, z)), vector::toString);
  }

  @Test
  void addsSubtractsAndScales() {
    assertVector(-4, 9, 14, a.add(b, new Vec3()));
    assertVector(6, -5, -8, a.sub(b, new Vec3()));
    assertVector(2, 4, 6, a.mul(2, new Vec3()));
    assertEquals(-5 + 14 + 33, a.dot(b));
    assertEquals(7, new Vec3(2, -3, 6).length());
  }

  @Test
  void multipliesCrosswise() {
    assertVector(2 * 11 - 3 * 7, 3 * -5 - 1 * 11, 1 * 7 - 2 * -5, a.cross(b, new Vec3()));
    Vec3 inPlace = new Vec3().set(a);
    assertSame(inPlace, inPlace.cross(b, inPlace));
    assertVector(1, -26, 17, inPlace);
  }

  @Test
  void readsAndWritesOneComponent() {
    for (int axis = 0; axis < 3; axis++) {
      assertEquals(axis + 1, a.get(axis));
      Vec3 changed = new Vec3().set(a);
      changed.set(axis, 9);
      for (int n = 0; n < 3; n++) {
        assertEquals(n == axis ? 9 : n + 1, changed.get(n));
      }
    }
    assertSame(a, a.set(4, 5, 6));
    assertSame(b, b.set(a));
    assertVector(4, 5, 6, b);
    assertEquals("(4.0, 5.0, 6.0)", b.toString());
  }

  @Test
  void isFiniteOnlyIfAllComponentsAre() {
    assertTrue(a.isFinite());
    for (int axis = 0; axis < 3; axis++) {
      for (double wrong : new double[] {Double.NaN, Double.POSITIVE_INFINITY}) {
        Vec3 vector = new Vec3().set(a);
        vector.set(axis, wrong);
        assertFalse(vector.isFinite());
        assertFalse(vector.sameBits(a));
      }
    }
  }
}
