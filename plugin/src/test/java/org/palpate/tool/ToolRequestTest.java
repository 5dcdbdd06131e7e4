package org.palpate.tool;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.rigid.tool.BoxShape;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolShape;

class ToolRequestTest {

  @Test
  void readsEveryShape() throws Exception {
    assertEquals(RodShape.sphere(4), shape("sphere:4"));
    assertEquals(RodShape.capsule(2, 9.5), shape("capsule:2,9.5"));
    assertEquals(RodShape.cylinder(1e-2, 3), shape(" cylinder:1e-2, 3 "));
    assertEquals(RodShape.needle(0.5, 40), shape("needle:0.5,40"));
    assertEquals(new BoxShape(1, 2, 3), shape("box:1,2,3"));
    assertInstanceOf(ToolSpec.Point.class, ToolSpec.parse("point"));
  }

  private static ToolShape shape(String text) throws VolumeFormatException {
    return ((ToolSpec.Shape) ToolSpec.parse(text)).shape();
  }

  @Test
  void aNameWithADotOrASlashIsAFile() throws Exception {
    assertInstanceOf(ToolSpec.VolumeFile.class, ToolSpec.parse("fragment.nrrd"));
    assertInstanceOf(ToolSpec.VolumeFile.class, ToolSpec.parse("scans/folder"));
    assertInstanceOf(ToolSpec.MeshFile.class, ToolSpec.parse("plate.STL"));
    assertInstanceOf(ToolSpec.MeshFile.class, ToolSpec.parse("a/plate.obj"));
    assertInstanceOf(ToolSpec.VolumeFile.class, ToolSpec.parse("sphere.nii.gz"));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "sphere",
        "sphere:",
        "sphere:0",
        "sphere:-1",
        "sphere:NaN",
        "sphere:inf",
        "sphere:1e7",
        "sphere:4mm",
        "sphere:4,5",
        "capsule:2",
        "capsule:2,0",
        "capsule:2,NaN",
        "box:1,2",
        "box:1,2,3,4",
        "box:1,2,0",
        "cylinder:,",
        "needle:1,-3",
        "ball:4",
        "hammer",
        "sphere:0x4"
      })
  void otherTextsAreRefusedInOneLineThatShowsThem(String text) {
    String line = refusal(() -> ToolRequest.parse(text, null, null, null));
    assertTrue(line.contains("--tool " + text), line);
  }

  @Test
  void readsClearances() throws Exception {
    assertEquals(ClearanceChoice.POINTS, ClearanceChoice.parse("points"));
    assertEquals(ClearanceChoice.BODY, ClearanceChoice.parse("body"));
    assertEquals(new ClearanceChoice(true, -0.5), ClearanceChoice.parse("-0.5"));
    assertEquals(new ClearanceChoice(true, 2), ClearanceChoice.parse("2"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "Body", "whole", "1mm", "NaN", "inf", "1e9"})
  void otherClearancesAreRefused(String text) {
    String line = refusal(() -> ToolRequest.parse("sphere:4", null, null, text));
    assertTrue(line.contains("--clearance " + text), line);
  }

  @Test
  void optionsThatDoNotFitEachOtherAreRefused() {
    refusal(() -> ToolRequest.parse("point", null, 10, null));
    refusal(() -> ToolRequest.parse("point", "tool=nonzero", null, null));
    refusal(() -> ToolRequest.parse("sphere:4", "tool=nonzero", null, null));
    refusal(() -> ToolRequest.parse("sphere:4", null, 0, null));
    refusal(() -> ToolRequest.parse("sphere:4", null, -3, null));
    refusal(() -> ToolRequest.parse("sphere:4", null, 10, "body"));
    refusal(() -> ToolRequest.parse("sphere:4", null, 10, "-1"));
    refusal(() -> ToolRequest.parse("a.nrrd", "nonzero", null, null));
  }

  private interface Parse {
    void run() throws VolumeFormatException;
  }

  private static String refusal(Parse parse) {
    String line = assertThrows(VolumeFormatException.class, parse::run).getMessage();
    assertEquals(1, line.lines().count(), line);
    assertTrue(line.split(": ").length >= 3, "WHAT: WHERE: what to do, but was " + line);
    return line;
  }
}
