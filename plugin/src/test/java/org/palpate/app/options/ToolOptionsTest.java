package org.palpate.app.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.tool.ClearanceChoice;
import org.palpate.tool.ToolRequest;
import org.palpate.tool.ToolSpec;
import picocli.CommandLine;

class ToolOptionsTest {
  @Test
  void withoutOptionsTheToolIsAPoint() throws Exception {
    assertInstanceOf(ToolSpec.Point.class, request().spec());
  }

  @Test
  void aMarginMayBeNegative() throws Exception {
    ToolRequest apart = request("--tool", "sphere:4", "--clearance", "-0.5");
    assertEquals(Optional.of(new ClearanceChoice(true, -0.5)), apart.clearance());
    ToolRequest joined = request("--tool=sphere:4", "--clearance=-0.5");
    assertEquals(apart, joined);
  }

  @Test
  void everyOptionArrives() throws Exception {
    ToolRequest request =
        request(
            "--tool",
            "a.nrrd",
            "--tool-segment",
            "jaw=label:7",
            "--points",
            "200",
            "--clearance",
            "points");
    assertInstanceOf(ToolSpec.VolumeFile.class, request.spec());
    assertEquals("jaw", request.segment().orElseThrow().name());
    assertEquals(OptionalInt.of(200), request.points());
    assertEquals(Optional.of(ClearanceChoice.POINTS), request.clearance());
    assertThrows(VolumeFormatException.class, () -> request("--tool", "ball:4"));
  }

  private static ToolRequest request(String... arguments) throws VolumeFormatException {
    return CommandLine.populateCommand(new ToolOptions(), arguments).request();
  }
}
