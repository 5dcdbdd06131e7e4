package org.palpate.rigid.tool;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;
import org.palpate.testing.Seeds;

class TriangleRayTest {
  private static final Vec3 A = new Vec3(0, 0, 1);
  private static final Vec3 B = new Vec3(4, 0, 1);
  private static final Vec3 C = new Vec3(0, 4, 5);

  private final TriangleRay triangle = new TriangleRay();
  private final SplittableRandom random = new SplittableRandom(Seeds.seed());

  @Test
  void aLineMeetsTheTriangleFromAboveOrBelow() {
    triangle.set(A, B, C);
    assertEquals(1, triangle.crossing(1, 1));
    assertEquals(0, triangle.crossing(3, 3));
    assertEquals(0, triangle.crossing(-1, 1));
    triangle.set(A, C, B);
    assertEquals(-1, triangle.crossing(1, 1));
    assertEquals(0, triangle.crossing(3, 3));
  }

  @Test
  void aTriangleOnItsEdgeIsMetByNoLine() {
    triangle.set(A, B, new Vec3(2, 0, 9));
    assertEquals(0, triangle.crossing(2, 0));
    assertEquals(0, triangle.crossing(1, 0));
  }

  @Test
  void thePlaneLiesBelowThePointsOnItAndAboveIt() {
    for (boolean up : new boolean[] {true, false}) {
      triangle.set(A, up ? B : C, up ? C : B);
      assertTrue(triangle.isBelow(1, 1, 2), "in the plane");
      assertTrue(triangle.isBelow(1, 1, Math.nextUp(2.0)));
      assertFalse(triangle.isBelow(1, 1, Math.nextDown(2.0)));
      assertEquals(2, triangle.height(1, 1), 1e-15);
    }
  }

  @Test
  void theBoxOfATriangleHoldsItsCorners() {
    triangle.set(new Vec3(3, -1, 0), new Vec3(-2, 5, 0), new Vec3(1, 2, 0));
    assertEquals(-2, triangle.lowX());
    assertEquals(3, triangle.highX());
    assertEquals(-1, triangle.lowY());
    assertEquals(5, triangle.highY());
  }

  /** Lines pass corners and edges of the fan, and points a rounding beside them. */
  @Test
  void aLineMeetsExactlyOneTriangleOfAFanAroundACorner() {
    for (int fan = 0; fan < 200; fan++) {
      Vec3 middle = new Vec3(random.nextInt(-4, 5), random.nextInt(-4, 5), 0);
      Vec3[] rim = rim(middle, 3 + random.nextInt(6));
      for (int line = 0; line < 50; line++) {
        double part = random.nextInt(3) / 4.0;
        double x = beside(middle.x + part * (rim[0].x - middle.x));
        double y = beside(middle.y + part * (rim[0].y - middle.y));
        int met = 0;
        for (int n = 0; n < rim.length; n++) {
          triangle.set(middle, rim[n], rim[(n + 1) % rim.length]);
          met += triangle.crossing(x, y);
        }
        assertEquals(1, met, "seed=" + Seeds.seed() + " fan " + fan + " at " + x + ", " + y);
      }
    }
  }

  /** Returns corners around a point, counter-clockwise; the first is the one that lines go to. */
  private Vec3[] rim(Vec3 middle, int corners) {
    Vec3[] rim = new Vec3[corners];
    for (int n = 0; n < corners; n++) {
      double turn = 2 * Math.PI * (n + 0.4 * random.nextDouble()) / corners;
      double radius = random.nextDouble(10, 20);
      double x = middle.x + Math.rint(radius * Math.cos(turn));
      double y = middle.y + Math.rint(radius * Math.sin(turn));
      rim[n] = new Vec3(x, y, random.nextDouble());
    }
    return rim;
  }

  private double beside(double value) {
    return value + random.nextInt(-1, 2) * Math.ulp(value);
  }
}
