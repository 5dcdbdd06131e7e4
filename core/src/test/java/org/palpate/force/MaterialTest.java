package org.palpate.force;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.TouchedObjectFinder;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.volume.BitCube;

/** Touches a floor of two objects side by side: a soft left half and a right half of bone. */
class MaterialTest {
  private static final int EDGE = 48;
  private static final int TOP = 16;
  private static final int SEAM = 24;
  private static final GridMetric UNIT = new GridMetric(1, 1, 1);
  private static final Material SOFT = new Material(0.2, 0.5, 0.4, 0);
  private static final Material BONE = new Material(0.9, 0.1, 0.1, 0);
  private static final Material SOFT_SLIPPERY = new Material(0.2, 0, 0, 0);
  private static final Material BONE_SLIPPERY = new Material(0.9, 0, 0, 0);
  private static final long FRAME_NANOS = 1_000_000;

  private final InteractionPoint point = new InteractionPoint();
  private final Vec3 device = new Vec3();
  private final Vec3 force = new Vec3();
  private final TouchedObjectFinder touched = new TouchedObjectFinder();
  private final CollisionScene floor = new CollisionScene(List.of(slab(0, SEAM), slab(SEAM, EDGE)));

  @Test
  void theHandFeelsTheObjectThatStopsThePoint() {
    for (ProxySolver solver : List.of(new GuardedSolver(UNIT, 8), new SmoothSolver(UNIT, 8))) {
      ContactForce contact = contactOf(FrictionForm.EQUATION_4, SOFT, BONE);
      press(solver, contact, 12.3, 3);
      assertEquals(SOFT.stiffnessNewtonPerMm() * 3, force.z, 0.02);
      lift(solver, contact, 36.3);
      press(solver, contact, 36.3, 3);
      assertEquals(BONE.stiffnessNewtonPerMm() * 3, force.z, 0.05);
    }
  }

  @Test
  void objectsWithoutAMaterialOfTheirOwnHaveTheGeneralOne() {
    Material general = new Material(0.5, 0, 0, 0);
    ContactForce contact =
        new ContactForce(UNIT, new ForceSettings(general, FrictionForm.CONE, true, List.of(SOFT)));
    press(new GuardedSolver(UNIT, 8), contact, 36.3, 2);
    assertEquals(1, force.z, 1e-5);
  }

  @Test
  void theHandFeelsTheFirstOfSeveralObjectsThatShareAVoxel() {
    CollisionScene twice = new CollisionScene(List.of(slab(0, EDGE), slab(0, EDGE)));
    point.position.set(10, 10, TOP + 2);
    point.contact = true;
    touched.find(twice, device.set(10.5, 10.5, TOP - 2), point);
    assertEquals(0, point.touchedObject);
    touched.find(twice, device.set(10.5, 10.5, TOP + 3), point);
    assertEquals(InteractionPoint.NO_OBJECT, point.touchedObject);
  }

  /** The forces of the two materials differ by 3.5 N where the hand crosses the seam. */
  @Test
  void theForceDoesNotJumpBetweenMaterials() {
    for (FrictionForm form : List.of(FrictionForm.EQUATION_4, FrictionForm.CONE)) {
      for (double speed : new double[] {0.01, 0.1, 0.6}) {
        ContactForce contact = contactOf(form, SOFT_SLIPPERY, BONE_SLIPPERY);
        SmoothSolver solver = new SmoothSolver(UNIT, 8);
        press(solver, contact, SEAM - 6.2, 5);
        Vec3 last = new Vec3().set(force);
        double largest = 0;
        for (double x = SEAM - 6.2; x < SEAM + 9; x += speed) {
          frame(solver, contact, x, TOP - 5, FRAME_NANOS);
          double change = force.sub(last, new Vec3()).length();
          largest = Math.max(largest, change / Math.max(speed, ChangeBound.MIN_MOTION_EDGES));
          last.set(force);
        }
        assertEquals(0.9 * 5, force.z, 0.1, form + " speed=" + speed);
        assertTrue(largest <= 1.5 * 0.9, form + " speed=" + speed + " largest=" + largest);
      }
    }
  }

  @Test
  void theForceOnVoxelsChangesNoFasterThanTheHandMoves() {
    ContactForce contact = contactOf(FrictionForm.EQUATION_4, SOFT_SLIPPERY, BONE_SLIPPERY);
    GuardedSolver solver = new GuardedSolver(UNIT, 8);
    press(solver, contact, SEAM - 0.3, 5);
    double before = force.length();
    frame(solver, contact, SEAM + 0.3, TOP - 5, FRAME_NANOS);
    assertTrue(force.length() - before <= 0.9 * 0.6 + 1e-9, force + " after " + before);
    for (int n = 0; n < 200; n++) {
      frame(solver, contact, SEAM + 0.3, TOP - 5, FRAME_NANOS);
    }
    assertEquals(0.9 * 5, force.z, 0.01);
  }

  @Test
  void dampingOpposesPressingInAndNeverHoldsTheHandBack() {
    ContactForce damped = contactOf(FrictionForm.CONE, new Material(0.5, 0, 0, 0.01), BONE);
    ContactForce bare = contactOf(FrictionForm.CONE, new Material(0.5, 0, 0, 0), BONE);
    double in = forceAtEndOfDescent(damped, 0.05);
    double undamped = forceAtEndOfDescent(bare, 0.05);
    assertEquals(0.01 * 50, in - undamped, 0.02); // 50 mm/s
    double out = inwardForceDuringAscent(damped, 5);
    assertTrue(out >= 0 && out < 1e-9, "pulled back by " + out);
  }

  @Test
  void dampingBeginsWithContactWithoutAJump() {
    ContactForce damped = contactOf(FrictionForm.CONE, new Material(0.5, 0, 0, 0.1), BONE);
    GuardedSolver solver = new GuardedSolver(UNIT, 8);
    double last = 0;
    point.position.set(12.3, 20.4, TOP + 5);
    for (double z = TOP + 5; z > TOP - 3; z -= 0.05) {
      frame(solver, damped, 12.3, z, FRAME_NANOS);
      assertTrue(force.z - last <= 2 * 0.5 * 0.05 + 1e-5, "z=" + z + ": " + last + ", " + force.z);
      last = force.z;
    }
    assertTrue(last > 2);
  }

  @Test
  void aMaterialOutOfRangeIsRefusedWithItsValues() {
    assertThrows(IllegalArgumentException.class, () -> new Material(-1, 0, 0, 0));
    assertThrows(IllegalArgumentException.class, () -> new Material(1, 0, 0, Double.NaN));
    String message =
        assertThrows(IllegalArgumentException.class, () -> new Material(1, 0.2, 0.3, 0))
            .getMessage();
    assertTrue(message.endsWith("slidingFriction=0.3 staticFriction=0.2"), message);
  }

  @Test
  void allMaterialsAreRetunedTogether() {
    ForceSettings settings =
        new ForceSettings(BONE, FrictionForm.CONE, true, List.of(SOFT, BONE)).retuned(2, -0.2);
    assertEquals(new Material(0.4, 0.3, 0.24, 0), rounded(settings.material(0)));
    assertEquals(0, settings.material(1).staticFriction());
    assertEquals(1.8, settings.stiffestNewtonPerMm());
  }

  private static Material rounded(Material material) {
    return new Material(
        material.stiffnessNewtonPerMm(),
        Math.rint(material.staticFriction() * 1e9) / 1e9,
        Math.rint(material.slidingFriction() * 1e9) / 1e9,
        material.dampingNewtonSecondPerMm());
  }

  private double forceAtEndOfDescent(ContactForce contact, double mmAFrame) {
    GuardedSolver solver = new GuardedSolver(UNIT, 8);
    point.position.set(12.3, 20.4, TOP + 2);
    for (double z = TOP + 2; z > TOP - 5; z -= mmAFrame) {
      frame(solver, contact, 12.3, z, FRAME_NANOS);
    }
    return force.z;
  }

  /** Returns the largest inward force while the hand moves out. */
  private double inwardForceDuringAscent(ContactForce contact, double mmAFrame) {
    GuardedSolver solver = new GuardedSolver(UNIT, 8);
    press(solver, contact, 12.3, 5);
    double worst = 0;
    for (double z = TOP - 5; z < TOP + 5; z += mmAFrame) {
      frame(solver, contact, 12.3, z, FRAME_NANOS);
      worst = Math.max(worst, -force.z);
    }
    return worst;
  }

  private static ContactForce contactOf(FrictionForm form, Material left, Material right) {
    return new ContactForce(
        UNIT, new ForceSettings(new Material(9, 0, 0, 0), form, true, List.of(left, right)));
  }

  private void press(ProxySolver solver, ContactForce contact, double x, double depth) {
    point.position.set(x, 20.4, TOP + 4);
    solver.reset();
    for (int n = 0; n <= 400; n++) {
      frame(solver, contact, x, TOP + 4 - Math.min(1, n / 300.0) * (4 + depth), FRAME_NANOS);
    }
  }

  private void lift(ProxySolver solver, ContactForce contact, double x) {
    for (int n = 0; n < 200; n++) {
      frame(solver, contact, x, TOP + 8, FRAME_NANOS);
    }
  }

  private void frame(
      ProxySolver solver, ContactForce contact, double x, double z, long elapsedNanos) {
    device.set(x, 20.4, z);
    solver.follow(floor, device, point);
    touched.find(floor, device, point);
    contact.compute(point, device, elapsedNanos, force);
  }

  private static BitCube slab(int fromX, int toX) {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int k = 0; k < TOP; k++) {
      for (int j = 0; j < EDGE; j++) {
        for (int i = fromX; i < toX; i++) {
          bits.set(i, j, k);
        }
      }
    }
    return bits;
  }
}
