package org.palpate.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.force.FrictionForm;
import org.palpate.force.Material;

/** The choices of users, as they write them. */
class ChoicesTest {
  @ParameterizedTest
  @ValueSource(
      strings = {
        "exact",
        "gridplanes",
        "sampled:1",
        "sampled:0.001",
        "sampled:1000",
        "sampled:0.25"
      })
  void aCollisionMethodIsWrittenAsItIsRead(String text) {
    assertEquals(text, CollisionChoice.parse(text).orElseThrow().toString());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "Exact",
        "sampled",
        "sampled:",
        "sampled:0",
        "sampled:0.0009",
        "sampled:1000.5",
        "sampled:NaN",
        "sampled:-1",
        "gridplanes:1"
      })
  void anotherCollisionMethodIsNotRead(String text) {
    assertEquals(Optional.empty(), CollisionChoice.parse(text));
  }

  @ParameterizedTest
  @EnumSource(SolverKind.class)
  void aSolverIsFoundByItsName(SolverKind kind) {
    assertEquals(Optional.of(kind), SolverKind.parse(kind.toString()));
    assertEquals(Optional.empty(), SolverKind.parse(kind.name()));
    boolean isBaseline = kind == SolverKind.DOT || kind == SolverKind.PAPER;
    assertEquals(isBaseline, kind.usesBorderVoxels());
    assertEquals(isBaseline || kind == SolverKind.NONE, kind.choosesCollision());
    assertEquals(
        isBaseline ? CollisionChoice.sampled(1) : CollisionChoice.EXACT, kind.defaultCollision());
  }

  @Test
  void aMaterialTakesEachPartOnceInAnyOrder() {
    MaterialOverride all =
        MaterialOverride.parse("cut:0.5,damping:0.001,sliding:0.2,friction:0.3,stiffness:0.8")
            .orElseThrow();
    assertEquals(
        Map.of("stiffness", 0.8, "friction", 0.3, "sliding", 0.2, "damping", 0.001, "cut", 0.5),
        all.values());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "stiffness:0",
        "stiffness:1e-6",
        "stiffness:1e6",
        "friction:100",
        "sliding:100",
        "damping:1e6",
        "cut:1e6",
        "friction:0.2,sliding:0.2"
      })
  void theEndsOfEachRangeAreAllowed(String text) {
    assertTrue(MaterialOverride.parse(text).isPresent());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "0.8",
        "stiffness",
        "stiffness:9e-7",
        "stiffness:1.1e6",
        "friction:100.5",
        "friction:-0.1",
        "sliding:101",
        "damping:1.1e6",
        "cut:NaN",
        "weight:1",
        "stiffness:1,stiffness:2",
        "friction:0.2,sliding:0.3",
        "stiffness:1,",
        ":1"
      })
  void anotherMaterialIsNotRead(String text) {
    assertEquals(Optional.empty(), MaterialOverride.parse(text));
  }

  @Test
  void whatAMaterialDoesNotSayIsTheGeneralOne() {
    Material general = new Material(0.5, 0.4, 0.2, 0.003);
    Material stiff = material("stiffness:2").over(general, FrictionForm.CONE);
    assertEquals(2, stiff.stiffnessNewtonPerMm());
    assertEquals(0.4, stiff.staticFriction());
    assertEquals(0.4 * FrictionForm.CONE.slidingFraction(), stiff.slidingFriction(), 1e-15);
    assertEquals(0.003, stiff.dampingNewtonSecondPerMm());
    Material damped = material("damping:0.01").over(general, FrictionForm.CONE);
    assertEquals(0.01, damped.dampingNewtonSecondPerMm());
    assertEquals(0.5, damped.stiffnessNewtonPerMm());
    Material rough = material("friction:0.9").over(general, FrictionForm.EQUATION_4);
    assertEquals(0.9, rough.staticFriction());
    assertEquals(0.9 * FrictionForm.EQUATION_4.slidingFraction(), rough.slidingFriction(), 1e-15);
    Material slides = material("sliding:0.6").over(general, FrictionForm.CONE);
    assertEquals(0.6, slides.slidingFriction());
    assertEquals(0.6, slides.staticFriction(), "static friction is never less");
  }

  private static MaterialOverride material(String text) {
    return MaterialOverride.parse(text).orElseThrow();
  }

  @ParameterizedTest
  @CsvSource({
    "simulated, simulated, ''",
    "simulated:7, simulated, 7",
    "virtuose:10.0.0.1:4000, virtuose, 10.0.0.1:4000",
    "replay:C:/t.csv, replay, C:/t.csv",
    "'', '', ''"
  })
  void aDeviceIsDividedAtItsFirstColon(String text, String name, String id) {
    DeviceName parsed = DeviceName.parse(text);
    assertEquals(new DeviceName(name, id), parsed);
    assertEquals(text, parsed.toString());
  }

  @Test
  void onlyRealDevicesAreHeldByAHand() {
    assertTrue(DeviceName.parse("hid").isReal() && DeviceName.parse("hid").isKnown());
    assertTrue(DeviceName.parse("banana").isReal());
    assertFalse(DeviceName.parse("banana").isKnown());
    for (String text : new String[] {"simulated:3", "mouse", "replay:t.csv"}) {
      assertFalse(DeviceName.parse(text).isReal(), text);
      assertTrue(DeviceName.parse(text).isKnown(), text);
    }
    assertEquals("replay:a/t.csv", DeviceName.ofReplay(Path.of("a/t.csv")).toString());
  }

  @Test
  void aSeedIsAWholeNumber() {
    assertEquals(1, DeviceName.parse("simulated").seed());
    assertEquals(-7, DeviceName.parse("simulated:-7").seed());
    assertThrows(NumberFormatException.class, () -> DeviceName.parse("simulated:x").seed());
  }
}
