package org.palpate.force;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;

class ForceSettingsTest {
  private final Material plain = new Material(0.5, 0.2, 0.15, 0);
  private final Material damped = new Material(0.25, 0.1, 0.1, 1e-9);

  private static ForceSettings settings(Material general, Material... objects) {
    return new ForceSettings(general, FrictionForm.CONE, true, List.of(objects));
  }

  @Test
  void dampsIfAnyMaterialDoes() {
    assertFalse(settings(plain).damps());
    assertFalse(settings(plain, plain, plain).damps());
    assertTrue(settings(damped, plain).damps());
    assertTrue(settings(plain, damped, plain).damps());
  }

  @Test
  void objectsWithoutAMaterialHaveTheGeneralOne() {
    ForceSettings settings = settings(plain, damped);
    assertTrue(settings.distinguishesObjects());
    assertFalse(settings(plain).distinguishesObjects());
    assertEquals(damped, settings.material(0));
    assertEquals(plain, settings.material(1));
    assertEquals(plain, settings.material(-1));
    assertEquals(0.5, settings.stiffnessNewtonPerMm());
    assertEquals(0.2, settings.friction());
    assertEquals(0.5, settings.stiffestNewtonPerMm());
    assertEquals(0.5, settings(damped, plain).stiffestNewtonPerMm());
  }

  @Test
  void aRampRisesFromZeroToOneAndATimeBelowZeroChangesNothing() {
    ForceRamp ramp = new ForceRamp(10);
    assertEquals(1, ramp.factor());
    ramp.start();
    assertEquals(0, ramp.factor());
    ramp.advance(-5);
    assertEquals(0, ramp.factor());
    ramp.advance(9);
    assertEquals(0.9, ramp.factor());
    ramp.advance(Long.MAX_VALUE);
    assertEquals(1, ramp.factor());
    ForceRamp none = new ForceRamp(0);
    none.start();
    assertEquals(1, none.factor());
    assertThrows(IllegalArgumentException.class, () -> new ForceRamp(-1));
  }

  @Test
  void aBoundedChangeTellsWhetherItWasLonger() {
    Vec3 last = new Vec3(1, 2, 3);
    Vec3 force = new Vec3(3, 4, 4);
    assertFalse(ChangeBound.apply(last, 3, force));
    assertTrue(force.sameBits(new Vec3(3, 4, 4)));
    assertTrue(ChangeBound.apply(last, 1.5, force));
    assertTrue(force.sameBits(new Vec3(2, 3, 3.5)), force::toString);
  }
}
