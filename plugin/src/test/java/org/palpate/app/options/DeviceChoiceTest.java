package org.palpate.app.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.app.process.PalpateException;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.HandTarget;
import org.palpate.device.Workspace;
import org.palpate.geometry.Vec3;
import org.palpate.io.scene.SceneDevice;
import org.palpate.io.volume.CoordinateSystem;
import picocli.CommandLine;

class DeviceChoiceTest {
  private static final DeviceSpecification OMNI =
      new DeviceSpecification("Omni", "1", 3.3, 0.5, 80, 1_000_000);

  /** A box of 40 x 80 x 20 mm about (10, 20, 30). */
  private static final HandTarget TARGET =
      HandTarget.ofBox(new Vec3(-10, -20, 20), new Vec3(30, 60, 40), 1);

  @TempDir private Path folder;

  private static Workspace mapped(OptionalDouble scale, Optional<Vec3> offset) {
    SceneDevice ofScene = new SceneDevice(scale, Optional.empty(), offset);
    return DeviceChoice.parse("hid")
        .mappedAs(Optional.of(ofScene))
        .workspace(OMNI, TARGET, CoordinateSystem.LPS);
  }

  private static void assertAt(Vec3 expected, Workspace workspace, Vec3 deviceMm) {
    Vec3 found = workspace.toWorld(deviceMm, new Vec3());
    assertEquals(0, found.sub(expected, found).length(), 1e-12);
  }

  @Test
  void aSceneGivesScaleAndPositionOfTheWorkspace() {
    Workspace both = mapped(OptionalDouble.of(2), Optional.of(new Vec3(1, 2, 3)));
    assertAt(new Vec3(1, 2, 3), both, new Vec3());
    // The hand's right is the patient's left, up is the head, and towards the person is anterior.
    assertAt(new Vec3(21, 2, 3), both, new Vec3(10, 0, 0));
    assertAt(new Vec3(1, 2, 23), both, new Vec3(0, 10, 0));
    assertAt(new Vec3(1, -18, 3), both, new Vec3(0, 0, 10));
  }

  @Test
  void whatASceneDoesNotGiveIsFitted() {
    assertAt(new Vec3(10, 20, 30), mapped(OptionalDouble.of(2), Optional.empty()), new Vec3());
    Workspace moved = mapped(OptionalDouble.empty(), Optional.of(new Vec3(1, 2, 3)));
    assertAt(new Vec3(6, 2, 3), moved, new Vec3(10, 0, 0)); // 80 mm fit 160 mm of the device
  }

  @Test
  void anOptionReplacesTheAxesOfTheScene() throws Exception {
    String body = "{\"bodies\": [{\"name\": \"a\", \"volume\": \"v.nrrd\"}], ";
    Path scene =
        Files.writeString(folder.resolve("s.json"), body + "\"device\": {\"axes\": \"view\"}}");
    assertTrue(
        mapping(scene).applyTo(DeviceChoice.parse("hid"), CoordinateSystem.LPS).axesOfView());
    assertEquals(
        false,
        mapping(scene, "--axes", "patient")
            .applyTo(DeviceChoice.parse("hid"), CoordinateSystem.LPS)
            .axesOfView());
    DeviceChoice simulated = DeviceChoice.parse("simulated");
    assertEquals(false, mapping(scene).applyTo(simulated, CoordinateSystem.LPS).axesOfView());
    assertThrows(
        PalpateException.class,
        () -> mapping(scene, "--axes", "view").applyTo(simulated, CoordinateSystem.LPS));
    assertThrows(
        PalpateException.class,
        () -> mapping(scene).applyTo(DeviceChoice.parse("hid"), CoordinateSystem.LAS));
  }

  private static MappingOptions mapping(Path scene, String... arguments) throws Exception {
    MappingOptions options = new MappingOptions();
    new CommandLine(options).setCaseInsensitiveEnumValuesAllowed(true).parseArgs(arguments);
    options.takeFrom(CommandLine.populateCommand(new VolumeOptions(), "--scene", scene.toString()));
    return options;
  }
}
