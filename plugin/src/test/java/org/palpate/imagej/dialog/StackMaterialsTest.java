package org.palpate.imagej.dialog;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.palpate.elastic.lattice.ElasticMaterial;
import org.palpate.host.MaterialOverride;
import org.palpate.imagej.stack.TouchRefusedException;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;

class StackMaterialsTest {
  @Test
  void parsesTheFormOfTheCommandLineForEachSegment() throws TouchRefusedException {
    StackMaterials read =
        StackMaterials.parse(" bone=stiffness:0.8, friction:0.3; left eye=damping:0.001 ;");
    assertEquals(
        Map.of(
            "bone", material("stiffness:0.8,friction:0.3"), "left eye", material("damping:0.001")),
        read.choices());
  }

  @Test
  void aSegmentMayBeElasticWithOrWithoutAnotherMaterial() throws TouchRefusedException {
    StackMaterials read =
        StackMaterials.parse("skin=young:20e3, friction:0.3,poisson:0.3; fat=young:1e4");
    assertEquals(
        Map.of("skin", new ElasticMaterial(20e3, 0.3), "fat", new ElasticMaterial(1e4, 0.4)),
        read.elastic());
    assertEquals(
        Map.of("skin", material("friction:0.3"), "fat", MaterialOverride.NONE), read.choices());
  }

  @Test
  void aNameMayContainAnEqualsSign() throws TouchRefusedException {
    assertEquals(
        Map.of("CT = 3", material("friction:0")),
        StackMaterials.parse("CT = 3=friction:0").choices());
  }

  @Test
  void aBlankTextHasNoMaterials() throws TouchRefusedException {
    assertEquals(Map.of(), StackMaterials.parse("  ").choices());
  }

  @Test
  void refusesWrongMaterials() {
    for (String text :
        List.of(
            "bone",
            "=friction:1",
            "bone=",
            "bone=hardness:1",
            "bone=friction:-1",
            "a=b=c",
            "a=poisson:0.3",
            "a=young:1")) {
      assertTrue(refusal(text).contains("is not a material: write for example"), text);
    }
    assertTrue(refusal("a=friction:1;a=friction:2").contains("two materials for the segment"));
  }

  @Test
  void refusesAMaterialThatOnlyANeedleHas() {
    assertTrue(refusal("skin=puncture:1,shaft:0.1").contains("leave puncture, cutting and shaft"));
  }

  @Test
  void refusesAMaterialOfAnUnknownSegment() throws TouchRefusedException {
    List<Segment> segments = List.of(segment("bone"), segment("skin"));
    StackMaterials.parse("skin=friction:1").checkNamed(segments);
    StackMaterials other = StackMaterials.parse("skull=friction:1");
    String message =
        assertThrows(TouchRefusedException.class, () -> other.checkNamed(segments)).getMessage();
    assertTrue(message.contains("\"skull\"") && message.contains("bone, skin"), message);
  }

  private static MaterialOverride material(String text) {
    return MaterialOverride.parse(text).orElseThrow();
  }

  private static String refusal(String text) {
    return assertThrows(TouchRefusedException.class, () -> StackMaterials.parse(text)).getMessage();
  }

  private static Segment segment(String name) {
    return new Segment(name, new BitCube(4, 4, 4), 0);
  }
}
