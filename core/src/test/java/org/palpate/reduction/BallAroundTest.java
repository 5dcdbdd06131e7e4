package org.palpate.reduction;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;

class BallAroundTest {
  private static final double RADIUS_MM = 10;

  private final Vec3 middle = new Vec3(1, 2, 3);
  private final BallAround ball =
      new BallAround(List.of(at(1, 0, 0), at(-1, 0, 0), at(0, 1, 0), at(0, -1, 0)));

  @Test
  void aPathAroundStaysOutsideEvenBetweenOppositePoints() {
    Vec3 from = ball.outside(new Vec3(1, 0, 0));
    for (double degrees : new double[] {0, 30, 90, 150, 170, 179.9, 180}) {
      double angle = Math.toRadians(degrees);
      Vec3 to = ball.outside(new Vec3(Math.cos(angle), Math.sin(angle), 0));
      List<Vec3> path = new ArrayList<>(List.of(from));
      path.addAll(ball.between(from, to));
      assertEquals(1 + BallAround.POINTS_BETWEEN, path.size());
      path.add(to);
      for (int n = 1; n < path.size(); n++) {
        double nearMm = distanceToSegment(path.get(n - 1), path.get(n));
        assertTrue(nearMm > RADIUS_MM, degrees + " degrees, part " + n + ": " + nearMm + " mm");
      }
    }
  }

  @Test
  void everyPointHasADirectionFromTheMiddle() {
    assertEquals(1, ball.away(ball.middle()).length(), 0);
    assertEquals(1, ball.away(at(0, 3, 4)).dot(new Vec3(0, 0.6, 0.8)), 1e-12);
  }

  @Test
  void aPathLeadsOutsideOfWhatWasPutFarAway() {
    ball.reachTo(3 * RADIUS_MM);
    assertTrue(distance(ball.outside(new Vec3(0, 0, 2))) > 3 * RADIUS_MM);
    ball.reachTo(0);
    double leastMm = distance(ball.outside(new Vec3(0, 0, 2)));
    assertTrue(leastMm > RADIUS_MM && leastMm < 2 * RADIUS_MM, leastMm + " mm");
  }

  @Test
  void aRayLeavesTheBallWherePathsAroundBegin() {
    double aroundMm = distance(ball.outside(new Vec3(1, 0, 0)));
    Vec3 from = at(0.3, 0.4, 0);
    Vec3 beyond = ball.beyond(from, new Vec3(0, 0, 1));
    assertEquals(aroundMm, distance(beyond), 1e-9);
    assertEquals(from.x, beyond.x, 1e-9);
    assertTrue(beyond.z > from.z);
  }

  private Vec3 at(double x, double y, double z) {
    return new Vec3(x, y, z).mul(RADIUS_MM, new Vec3()).add(new Vec3(1, 2, 3), new Vec3());
  }

  private double distance(Vec3 point) {
    return point.sub(middle, new Vec3()).length();
  }

  private double distanceToSegment(Vec3 from, Vec3 to) {
    Vec3 along = to.sub(from, new Vec3());
    double length = along.dot(along);
    double part = length > 0 ? middle.sub(from, new Vec3()).dot(along) / length : 0;
    return distance(along.mul(Math.min(1, Math.max(0, part)), along).add(from, along));
  }
}
