package org.palpate.accuracy;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.volume.BitCube;

/** An edge sharper than the kernel is felt near its position, which is where the force vanishes. */
class SharpEdgeTest {
  private static final int EDGE = 64;
  private static final double MIDDLE = 32;
  private static final GridMetric UNIT = new GridMetric(1, 1, 1);

  /** The distances of the two sides of the edge from the middle, off the grid. */
  private static final double SIDE_U = 12.3;

  private static final double SIDE_V = 11.7;

  private final InteractionPoint point = new InteractionPoint();
  private final Vec3 device = new Vec3();

  @Test
  void aCubesEdgeIsFeltWithinSevenTenthsOfAVoxel() {
    for (double turn : new double[] {0, 0.2, 0.5}) {
      for (double depth : new double[] {0.5, 1, 2, 4}) {
        double worst = slideAround(turn, depth);
        assertTrue(worst <= 0.72, "turn " + turn + " depth " + depth + ": " + worst);
      }
    }
  }

  /** Slides around the edge inside the cube; returns the largest error of the felt position. */
  private double slideAround(double turn, double depth) {
    double cosine = StrictMath.cos(turn);
    double sine = StrictMath.sin(turn);
    CollisionScene scene = new CollisionScene(List.of(cube(cosine, sine)));
    SmoothSolver solver = new SmoothSolver(UNIT, 8);
    point.position.set(MIDDLE + 20 * cosine, MIDDLE + 20 * sine, MIDDLE);
    double corner = SIDE_V - depth;
    double worst = 0;
    for (int frame = 0; frame < 900; frame++) {
      double distance = 0.03 * frame;
      double u = SIDE_U - depth - Math.max(0, distance - corner);
      double v = Math.min(distance, corner);
      device.set(MIDDLE + cosine * u - sine * v, MIDDLE + sine * u + cosine * v, MIDDLE + 0.2);
      solver.follow(scene, device, point);
      if (frame > 60) {
        worst = Math.max(worst, Math.abs(feltOutside(cosine, sine)));
      }
    }
    return worst;
  }

  /** Returns the signed distance from the cube's surface to the point where the force vanishes. */
  private double feltOutside(double cosine, double sine) {
    Vec3 pull = point.position.sub(device, new Vec3());
    double length = pull.length();
    double felt = Math.max(0, length - point.surfaceHeightMm);
    pull.mul(length > 0 ? felt / length : 0, pull);
    double x = device.x + pull.x - MIDDLE;
    double y = device.y + pull.y - MIDDLE;
    double u = cosine * x + sine * y - SIDE_U;
    double v = -sine * x + cosine * y - SIDE_V;
    return u > 0 && v > 0 ? Math.sqrt(u * u + v * v) : Math.max(u, v);
  }

  private static BitCube cube(double cosine, double sine) {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
      int i = n % EDGE;
      int j = n / EDGE % EDGE;
      int k = n / (EDGE * EDGE);
      double x = i + 0.5 - MIDDLE;
      double y = j + 0.5 - MIDDLE;
      double z = k + 0.5 - MIDDLE;
      double u = cosine * x + sine * y;
      double v = -sine * x + cosine * y;
      if (u < SIDE_U && v < SIDE_V && u > -15 && v > -15 && Math.abs(z) < 15) {
        bits.set(i, j, k);
      }
    }
    return bits;
  }
}
