package org.palpate.app.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.device.DeviceState;
import org.palpate.device.HandTarget;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.geometry.Vec3;
import org.palpate.host.MouseDevice;
import org.palpate.io.table.CsvFormatException;
import org.palpate.io.volume.CoordinateSystem;

class DeviceNamesTest {
  private static final long MS = 1_000_000;
  private static final HandTarget TARGET =
      HandTarget.ofBox(new Vec3(0, 0, 0), new Vec3(40, 40, 40), 1);
  private static final String FORMS =
      "write simulated[:SEED], replay:T.csv, hid[:SERIAL], openhaptics[:NAME],"
          + " forcedimension[:SERIAL], virtuose:HOST or mouse";

  @TempDir private Path folder;

  @ParameterizedTest
  @ValueSource(
      strings = {
        "simulated",
        "simulated:-7",
        "mouse",
        "replay:t.csv",
        "hid",
        "hid:A1",
        "openhaptics:Left",
        "forcedimension",
        "virtuose:10.0.0.1:4000"
      })
  void eachFormOfADeviceIsKeptAsItWasWritten(String text) {
    assertEquals(text, DeviceChoice.parse(text).toString());
  }

  @ParameterizedTest
  @CsvSource({
    "banana, there is no such device",
    "'', there is no such device",
    "Simulated, there is no such device",
    "replay, this device needs an id after a colon",
    "virtuose, this device needs an id after a colon",
    "simulated:x, the seed is not a whole number",
    "simulated:1.5, the seed is not a whole number"
  })
  void anotherTextIsRefusedWithTheForms(String text, String what) {
    Given.refuses(what + ": --device " + text + ": " + FORMS, () -> DeviceChoice.parse(text));
  }

  @Test
  void onlyTheWorkspaceOfARealDeviceIsFitted() {
    DeviceChoice real = DeviceChoice.parse("hid").withFit(true, true);
    assertTrue(real.fitEachAxis() && real.axesOfView());
    DeviceChoice simulated = DeviceChoice.parse("simulated");
    assertEquals(simulated, simulated.withFit(false, false));
    Given.refuses(
        "only the workspace of a real device can be fitted: --fit-each-axis --device simulated:"
            + " leave it out, or choose hid, openhaptics, forcedimension or virtuose",
        () -> simulated.withFit(true, false));
    Given.refuses(
        "only the workspace of a real device can be fitted: --axes view --device mouse: leave it"
            + " out, or choose hid, openhaptics, forcedimension or virtuose",
        () -> DeviceChoice.parse("mouse").withFit(false, true));
  }

  @Test
  void aReplayEndsTheSessionAndReadsAFile() {
    DeviceChoice replay = DeviceChoice.parse("replay:a/t.csv");
    assertTrue(replay.ends());
    assertEquals(List.of(Path.of("a/t.csv")), replay.files());
    assertFalse(DeviceChoice.parse("simulated").ends());
    assertEquals(List.of(), DeviceChoice.parse("hid:t.csv").files());
  }

  @Test
  void aReplayGivesThePositionsOfItsFile() throws IOException {
    Path file = folder.resolve("t.csv");
    Files.writeString(file, "t_ms,x,y,z\n0,1,2,3\n1,4,5,6\n");
    try (HapticDevice device = open("replay:" + file, false)) {
      DeviceState state = new DeviceState();
      assertEquals(ReadStatus.FRESH, device.read(state));
      assertEquals("(1.0, 2.0, 3.0)", state.positionMm.toString());
      assertEquals(ReadStatus.FRESH, device.read(state));
      assertEquals("(4.0, 5.0, 6.0)", state.positionMm.toString());
      assertEquals(ReadStatus.DISCONNECTED, device.read(state));
    }
    assertThrows(CsvFormatException.class, () -> open("replay:" + folder.resolve("none"), false));
  }

  private static HapticDevice open(String text, boolean forTool) throws IOException {
    return DeviceChoice.parse(text).open(TARGET, CoordinateSystem.LPS, MS, forTool);
  }

  @Test
  void aSimulatedHandTurnsForAToolAlone() throws IOException {
    try (HapticDevice point = open("simulated:3", false);
        HapticDevice tool = open("simulated:3", true)) {
      assertFalse(turns(point));
      assertTrue(turns(tool));
    }
  }

  private static boolean turns(HapticDevice device) {
    DeviceState state = new DeviceState();
    boolean turns = false;
    for (int n = 0; n < 500; n++) {
      device.read(state);
      turns |= Math.abs(state.orientation.w) < 0.9999;
    }
    return turns;
  }

  @Test
  void aSeedRepeatsAHandAndAnotherDoesNot() throws IOException {
    assertEquals(path("simulated:3"), path("simulated:3"));
    assertEquals(path("simulated"), path("simulated:1"), "seed 1 is the default");
    assertFalse(path("simulated:3").equals(path("simulated:4")));
  }

  private static String path(String text) throws IOException {
    StringBuilder path = new StringBuilder();
    try (HapticDevice device = open(text, false)) {
      DeviceState state = new DeviceState();
      for (int n = 0; n < 50; n++) {
        device.read(state);
        path.append(state.positionMm);
      }
    }
    return path.toString();
  }

  @Test
  void theMouseIsADeviceOfItsOwn() throws IOException {
    try (HapticDevice mouse = open("mouse", true)) {
      assertInstanceOf(MouseDevice.class, mouse);
    }
  }
}
