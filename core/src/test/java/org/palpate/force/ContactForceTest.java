package org.palpate.force;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.testing.Floor;
import org.palpate.volume.ScalarVolume;

class ContactForceTest {
  private static final long SEED = Long.getLong("palpate.seed", 20130613);
  private static final GridMetric UNIT = new GridMetric(1, 1, 1);
  private static final GridMetric CT = new GridMetric(0.8, 1.25, 2);

  private final InteractionPoint point = new InteractionPoint();
  private final Vec3 force = new Vec3();

  @Test
  void theCouplingIsMetric() {
    ContactForce contact = new ContactForce(CT, ForceSettings.of(0.5, 0.2));
    point.position.set(10, 10, 10);
    contact.compute(point, new Vec3(9, 8, 8), force);
    assertEquals("(0.4, 1.25, 2.0)", force.toString());
  }

  @Test
  void isZeroIfThePointIsAtTheDevice() {
    ContactForce contact = new ContactForce(CT, ForceSettings.of(0.5, 0.2));
    point.position.set(10, 10, 10);
    slide(point, CT, 9, 10, 10, true);
    contact.compute(point, new Vec3(9, 10, 10), force);
    assertEquals(0, force.length());
  }

  @Test
  void subtractsTheHeightOfTheSurface() {
    ContactForce contact = new ContactForce(UNIT, ForceSettings.of(2, 0));
    point.surfaceHeightMm = 1;
    contact.compute(point, new Vec3(0, -3, 0), force);
    assertEquals("(0.0, 4.0, 0.0)", force.toString());
    contact.compute(point, new Vec3(0, -0.75, 0), force);
    assertEquals(0, force.length());
  }

  @Test
  void frictionFollowsThePressingForceAndOpposesTheSlide() {
    ContactForce contact = new ContactForce(UNIT, ForceSettings.of(1, 0.25));
    slide(point, UNIT, 3, 0, 0, true);
    contact.compute(point, new Vec3(3, 0, -4), force);
    assertEquals(-0.25 * 4, force.x, 1e-15);
    assertEquals(4, force.z);
  }

  @Test
  void theShorterFormDiffersFromEquation4AtFortyFiveDegrees() {
    ForceSettings shorter = new ForceSettings(1, 1, FrictionForm.SHORTER, true);
    slide(point, UNIT, 1, 0, 0, true);
    Vec3 device = new Vec3(0, 0, -1);
    double whole = Math.sqrt(2);
    new ContactForce(UNIT, ForceSettings.of(1, 1)).compute(point, device, force);
    assertEquals(0.7071 * whole, 1 - force.x, 1e-4);
    new ContactForce(UNIT, shorter).compute(point, device, force);
    assertEquals(0.2929 * whole, 1 - force.x, 1e-4);
  }

  @Test
  void frictionIsWeightedByTheFractionOfThePathThatSlid() {
    ContactForce contact = new ContactForce(UNIT, ForceSettings.of(1, 0.5));
    slide(point, UNIT, 3, 0, 0, false);
    slide(point, UNIT, 4, 0, 0, true);
    contact.compute(point, new Vec3(4, 0, -2), force);
    assertEquals(-0.5 * 2 * 0.25, force.x, 1e-15);
  }

  @Test
  void aSlideThatReturnsToItsStartHasNoFriction() {
    ContactForce contact = new ContactForce(UNIT, ForceSettings.of(1, 0.5));
    slide(point, UNIT, 1, 0, 0, true);
    slide(point, UNIT, 0, 0, 0, true);
    contact.compute(point, new Vec3(0, 0, -2), force);
    assertEquals("(0.0, 0.0, 2.0)", force.toString());
  }

  @Test
  void skippingFrictionNeverChangesTheForce() {
    SplittableRandom random = new SplittableRandom(SEED);
    Vec3 other = new Vec3();
    for (int run = 0; run < 20_000; run++) {
      double friction = run % 3 == 0 ? 0 : 0.3;
      InteractionPoint moved = randomPoint(random);
      Vec3 device = randomVector(random);
      ContactForce skips =
          new ContactForce(CT, new ForceSettings(0.5, friction, FrictionForm.EQUATION_4, true));
      ContactForce computes =
          new ContactForce(CT, new ForceSettings(0.5, friction, FrictionForm.EQUATION_4, false));
      skips.compute(moved, device, force);
      computes.compute(moved, device, other);
      assertEquals(0, force.sub(other, other).length(), "seed=" + SEED + " run=" + run);
      assertEquals(0, computes.frictionSkipped());
    }
  }

  @Test
  void framesWithoutFrictionAreCounted() {
    ContactForce without = new ContactForce(UNIT, ForceSettings.of(1, 0));
    slide(point, UNIT, 3, 0, 0, true);
    without.compute(point, new Vec3(3, 0, -4), force);
    assertEquals(1, without.frictionSkipped(), "mu is 0");
    ContactForce rough = new ContactForce(UNIT, ForceSettings.of(1, 0.3));
    rough.compute(point, new Vec3(3, 0, -4), force);
    assertEquals(0, rough.frictionSkipped());
    point.legs.clear();
    slide(point, UNIT, 4, 0, 0, false);
    rough.compute(point, new Vec3(3, 0, -4), force);
    assertEquals(1, rough.frictionSkipped(), "nothing slid");
  }

  /** Presses 0.01 mm deeper in each millisecond and returns the last force. */
  private double pressSteadily(ContactForce contact, double fromZ) {
    point.contact = true;
    for (int n = 1; n <= 100; n++) {
      contact.compute(point, new Vec3(0, 0, fromZ - 0.01 * n), 1_000_000, force);
    }
    return force.z;
  }

  @Test
  void dampingFollowsTheSettingsOfTheFrame() {
    ForceSettings plain = ForceSettings.of(1, 0);
    ForceSettings damped =
        new ForceSettings(new Material(1, 0, 0, 0.01), FrictionForm.EQUATION_4, true, List.of());
    ContactForce contact = new ContactForce(UNIT, damped);
    assertEquals(2 + 0.01 * 10, pressSteadily(contact, -1), 1e-6, "10 mm/s");
    contact.change(plain);
    assertEquals(3, pressSteadily(contact, -2), 1e-12);
    contact.change(damped);
    assertEquals(4 + 0.01 * 10, pressSteadily(contact, -3), 1e-6);
    ContactForce later = new ContactForce(UNIT, plain);
    later.change(damped);
    assertEquals(2 + 0.01 * 10, pressSteadily(later, -1), 1e-6);
  }

  @Test
  void dampingOfGreyValuesStaysWhenTheSettingsChange() {
    ScalarVolume values = ScalarVolume.of(Floor.GRID, ScalarVolume.Storage.INT16);
    ContactForce contact = new ContactForce(UNIT, ForceSettings.of(1, 0));
    contact.use(new GreyMaterials(values, List.of(new GreyMaterials.Row(0, 1, 0, 0.01))));
    assertEquals(2 + 0.01 * 10, pressSteadily(contact, -1), 1e-6);
    contact.change(ForceSettings.of(1, 0));
    assertEquals(3 + 0.01 * 10, pressSteadily(contact, -2), 1e-6);
  }

  private static ForceSettings ofObjects(double... stiffnesses) {
    List<Material> materials = new ArrayList<>();
    for (double stiffness : stiffnesses) {
      materials.add(new Material(stiffness, 0, 0, 0));
    }
    return new ForceSettings(
        new Material(1, 0, 0, 0), FrictionForm.EQUATION_4, true, List.copyOf(materials));
  }

  private double press(ContactForce contact, int object, double x) {
    point.contact = true;
    point.touchedObject = object;
    point.position.set(x, 0, 0);
    contact.compute(point, new Vec3(x, 0, -2), 1_000_000, force);
    return force.z;
  }

  @Test
  void anotherObjectIsFeltAsFarAsTheHandMoves() {
    ContactForce contact = new ContactForce(UNIT, ofObjects(0.5, 1));
    assertEquals(1, press(contact, 0, 30));
    assertEquals(1, press(contact, 0, 30));
    double atRest = press(contact, 1, 30);
    assertTrue(atRest > 1 && atRest < 1.1, "a hand at rest far from the origin: " + atRest);
    assertEquals(2, press(contact, 1, 36), 1e-12);
  }

  @Test
  void changedSettingsAreFeltAtOnce() {
    ContactForce contact = new ContactForce(UNIT, ofObjects(0.5));
    press(contact, 0, 30);
    assertEquals(1, press(contact, 0, 30));
    contact.change(ofObjects(1.5));
    assertEquals(3, press(contact, 0, 30));
    assertEquals(1.5, contact.stiffnessNewtonPerMm());
    assertTrue(contact.settings().distinguishesObjects());
  }

  @Test
  void aJumpOfThePointIsLimitedUnlessTheFrameBeforeHadNoLimit() {
    for (boolean pauses : new boolean[] {false, true}) {
      ContactForce contact = new ContactForce(UNIT, ForceSettings.of(1, 0));
      Vec3 device = new Vec3(0, 0, -1);
      point.position.set(0, 0, 0);
      point.limitsForceRate = true;
      contact.compute(point, device, 1_000_000, force);
      point.limitsForceRate = !pauses;
      contact.compute(point, device, 1_000_000, force);
      assertEquals(1, force.z);
      point.limitsForceRate = true;
      point.position.set(0, 0, 5);
      contact.compute(point, device, 1_000_000, force);
      assertTrue(pauses ? force.z == 6 : force.z < 1.1, "force " + force);
    }
  }

  /** The reference computes n by Gram-Schmidt, not the root of a difference. */
  @Test
  void agreesWithFrictionByAnExplicitNormal() {
    SplittableRandom random = new SplittableRandom(SEED);
    ContactForce contact = new ContactForce(CT, ForceSettings.of(0.5, 0.3));
    for (int run = 0; run < 20_000; run++) {
      InteractionPoint moved = randomPoint(random);
      Vec3 device = randomVector(random);
      contact.compute(moved, device, force);
      Vec3 expected = byExplicitNormal(moved, device);
      assertTrue(
          force.sub(expected, new Vec3()).length() <= 1e-7 * (1 + expected.length()),
          "seed=" + SEED + " run=" + run + " force=" + force + " expected=" + expected);
    }
  }

  @Test
  void settingsOutOfRangeAreRefusedWithTheirValue() {
    String message =
        assertThrows(IllegalArgumentException.class, () -> ForceSettings.of(-1, 0)).getMessage();
    assertEquals(
        "stiffnessNewtonPerMm must be at least 0 and finite: stiffnessNewtonPerMm=-1.0", message);
    assertThrows(IllegalArgumentException.class, () -> ForceSettings.of(1, Double.NaN));
  }

  private static Vec3 byExplicitNormal(InteractionPoint moved, Vec3 device) {
    Vec3 coupling = moved.position.sub(device, new Vec3());
    coupling.set(0.5 * 0.8 * coupling.x, 0.5 * 1.25 * coupling.y, 0.5 * 2 * coupling.z);
    Vec3 v = new Vec3();
    double slid = 0;
    for (int leg = 0; leg < moved.legs.count(); leg++) {
      if (moved.legs.slid(leg)) {
        slid += moved.legs.lengthMm(leg);
        for (int axis = 0; axis < 3; axis++) {
          double along = moved.legs.end(leg, axis) - moved.legs.start(leg, axis);
          v.set(axis, v.get(axis) + along * (axis == 0 ? 0.8 : axis == 1 ? 1.25 : 2));
        }
      }
    }
    if (v.length() == 0) {
      return coupling;
    }
    v.mul(1 / v.length(), v);
    Vec3 n = coupling.sub(v.mul(coupling.dot(v), new Vec3()), new Vec3());
    double pressing = n.length() == 0 ? 0 : Math.abs(coupling.dot(n)) / n.length();
    return coupling.sub(v.mul(0.3 * pressing * slid / moved.legs.lengthMm(), v), new Vec3());
  }

  private static InteractionPoint randomPoint(SplittableRandom random) {
    InteractionPoint moved = new InteractionPoint();
    moved.position.set(randomVector(random));
    int legs = (int) ((random.nextLong() >>> 1) % 4);
    for (int leg = 0; leg < legs; leg++) {
      Vec3 to = randomVector(random);
      slide(moved, CT, to.x, to.y, to.z, (random.nextLong() & 1) == 0);
    }
    return moved;
  }

  private static Vec3 randomVector(SplittableRandom random) {
    return new Vec3(component(random), component(random), component(random));
  }

  private static double component(SplittableRandom random) {
    return (random.nextLong() >>> 11) * 0x1p-53 * 20 - 10;
  }

  private static void slide(
      InteractionPoint moved,
      GridMetric metric,
      double x,
      double y,
      double z,
      boolean alongSurface) {
    Vec3 p = moved.position;
    double length = metric.distance(p.x, p.y, p.z, x, y, z);
    moved.legs.add(p.x, p.y, p.z, x, y, z, length, alongSurface);
    p.set(x, y, z);
  }
}
