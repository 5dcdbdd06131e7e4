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
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.force.MassSettings;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.tool.ClearanceChoice;
import org.palpate.tool.ToolRequest;
import org.palpate.tool.ToolSpec;
import picocli.CommandLine;
import picocli.CommandLine.ParseResult;

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

  @Test
  void aPointMayHaveAMassAndGravity() {
    assertEquals(Optional.empty(), options().massOfHeld());
    MassSettings mass = options("--mass=0.05", "--gravity=0,-9.81,1").massOfHeld().orElseThrow();
    assertEquals(0.05, mass.kg());
    assertEquals("(0.0, -9810.0, 1000.0)", mass.gravityMmPerSecond2().toString());
    assertEquals(
        Optional.of(mass).toString(),
        options("--mass=0.05", "--gravity=0,-9.81,1").feel().mass().toString());
    assertEquals(List.of(), options("--mass=0.05").feel().effects());
    assertEquals(0, options("--mass=0.05").massOfHeld().orElseThrow().gravityMmPerSecond2().y);
  }

  @ParameterizedTest
  @ValueSource(strings = {"0,0", "0,0,NaN", "0,0,100.1", "60,60,60", "0,0,0,0", "", "down"})
  void gravityIsThreeNumbersOfAtMostAHundred(String text) {
    Given.refuses(
        "gravity must be three numbers, together at most 100 m/s^2: --gravity "
            + text
            + ": try --gravity 0,0,-9.81",
        () -> options("--mass=1", "--gravity=" + text).massOfHeld());
    assertTrue(options("--mass=1", "--gravity=0,0,-100").massOfHeld().isPresent());
  }

  @Test
  void gravityNeedsAMass() {
    Given.refuses(
        "gravity needs a mass: --gravity 0,0,-9.81: add --mass 0.05",
        () -> options("--gravity=0,0,-9.81").massOfHeld());
  }

  @Test
  void numbersHaveRanges() throws Exception {
    assertEquals(OptionalDouble.of(1e-6), options("--mass=1e-6").massKg());
    assertEquals(OptionalDouble.of(7), options("--rotational-stiffness=7").rotationalStiffness());
    Given.refuses(
        "the mass must be a number from 0.000001 to 1,000,000 kg: --mass 0: try --mass 0.05 for 50"
            + " g",
        () -> check("--mass=0"));
    Given.refuses(
        "the rotational stiffness must be a number from 0.000001 to 1,000,000 N mm/rad:"
            + " --rotational-stiffness -1: try --rotational-stiffness 1",
        () -> check("--tool=sphere:2", "--rotational-stiffness=-1"));
  }

  /** Checks options as a command does that has the options of contact too. */
  private static void check(String... arguments) throws VolumeFormatException {
    ToolOptions tool = new ToolOptions();
    CommandLine command = new CommandLine(new ContactOptions());
    command.addMixin("tool", tool);
    command.addMixin("elastic", new ElasticOptions());
    ParseResult given = command.parseArgs(arguments);
    tool.checkOthers(given);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "--solver=guarded",
        "--collision=exact",
        "--border=on-the-fly",
        "--friction-form=cone",
        "--fixed=base",
        "--lattice=2"
      })
  void someOptionsAreForAPointAlone(String option) throws VolumeFormatException {
    check(option);
    String name = option.substring(0, option.indexOf('='));
    Given.refuses(
        "this option is for a point alone: "
            + name
            + " with --tool sphere:2: leave one of them out",
        () -> check("--tool=sphere:2", option));
  }

  @Test
  void othersAreForARigidToolAlone() throws VolumeFormatException {
    check("--tool=sphere:2", "--rotational-stiffness=3");
    Given.refuses(
        "this option is for a rigid tool alone: --rotational-stiffness with --tool point: leave one"
            + " of them out",
        () -> check("--rotational-stiffness=3"));
    Given.refuses(
        "this option is for a rigid tool alone: --clearance with --tool point: leave one of them"
            + " out",
        () -> check("--clearance=body"));
  }

  @Test
  void aPointAmongBodiesThatHavePosesIsARigidTool() throws VolumeFormatException {
    assertFalse(options().isRigid());
    assertTrue(options("--tool=sphere:2").isRigid());
    VolumeOptions broken = Given.options(new VolumeOptions(), "--phantom=fracture:64:2");
    ToolOptions point = taken(broken, "--clearance=body");
    assertTrue(point.isRigid());
    assertInstanceOf(ToolSpec.Point.class, point.request().spec());
    assertEquals(Optional.of(ClearanceChoice.BODY), point.request().clearance());
  }

  private static ToolOptions taken(VolumeOptions volume, String... arguments)
      throws VolumeFormatException {
    ToolOptions tool = new ToolOptions();
    tool.takeFrom(volume, new CommandLine(tool).parseArgs(arguments));
    return tool;
  }

  @Test
  void aSceneNamesItsToolRelativeToItself(@TempDir Path folder) throws IOException {
    Path scene = folder.resolve("s.json");
    Files.writeString(
        scene,
        """
        { "bodies": [ { "name": "a", "volume": "a.nrrd" } ],
          "tool": { "spec": "probe.nrrd", "segment": "t=>=3", "clearance": "-0.5",
                    "mass_kg": 0.2 } }
        """);
    VolumeOptions volume = Given.options(new VolumeOptions(), "--scene=" + scene);
    ToolOptions tool = taken(volume);
    assertEquals(new ToolSpec.VolumeFile(folder.resolve("probe.nrrd")), tool.request().spec());
    assertEquals("t", tool.request().segment().orElseThrow().name());
    assertEquals(Optional.of(new ClearanceChoice(true, -0.5)), tool.request().clearance());
    assertEquals(OptionalDouble.of(0.2), tool.massKg());
    assertEquals(
        Optional.of(ClearanceChoice.BODY), taken(volume, "--clearance=body").request().clearance());
    for (String option : List.of("--tool=point", "--tool-segment=a=>=1", "--mass=1")) {
      Given.refuses(
          "the scene names the tool: "
              + option.substring(0, option.indexOf('='))
              + " with --scene: change the key tool of the scene",
          () -> taken(volume, option));
    }
  }

  private static ToolOptions options(String... arguments) {
    return Given.options(new ToolOptions(), arguments);
  }

  private static ToolRequest request(String... arguments) throws VolumeFormatException {
    return options(arguments).request();
  }
}
