package org.palpate.accuracy;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.collision.CollisionScene;
import org.palpate.force.ContactForce;
import org.palpate.force.ForceSettings;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.volume.BitCube;

/** The force never jumps over slits, combs, holes, wires and edges, whatever the point does. */
class ForceContinuityTest {
  private static final int EDGE = 48;
  private static final double STIFFNESS = 0.5;
  private static final GridMetric UNIT = new GridMetric(1, 1, 1);

  private final ContactForce contact = new ContactForce(UNIT, ForceSettings.of(STIFFNESS, 0));
  private final InteractionPoint point = new InteractionPoint();
  private final Vec3 device = new Vec3();
  private final Vec3 force = new Vec3();

  @Test
  void theForceIsContinuousOverSlitsOfOneToFiveVoxels() {
    for (int width = 1; width <= 5; width++) {
      int w = width;
      slideOver((i, j, k) -> k < 24 && !(i >= 24 && i < 24 + w));
    }
  }

  @Test
  void theForceIsContinuousOverCombs() {
    for (int width = 1; width <= 6; width++) {
      int w = width;
      slideOver((i, j, k) -> k < 24 && i / w % 2 == 0);
    }
  }

  @Test
  void theForceIsContinuousOverHolesOfOneToFourVoxels() {
    for (int width = 1; width <= 4; width++) {
      int w = width;
      slideOver((i, j, k) -> k < 24 && !(i >= 22 && i < 22 + w && j >= 22 && j < 22 + w));
    }
  }

  @Test
  void theForceIsContinuousOverWiresAndACheckerboard() {
    slideOver((i, j, k) -> j == 24 && k == 23);
    slideOver((i, j, k) -> j >= 23 && j < 26 && k >= 21 && k < 24);
    slideOver((i, j, k) -> k < 24 && (i + j + k) % 2 == 0);
  }

  @Test
  void theForceIsContinuousOverInnerAndOuterEdgesOfEveryAngle() {
    for (int degrees = 20; degrees <= 160; degrees += 20) {
      double slope = StrictMath.tan(StrictMath.toRadians(degrees / 2.0));
      slideOver((i, j, k) -> k < 24 && (24 - k) * slope > Math.abs(i - 23.5));
      slideOver((i, j, k) -> k < 24 && (k - 8) * slope <= Math.abs(i - 23.5));
    }
  }

  private interface Solid {
    boolean at(int i, int j, int k);
  }

  private void slideOver(Solid solid) {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
      int i = n % EDGE;
      int j = n / EDGE % EDGE;
      int k = n / (EDGE * EDGE);
      if (solid.at(i, j, k)) {
        bits.set(i, j, k);
      }
    }
    for (double depth : new double[] {0.7, 2, 4}) {
      for (double sideways : new double[] {0, 0.1}) {
        slide(bits, depth, sideways);
      }
    }
  }

  private void slide(BitCube bits, double depth, double sideways) {
    CollisionScene scene = new CollisionScene(List.of(bits));
    JudgedSolver solver = new JudgedSolver(new SmoothSolver(UNIT, 8), bits);
    point.position.set(6.1, 24.3, 30);
    device.set(point.position);
    step(solver, scene);
    Vec3 last = new Vec3();
    Vec3 lastDevice = new Vec3();
    for (int frame = 0; frame < 700; frame++) {
      last.set(force);
      lastDevice.set(device);
      boolean down = frame < 100;
      device.set(
          down ? 6.1 : device.x + 0.05,
          down ? 24.3 : device.y + 0.05 * sideways,
          down ? 30 - (6 + depth) * (frame + 1) / 100.0 : device.z);
      step(solver, scene);
      double motion = distance(device, lastDevice);
      double most = 1.5 * STIFFNESS * Math.max(0.05, motion);
      assertTrue(distance(force, last) <= most * (1 + 1e-9), "frame " + frame);
    }
  }

  private void step(JudgedSolver solver, CollisionScene scene) {
    solver.follow(scene, device, point);
    contact.compute(point, device, force);
  }

  private static double distance(Vec3 a, Vec3 b) {
    return UNIT.distance(a.x, a.y, a.z, b.x, b.y, b.z);
  }
}
